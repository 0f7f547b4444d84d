// SPDX-License-Identifier: Apache-2.0
// Stress family A: where the light is. In the plane of a face, on a vertex, on an edge, inside the caster, infinitely
// far; and moving through such places.
#include <algorithm>

#include "stress/parts.h"
#include "stress/stress.h"

namespace generator::stress {
namespace {

constexpr dvec3 kRoomLow{-12, -4, -12}, kRoomHigh{12, 12, 12};
constexpr double kReach = 11;  // metres from a light in the room to what it should light well

using Place = std::function<dvec3(const dvec3&)>;

/// The box of half size 2 around the origin, cut and placed.
Mesh cutBox(int cuts, const Place& where) {
    return moved(box(dvec3(-2), dvec3(2), cuts), where);
}

void fillRoom(Document& document, const Mesh& caster) {
    addRoom(document, kRoomLow, kRoomHigh);
    place(document, "Caster", caster, paint(document, "Caster", kCasterColor));
}

std::function<void(Document&)> roomWith(const Mesh& caster) {
    return [caster](Document& document) { fillRoom(document, caster); };
}

std::string roomShot(const std::string& camera, const std::string& lightPosition, const std::string& frames = "1") {
    return sequence({.camera = camera, .lights = {pointLight("Lamp", lightPosition, kReach)}, .frames = frames});
}

dvec3 upright(const dvec3& p) {
    return p + dvec3(0, 4, 0);
}
dvec3 tilted(const dvec3& p) {
    return oddRotation() * p + dvec3(0.5, 4, -0.25);
}
dvec3 tiltedTwice(const dvec3& p) {
    return oddRotation() * (oddRotation() * p) + dvec3(0.5, 4, -0.25);
}

const dvec3 kInTopPlane(1.3, 2, -7.7);  // of the box around the origin
const dvec3 kInSidePlane(2, 1.1, -7.3);

// Across the light's path: much of the lit room, the box, and its shadow on floor and walls.
std::string besideTilted() {
    return eye("[-10.5, 10.5, 4]", "[4, 2, 1.5]", 62);
}
std::string besideUpright() {
    return eye("[-10.5, 10.5, -2]", "[1, 2, 5]", 62);
}
// Along the box's upper face, so that as much is seen above its plane as below.
std::string alongUpright() {
    return eye("[-10.5, 8, -2]", "[2, 5.25, 2]", 66);
}
std::string alongCorner() {
    return eye("[9, 7.5, -10.5]", "[-1, 5.25, 1]", 66);
}

std::vector<Case> inPlaneOfFace() {
    const auto movedByNode = [](Document& document) {
        addRoom(document, kRoomLow, kRoomHigh);
        const int mesh =
            document.mesh("Caster", {partOf(cutBox(32, rounded), paint(document, "Caster", kCasterColor))});
        dmat4 matrix(oddRotation());
        matrix[3] = glm::dvec4(tilted({}), 1);
        document.node({.name = "Caster", .mesh = mesh, .matrix = matrix});
    };
    const char* answer = "the box's shadow; at its border either facing of the edge-on triangles is right";
    return {{"A1-1", "a box whose faces are cut 64 x 64, tilted; the light in the plane of a face up to rounding",
             answer, "facing decided anew in every shader: neighbours disagree and shadows streak or leak",
             roomWith(cutBox(64, tilted)), roomShot(besideTilted(), at(rounded(tilted(kInTopPlane))))},
            {"A1-2", "the box of A1-1 cut 32 x 32, tilted by its node instead of in its vertices", answer,
             "a light brought into the caster's space more than once, each time with other roundings", movedByNode,
             roomShot(besideTilted(), at(tilted(kInTopPlane)))},
            {"A1-3", "the box of A1-1 cut 32 x 32, tilted twice; the light in the plane of another face up to rounding",
             answer, "the same, in another pose", roomWith(cutBox(32, tiltedTwice)),
             roomShot(eye("[-8, 10, -9]", "[5, 2, 1.5]", 62), at(rounded(tiltedTwice(kInSidePlane))))},
            {"A2", "the box of A1-1 along the axes: the light exactly in the plane of a face",
             "the triangles in the light's plane cast nothing; the shadow is that of the other faces",
             "a facing of 0 taken for one side by one triangle of an edge and for the other by its neighbour",
             roomWith(cutBox(64, upright)), roomShot(besideUpright(), at(rounded(upright(kInTopPlane))))}};
}

/// The vertex of a convex mesh that lies farthest that way.
dvec3 extreme(const Mesh& mesh, const dvec3& way) {
    return dvec3(*std::ranges::max_element(mesh.positions, {},
                                           [&](const vec3& position) { return glm::dot(dvec3(position), way); }));
}

/// How many triangles lie in one plane with the light; right for points of few bits.
std::size_t edgeOnTriangles(const Mesh& mesh, const dvec3& light) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto from = [&](std::size_t corner) { return dvec3(mesh.positions[mesh.indices[i + corner]]) - light; };
        if (glm::dot(from(0), glm::cross(from(1), from(2))) == 0) ++count;
    }
    return count;
}

std::vector<Case> onSurface() {
    // `edgeOn` triangles are promised to be in the light's plane.
    const auto lamp = [](const char* id, const char* what, const Mesh& caster, const dvec3& light, std::size_t edgeOn,
                         const std::string& camera) {
        const auto fill = [=](Document& document) {
            fillRoom(document, caster);
            document.promise("triangles in the light's plane", edgeOnTriangles(caster, light), edgeOn);
        };
        return Case{id,
                    what,
                    "the triangles that hold the light cast nothing, all others do",
                    "directions that are NaN, streaks to infinity, a light taken for inside",
                    fill,
                    roomShot(camera, at(light))};
    };
    const Mesh sphere = icosphere(dvec3(0.5, 4, -0.25), 2.3, 2), wholeBox = cutBox(1, upright),
               manyCut = cutBox(8, upright);
    const dvec3 b(2.5, 2.125, -1.5), c(0.25, 2.75, 2.625), a(-2.25, 2.5, -1.75),
        d(0.375, 6.5, -0.25);  // oddTetrahedron()
    return {lamp("A3-1", "the light on the exact bits of a box's corner", manyCut, {2, 6, -2}, 384, alongCorner()),
            lamp("A3-2", "the light on the exact bits of a vertex of an icosphere", sphere,
                 extreme(sphere, {-0.6, 0.7, -0.4}), 6, alongUpright()),
            lamp("A3-3", "the light on the exact bits of a vertex amid a box's upper face, cut 8 x 8", manyCut,
                 {0.5, 6, -1}, 128, alongUpright()),
            lamp("A4-1", "the light on the midpoint of a box's edge, exactly", wholeBox, {2, 6, 0}, 4, alongCorner()),
            lamp("A4-2", "the light on the midpoint of a slanting edge of a tetrahedron, exactly", oddTetrahedron(),
                 (a + d) / 2.0, 2, alongUpright()),
            lamp("A5-1", "the light on a point amid a triangle of a box's upper face, exactly", wholeBox,
                 {0.75, 6, 0.5}, 2, alongUpright()),
            lamp("A5-2",
                 "the light amid a slanting face of a tetrahedron, exactly: a quarter, a quarter and half its corners",
                 oddTetrahedron(), b / 4.0 + c / 4.0 + d / 2.0, 1, alongCorner())};
}

/// Twelve closed bars along the edges of a cube; they do not touch.
Mesh cage(const dvec3& centre, double half, double thickness) {
    Mesh result;
    const double reach = half - 1.5 * thickness;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-half, half})
            for (const double b : {-half, half}) {
                dvec3 middle, extent(thickness / 2);
                middle[(axis + 1) % 3] = a, middle[(axis + 2) % 3] = b;
                extent[axis] = reach;
                result.add(box(centre + middle - extent, centre + middle + extent));
            }
    return result;
}

std::vector<Case> insideCaster() {
    const dvec3 centre(0.5, 4, -0.25);
    const auto lampInside = [=](bool doubleSided) {
        return [=](Document& document) {
            addRoom(document, kRoomLow, kRoomHigh);
            place(document, "Sphere", icosphere(centre, 3, 3), paint(document, "Sphere", kCasterColor, doubleSided));
            place(document, "Crate", box(centre + dvec3(-0.5, -1.6, -0.4), centre + dvec3(0.3, -0.9, 0.5)),
                  paint(document, "Crate", {0.3, 0.5, 0.75}));
        };
    };
    const char* catches = "counting light-facing triangles only: with the light inside all seems lit";
    return {
        {"A6-1", "the light at the centre of a closed icosphere, seen from outside; a second one outside",
         "of the inner light nothing is lit outside; the outer one casts a shadow as ever", catches, lampInside(false),
         sequence({.camera = eye("[-10.5, 10.5, -2]", "[2, 2, 3]", 62),
                   .lights = {pointLight("Inner", at(centre), kReach), pointLight("Outer", "[-4, 10, -6]", kReach)}})},
        {"A6-2", "the same sphere, of a double-sided material, seen from inside; a crate in it",
         "its inside is lit but for the crate's shadow", catches, lampInside(true),
         sequence({.camera = eye(at(centre + dvec3(-2.1, 1.1, 1.2)), at(centre + dvec3(0.2, -1, 0)), 75),
                   .lights = {pointLight("Inner", at(centre), 3)}})},
        {"A7", "the light within a cage of twelve closed bars that do not touch, in a room",
         "twelve stripes over six walls, open at the cage's corners",
         "a dark cap that is a fan over the whole silhouette, caps left out by a table of easy cases",
         [](Document& document) {
             addRoom(document, {-4, -4, -4}, {4, 4, 4});
             place(document, "Cage", cage({0.125, 0.25, -0.125}, 1, 0.25), paint(document, "Cage", kCasterColor));
         },
         sequence({.camera = eye("[-3.6, 3, 3.7]", "[0.6, -0.6, -0.6]", 80),
                   .lights = {pointLight("Lamp", "[0.125, 0.25, -0.125]", 4)}})}};
}

/// A box before a wall on a ground, along the axes.
void addBoxAndWall(Document& document) {
    addGround(document, 16);
    const int paintOfWall = paint(document, "Wall", dvec3(0.6));
    place(document, "Wall", grid({-16, 0, -8}, {32, 0, 0}, {0, 16, 0}, 1, 1), paintOfWall, Kind::Receiver);
    place(document, "Caster", box({-2, 1, -1}, {1, 4, 2}, 4), paint(document, "Caster", kCasterColor));
}

std::vector<Case> directional() {
    const auto withSun = [](const dvec3& direction) {
        return [=](Document& document) {
            addBoxAndWall(document);
            addSun(document, "Sun", direction);
        };
    };
    const auto someCasters = [](Document& document) {
        addGround(document, 20);
        addCasters(document);
    };
    const dvec3 towardsSun(3, 6, 2);  // a length of 7
    const std::string above = eye("[5, 7, 9]", "[-1, 0.75, -0.5]", 52);
    const char* same = "A9-1 and A9-2 are the same picture, up to single pixels along shadow borders";
    return {
        {"A8-1", "the sun straight down, exactly parallel to four faces of a box", "a square shadow below the box",
         "fans of triangles with w = 0, edges between two faces of which one is edge-on", withSun({0, -1, 0}),
         sequence({.camera = eye("[6, 5, 9]", "[-0.5, 1.5, -1]", 50)})},
        {"A8-2", "the sun exactly along the view, the eye on the box's axis",
         "a lit wall; the shadow on it hides behind the box",
         "volumes seen end-on, a point at infinity in the middle of the picture", withSun({0, 0, -1}),
         sequence({.camera = eye("[-0.5, 2.5, 11]", "[-0.5, 2.5, 0]", 50)})},
        {"A8-3", "the sun exactly parallel to the ground",
         "the ground gets no light at all, the wall all but the box's outline", "N.L = 0 lit by rounding",
         withSun({0, 0, -1}), sequence({.camera = eye("[7, 6, 9]", "[-0.5, 2, -3]", 50)})},
        {"A9-1", "a point light 9,800 km away", same, "extrusion that loses the vertex beside the light's coordinates",
         someCasters, sequence({.camera = above, .lights = {pointLight("Sun", at(1.4e6 * towardsSun), 9.8e6)}})},
        {"A9-2", "a directional light from where the point light of A9-1 is", same,
         "a path for directional lights that rounds otherwise",
         [=](Document& document) {
             someCasters(document);
             addSun(document, "Sun", -towardsSun / 7.0);
         },
         sequence({.camera = above})}};
}

std::vector<Case> closeToFace() {
    const double off = 4e-6;  // 1e-6 of the box's size
    const auto lamp = [&](const Place& where, double side) { return at(rounded(where({0.3, 2 + side * off, -0.4}))); };
    const char* outside = "what is above the face's plane is lit, what is below is dark";
    const char* inside = "all is dark";
    const char* catches = "a facing computed with fewer bits than the light's distance needs";
    return {{"A10-1", "the light 4e-6 above the upper face of a box of size 4", outside, catches,
             roomWith(cutBox(8, upright)), roomShot(alongUpright(), lamp(upright, 1))},
            {"A10-2", "the light 4e-6 below the upper face of a box of size 4: inside", inside, catches,
             roomWith(cutBox(8, upright)), roomShot(alongUpright(), lamp(upright, -1))},
            {"A10-3", "A10-1, tilted", outside, catches, roomWith(cutBox(8, tilted)),
             roomShot(alongUpright(), lamp(tilted, 1))},
            {"A10-4", "A10-2, tilted", inside, catches, roomWith(cutBox(8, tilted)),
             roomShot(alongUpright(), lamp(tilted, -1))}};
}

std::vector<Case> sweeps() {
    const char* answer = "no frame differs from rays";
    const char* catches = "flashes of a single frame";
    return {
        {"A11-1", "the light passes through the plane of a tilted box's face at right angles; A1's place at frame 501",
         answer, catches, roomWith(cutBox(24, tilted)),
         roomShot(besideTilted(), pathThrough(rounded(tilted(kInTopPlane)), oddRotation() * dvec3(0, 0.5, 0)),
                  kSweepFrames)},
        {"A11-2", "the light passes over the corner of a box from outside to outside; on the corner at frame 501",
         answer, catches, roomWith(cutBox(8, upright)),
         roomShot(alongCorner(), pathThrough({2, 6, -2}, {0.5, 0.1875, 0.5}), kSweepFrames)},
        {"A11-3", "the light passes over the edge of a box from outside to outside; on its midpoint at frame 501",
         answer, catches, roomWith(cutBox(1, upright)),
         roomShot(alongCorner(), pathThrough({2, 6, 0}, {-0.5, 0.5, 0.125}), kSweepFrames)}};
}

}  // namespace

std::vector<Case> lightCases() {
    std::vector<Case> all;
    for (auto* const group : {inPlaneOfFace, onSurface, insideCaster, directional, closeToFace, sweeps})
        for (Case& one : group()) all.push_back(std::move(one));
    return all;
}

}  // namespace generator::stress
