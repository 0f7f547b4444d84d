// SPDX-License-Identifier: Apache-2.0
// Overdraw of the scene against meshoptimizer's analysis, which rasterises a mesh from six sides by itself, and against
// view rays. The analysis of version 0.18 gets the depth of sloped faces wrong (two factors of its gradients are not
// multiplied by the inverse determinant), so it is asked about boxes; the rays are asked about everything.
#include <meshoptimizer.h>

#include <random>

#include "counter_checks.h"
#include "judge/truth.h"
#include "oracle/predicates.h"
#include "subjects.h"

namespace umbrage::test {
namespace {

constexpr int kViewport = 256;  // meshoptimizer's

/// The largest mesh of a scene of ours, alone, unscaled, all of it opaque and single-sided.
Scene largestMesh(const std::string& name) {
    const Scene scene = ours(name, 16, 16).scene;
    const auto largest = std::max_element(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& a, const Mesh& b) {
        return a.triangleCount() < b.triangleCount();
    });
    Scene alone;
    alone.materials.resize(1);
    alone.meshes.push_back(*largest);
    Mesh& mesh = alone.meshes.front();
    mesh.morphTargets.clear();
    for (Primitive& primitive : mesh.primitives) primitive.material = 0;
    Node node;
    node.path = "/mesh";
    node.mesh = 0;
    alone.nodes.push_back(node);
    return alone;
}

/// Boxes along the axes, of many sizes, in and behind each other.
Scene boxes() {
    Scene scene = largestMesh("pole");
    Mesh& mesh = scene.meshes.front();
    mesh.positions.clear();
    mesh.normals.clear();
    mesh.indices.clear();
    std::mt19937 random(7);
    const auto draw = [&] { return float(random() % 1024) / 64.0f; };
    for (int box = 0; box < 200; ++box) {
        const auto base = std::uint32_t(mesh.positions.size());
        const glm::vec3 low(draw(), draw(), draw()), size = 0.25f + 0.2f * glm::vec3(draw(), draw(), draw());
        for (int corner = 0; corner < 8; ++corner) {
            mesh.positions.push_back(low + size * glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2));
        }
        for (const std::uint32_t k : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5}) {
            mesh.indices.push_back(base + k);
        }
    }
    Primitive primitive;
    primitive.indexCount = std::uint32_t(mesh.indices.size());
    primitive.vertexCount = std::uint32_t(mesh.positions.size());
    primitive.material = 0;
    mesh.primitives = {primitive};
    return scene;
}

struct Seen {
    double fragments = 0, covered = 0, shaded = 0;
};

/// One camera's, by rays: all triangles that a pixel's ray meets from the front, and those nearer than all before them.
Seen byRays(const Mesh& mesh, const PlacedCamera& camera) {
    const oracle::EyeRays rays(camera, kViewport, kViewport);
    std::vector<double> nearest(std::size_t(kViewport * kViewport), 1e300);
    Seen seen;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = glm::dvec3(mesh.positions[mesh.indices[t + k]]);
        const glm::dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const glm::dmat4 cameraFromWorld = glm::inverse(camera.worldFromCamera);
        int low[2] = {kViewport, kViewport}, high[2] = {0, 0};
        for (const glm::dvec3& corner : corners) {
            const glm::dvec4 p = cameraFromWorld * glm::dvec4(corner, 1.0);
            const double at[] = {0.5 * kViewport * (1.0 + p.x / camera.camera.ymag),
                                 0.5 * kViewport * (1.0 - p.y / camera.camera.ymag)};
            for (int k = 0; k < 2; ++k) {
                low[k] = std::min(low[k], std::max(0, int(at[k]) - 1));
                high[k] = std::max(high[k], std::min(kViewport, int(at[k]) + 2));
            }
        }
        for (int y = low[1]; y < high[1]; ++y) {
            for (int x = low[0]; x < high[0]; ++x) {
                const oracle::Ray ray = rays.at(x + 0.5, y + 0.5);
                if (glm::dot(n, ray.direction) >= 0.0 || !oracle::meets(ray, corners)) continue;
                const double distance = glm::dot(n, corners[0] - ray.origin) / glm::dot(n, ray.direction);
                double& least = nearest[std::size_t(y * kViewport + x)];
                ++seen.fragments;
                seen.covered += least == 1e300;
                if (distance >= least) continue;
                least = distance;
                ++seen.shaded;
            }
        }
    }
    return seen;
}

/// From both ends of the three axes.
/// @param rays  what rays say of the same cameras is added there
Seen seenBySixCameras(const Scene& scene, Seen& rays) {
    const std::vector<glm::vec3>& positions = scene.meshes.front().positions;
    glm::dvec3 low(positions.front()), high(low);
    for (const glm::vec3& p : positions) {
        low = glm::min(low, glm::dvec3(p));
        high = glm::max(high, glm::dvec3(p));
    }
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    const glm::dvec3 centre = low + 0.5 * extent;
    Seen sum;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 forward(0.0), up(0.0);
            forward[axis] = -sign;
            up[(axis + 1) % 3] = 1.0;
            PlacedCamera camera;
            camera.camera.perspective = false;
            camera.camera.xmag = camera.camera.ymag = 0.5 * extent;
            camera.camera.znear = 0.5 * extent;
            camera.camera.zfar = 4.0 * extent;
            const glm::dvec3 side = glm::cross(forward, up);
            camera.worldFromCamera = {glm::dvec4(side, 0), glm::dvec4(up, 0), glm::dvec4(-forward, 0),
                                      glm::dvec4(centre - 2.0 * extent * forward, 1)};
            FrameSettings settings;
            settings.width = settings.height = kViewport;
            const Moment moment = evaluate(scene, {}, 0.0);
            FrameRenderer renderer(scene, moment, settings, context());
            FrameOutputs outputs;
            outputs.scene = true;
            Statistics unused;
            const SceneFragments found = renderer.render(moment, camera, outputs, 1, unused).scene;
            sum.fragments += double(found.fragmentSamples);
            sum.covered += double(found.coveredPixels);
            sum.shaded += double(found.shadedSamples);
            double perPixel = 0;
            for (const float shaded : found.shaded) perPixel += double(shaded);
            EXPECT_EQ(perPixel, double(found.shadedSamples)) << "pixels and query";
            const Seen here = byRays(scene.meshes.front(), camera);
            rays.fragments += here.fragments;
            rays.covered += here.covered;
            rays.shaded += here.shaded;
        }
    }
    return sum;
}

TEST(SceneOverdraw, OfBoxesIsThatOfMeshoptimizer) {
    const Scene scene = boxes();
    const Mesh& mesh = scene.meshes.front();
    Seen rays;
    const Seen seen = seenBySixCameras(scene, rays);
    const meshopt_OverdrawStatistics analysed = meshopt_analyzeOverdraw(
        mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x, mesh.positions.size(), sizeof(glm::vec3));
    std::printf("covered %.0f and %u, overdraw %.4f and %.4f\n", seen.covered, analysed.pixels_covered,
                seen.shaded / seen.covered, double(analysed.overdraw));
    expectCounter("scene.covered", "meshoptimizer, boxes", seen.covered, analysed.pixels_covered,
                  0.02 * analysed.pixels_covered);
    expectCounter("scene.overdraw", "meshoptimizer, boxes", seen.shaded / seen.covered, double(analysed.overdraw),
                  0.02 * double(analysed.overdraw));
    EXPECT_GT(seen.shaded, 1.5 * seen.covered);
}

class SceneOverdrawOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Ours, SceneOverdrawOf, testing::Values("knight", "tree", "courtyard", "teapot-like"));

TEST_P(SceneOverdrawOf, IsThatOfViewRays) {
    Seen rays;
    const Seen seen = seenBySixCameras(largestMesh(GetParam()), rays);
    std::printf("%s: fragments %.0f and %.0f, covered %.0f and %.0f, shaded %.0f and %.0f\n", GetParam(),
                seen.fragments, rays.fragments, seen.covered, rays.covered, seen.shaded, rays.shaded);
    expectCounter("scene.fragments", "view rays", seen.fragments, rays.fragments, 1e-3 * rays.fragments);
    expectCounter("scene.covered", "view rays", seen.covered, rays.covered, 1e-3 * rays.covered);
    expectCounter("scene.shaded", "view rays", seen.shaded, rays.shaded, 1e-3 * rays.shaded);
    expectCounter("scene.depthComplexity", "view rays", seen.fragments / seen.covered, rays.fragments / rays.covered,
                  1e-3 * rays.fragments / rays.covered);
    expectCounter("scene.overdraw", "view rays", seen.shaded / seen.covered, rays.shaded / rays.covered,
                  1e-3 * rays.shaded / rays.covered);
    EXPECT_GT(seen.fragments, seen.covered);
}

}  // namespace
}  // namespace umbrage::test
