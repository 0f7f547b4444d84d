// SPDX-License-Identifier: Apache-2.0
// Stress family B, second part: how the eye sees. Lights in special places of the view, grazing views, extreme lenses
// and pictures, mirrored and stretched nodes, orthographic cameras, casters that are not in view.
#include <fmt/format.h>

#include "stress/parts.h"
#include "stress/stress.h"

namespace generator::stress {
namespace {

using Fill = std::function<void(Document&)>;

std::string stageLamp() {
    return pointLight("Lamp", "[-4, 8, 6]", 9);
}
std::string stageEye() {
    return eye("[4, 5.5, 11]", "[0, 1.75, -0.5]");
}

std::vector<Case> lightInView() {
    const auto shot = [](const char* light, double reach) {
        return sequence(
            {.camera = eye("[0, 3, 9]", "[0, 3, 0]", 60, 0.5), .lights = {pointLight("Lamp", light, reach)}});
    };
    return {
        {"B7-1", "the light behind the eye, on its axis", "the shadows that rays find",
         "the light's image in the middle of the picture, scissors around volumes", addStage, shot("[0, 3, 14]", 14)},
        {"B7-2", "the light exactly in the eye's plane: its w is 0", "the shadows that rays find",
         "divisions by the light's w, a view from the light that has no projection", addStage, shot("[-5, 7, 9]", 11)},
        {"B7-3", "the light exactly in the near plane and in view", "the shadows that rays find",
         "the light's own depth, near caps without size", addStage, shot("[-0.125, 3.125, 8.5]", 9)}};
}

std::vector<Case> grazing() {
    const Fill mites = [](Document& document) {
        addStage(document);
        const int material = paint(document, "Mites", {0.3, 0.5, 0.75});
        place(document, "Mite", box({-0.0004, 0, 8.9988}, {-0.0002, 0.0003, 8.9990}), material);
        place(document, "Flea", icosphere({0.0003, 0.0003, 8.9982}, 0.0001, 1), material);
    };
    const char* catches = "depth that runs out of bits where the ground is seen edge-on";
    return {{"B8-1", "the eye 1e-4 above the ground, looking along it; casters of such sizes before it",
             "the shadows that rays find", catches, mites,
             sequence({.camera = eye("[0, 0.0001, 9]", "[0, 0.0001, 0]", 45, 1e-5),
                       .lights = {pointLight("Lamp", "[-4, 3, 14]", 7)}})},
            {"B8-2", "an eye 1e-4 above the ground with a lens of 0.02 degrees: 16 m of ground in view",
             "the shadows that rays find", catches, addStage,
             sequence({.camera = eye("[3.25, 0.0001, 9]", "[3.25, 0.0001, 0]", 0.02), .lights = {stageLamp()}})}};
}

std::vector<Case> lensesAndPictures() {
    const auto shot = [](const std::string& camera, int width, int height) {
        return sequence({.camera = camera, .lights = {stageLamp()}, .width = width, .height = height});
    };
    const char* answer = "the shadows that rays find";
    const char* borders = "tiles and scissors at the picture's borders";
    return {{"B9-1", "a field of view of 170 degrees", answer,
             "clipping far outside the picture, fixed point that runs over", addStage,
             shot(eye("[-0.25, 1.25, 1.75]", "[0.25, 1.25, -3]", 170), 256, 192)},
            {"B9-2", "a field of view of 0.1 degrees, 4 km away", answer,
             "volumes larger than the picture by orders of magnitude", addStage,
             shot(eye("[1500, 2000, 3200]", "[0.5, 1, 0.5]", 0.1, 1), 256, 192)},
            {"B9-3", "a picture of one pixel", "that pixel is in shadow", borders, addStage,
             shot(eye("[4, 5.5, 11]", "[2, 0, -2.5]"), 1, 1)},
            {"B9-4", "a picture of 17 x 13 pixels", answer, borders, addStage, shot(stageEye(), 17, 13)},
            {"B9-5", "a picture of 8191 x 3 pixels", answer, borders, addStage,
             shot(eye("[4, 5.5, 11]", "[0, 0.5, -0.5]", 0.05), 8191, 3)},
            {"B9-6", "a picture of 61 x 409 pixels", answer, borders, addStage, shot(stageEye(), 61, 409)}};
}

/// The stage's ground, and a torus and a tetrahedron below one node.
Fill below(const dmat4& matrix, const dmat4& inner = dmat4(1)) {
    return [=](Document& document) {
        addGround(document, 20);
        const int material = paint(document, "Casters", kCasterColor);
        const int ring = document.mesh("Ring", {partOf(torus(2, 0.5, 32, 12), material)});
        const int stone = document.mesh("Stone", {partOf(oddTetrahedron(), material)});
        const int parent = document.node({.name = "Parent", .matrix = matrix});
        document.node({.name = "Ring", .parent = parent, .mesh = ring, .matrix = inner});
        document.node({.name = "Stone", .parent = parent, .translation = {3.25, -2.5, -1}, .mesh = stone});
    };
}

dmat4 shifted(dmat4 matrix, const dvec3& translation) {
    matrix[3] = glm::dvec4(translation, 1);
    return matrix;
}

dmat4 stretched(const dvec3& scale) {
    return {scale.x, 0, 0, 0, 0, scale.y, 0, 0, 0, 0, scale.z, 0, 0, 0, 0, 1};
}

/// The matrix of a camera at `position`; mirrored: its x axis points left.
dmat4 cameraMatrix(const dvec3& position, const dvec3& target, bool mirrored) {
    dmat4 matrix(glm::mat3_cast(lookAt(position, target)));
    if (mirrored) matrix[0] = -matrix[0];
    return shifted(matrix, position);
}

std::vector<Case> mirrors() {
    const dmat4 tilt = shifted(dmat4(oddRotation()), {0, 1, 0});
    const std::string shot =
        sequence({.camera = eye("[3, 7, 11]", "[0, 1, 0]"), .lights = {pointLight("Lamp", "[-5, 9, 6]", 10)}});
    const char* answer = "the same as of meshes that were placed so in their vertices";
    const char* catches = "fronts taken for backs where the determinant is negative";
    return {
        {"B10-1", "casters below a node that mirrors x", answer, catches,
         below(shifted(stretched({-1, 1, 1}), {2, 2, 0}), tilt), shot},
        {"B10-2", "casters below a node that stretches a turned one: shear", answer,
         "normals and planes moved like points", below(shifted(stretched({1.5, 0.625, 0.75}), {-2, 2, 0}), tilt), shot},
        {"B10-3", "casters below a node that mirrors, stretches and turns", answer, catches,
         below(shifted(dmat4(oddRotation()) * stretched({1.25, -0.75, 0.875}), {-2, 3, 0}), tilt), shot},
        {"B10-4", "a camera of the glTF file below whose node x is mirrored",
         "the picture of a camera without the mirror, which glTF lets cameras ignore",
         "fronts taken for backs by a view that mirrors",
         [](Document& document) {
             addStage(document);
             document.node({.name = "Mirrored",
                            .camera = document.camera("Mirrored", 45, 0.05),
                            .matrix = cameraMatrix({4, 5.5, 11}, {0, 1.75, -0.5}, true)});
         },
         sequence({.camera = "/Mirrored", .lights = {stageLamp()}})}};
}

/// Ground and casters seen by an orthographic camera of the file along `view`, and a sun along `light`.
Fill parallelView(const dvec3& position, const dvec3& view, const dvec3& light) {
    return [=](Document& document) {
        addGround(document, 20);
        addCasters(document);
        const dvec3 other = std::abs(view.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, -1);
        const dvec3 right = glm::normalize(glm::cross(view, other));
        const dmat4 matrix(dmat3(right, glm::cross(right, view), -view));
        document.node({.name = "Parallel",
                       .camera = document.orthographicCamera("Parallel", {6, 4.5}, 0.125, 40),
                       .matrix = shifted(matrix, position)});
        addSun(document, "Sun", light);
    };
}

std::vector<Case> orthographic() {
    const std::string oblique = orthographicEye("[5, 7, 10]", "[0, 1.5, -0.5]", 5, 0.125, 40);
    const std::string ofFile = sequence({.camera = "/Parallel"});
    const auto lit = [](const std::string& camera, const std::vector<std::string>& lights) {
        return sequence({.camera = camera, .lights = lights});
    };
    const dvec3 down(0, -1, 0), slanting(-3.0 / 7, -6.0 / 7, -2.0 / 7);
    const char* answer = "the picture of a perspective camera very far away";
    const char* catches = "dark caps at infinity that cover nothing, counts without a constant for each light";
    const char* behind = "the shadow of what is behind the camera is there";
    const std::string close = orthographicEye("[2.5, 4, 3]", "[0, 0.5, -2]", 4, 0.125, 40);
    return {
        {"B11-1", "an oblique orthographic camera, a point light and a sun", answer, catches, addStage,
         lit(oblique, {stageLamp(), sun("Sun", "[6, 8, 3]", "[0, 0, 0]")})},
        {"B11-2", "an orthographic camera that looks straight down, a slanting sun", answer, catches,
         parallelView({0, 12, 0}, down, slanting), ofFile},
        {"B11-3", "an orthographic camera and a sun, both exactly straight down", "no shadow is visible",
         "a constant that does not exist where light and view are parallel", parallelView({0, 12, 0}, down, down),
         ofFile},
        {"B11-4", "an orthographic camera and a sun, both exactly along the same slanting way", "no shadow is visible",
         "a constant that does not exist where light and view are parallel",
         parallelView(-12.0 * slanting, slanting, slanting), ofFile},
        {"B11-5", "the same, but the sun 1e-7 off the view", "no shadow is wider than a fraction of a pixel",
         "a threshold for parallel that is too wide",
         parallelView(-12.0 * slanting, slanting, glm::normalize(slanting + dvec3(0, 0, 1e-7))), ofFile},
        {"B11-6", "an orthographic camera and a sun that shines towards it", "the shadows fall towards the viewer",
         "volumes that end behind the camera", parallelView({0, 4, 12}, {0, -0.28, -0.96}, {0.36, -0.48, 0.8}), ofFile},
        {"B11-7", "an orthographic camera among the casters: some are behind it, one is cut by its near plane", behind,
         "casters behind the camera left out of the count", addStage,
         lit(close, {pointLight("Lamp", "[4, 9, 9]", 11), sun("Sun", "[3, 8, 6]", "[0, 0, 0]")})},
        {"B11-8", "an orthographic camera with all casters behind it", behind,
         "casters behind the camera left out of the count", addStage,
         lit(orthographicEye("[0, 3.5, -3]", "[0, 2.5, -7]", 4, 0.125, 40),
             {pointLight("Lamp", "[1, 5, 8]", 13), sun("Sun", "[-1, 3, 6]", "[0, 0, 0]")})}};
}

std::vector<Case> outOfView() {
    const Fill beam = [](Document& document) {
        addStage(document);
        place(document, "Beam",
              moved(box({-0.3, -0.3, -12}, {0.3, 0.3, 12}, 2),
                    [](const dvec3& p) {
                        return turn(7, {0, 1, 0}) * p + dvec3(3.5, 4, 8);
                    }),
              paint(document, "Beam", {0.3, 0.5, 0.75}));
    };
    const char* catches = "culling casters by where they are instead of where their shadows are";
    return {
        {"B12-1", "casters wholly behind the eye", "their shadows are on ground and wall", catches, addStage,
         sequence(
             {.camera = eye("[0, 2.5, -2.5]", "[0, 1.5, -7]", 70), .lights = {pointLight("Lamp", "[-1, 5, 9]", 13)}})},
        {"B12-2", "casters beside the picture", "their shadows reach into it", catches, addStage,
         sequence({.camera = eye("[9, 3, 5]", "[8, 1, -3]", 50), .lights = {pointLight("Lamp", "[-9, 6, 4]", 14)}})},
        {"B12-3", "a beam from behind the eye to before it: silhouette edges cross the eye's plane",
         "the beam's shadow, from the picture's border on", "projected edges whose w changes its sign", beam,
         sequence({.camera = eye("[0, 2, 9]", "[0, 1.5, 0]", 60),
                   .lights = {pointLight("Lamp", "[7, 8, 9]", 11), pointLight("Side", "[-6, 6, 4]", 9)}})}};
}

}  // namespace

std::vector<Case> projectionCases() {
    std::vector<Case> all;
    for (auto* const group : {lightInView, grazing, lensesAndPictures, mirrors, orthographic, outOfView})
        for (Case& one : group()) all.push_back(std::move(one));
    return all;
}

}  // namespace generator::stress
