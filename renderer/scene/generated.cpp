// SPDX-License-Identifier: Apache-2.0
#include "scene/generated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/aim.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

constexpr double kGroundHalf = 12.0, kFieldHalf = 9.0;  // metres
constexpr double kLowest = 0.3, kHighest = 4.3;         // where bodies may be
constexpr float kSeconds = 2.0f;                        // of the animation

/// Numbers that look random, the same everywhere: multiples of an irrational number, without their whole parts.
double scattered(int index, double irrational) {
    const double multiple = (index + 1) * irrational;
    return multiple - std::floor(multiple);
}
constexpr double kGolden = 0.61803398874989485, kRoot2 = 0.41421356237309505, kRoot3 = 0.73205080756887729;

Index add(Scene& scene, const std::string& name, const glm::dvec3& translation) {
    const Index node = addNode(scene, kNone, name, "/" + name);
    scene.nodes[std::size_t(node)].translation = translation;
    return node;
}

/// Keys evenly over the animation.
void move(Scene& scene, Index node, Target target, int width, std::vector<float> values) {
    Animation& animation = scene.animations.front();
    const std::size_t keys = values.size() / std::size_t(width);
    Track& track = animation.tracks.emplace_back();
    track.width = width;
    track.values = std::move(values);
    for (std::size_t key = 0; key < keys; ++key) {
        track.timesSeconds.push_back(kSeconds * float(key) / float(keys - 1));
    }
    animation.channels.push_back({node, target, Index(animation.tracks.size() - 1)});
}

/// Round a square that stands on its corner, and back to where it was.
void circle(Scene& scene, Index node, double radius) {
    const glm::dvec3 at = scene.nodes[std::size_t(node)].translation;
    std::vector<float> values;
    for (const glm::dvec3& step :
         {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0)}) {
        const glm::dvec3 place = at + radius * (step - glm::dvec3(1, 0, 0));
        for (int axis = 0; axis < 3; ++axis) values.push_back(float(place[axis]));
    }
    move(scene, node, Target::Translation, 3, std::move(values));
}

/// A quarter about the upright axis.
void turn(Scene& scene, Index node) {
    const float half = std::sqrt(0.5f);
    move(scene, node, Target::Rotation, 4, {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, half, 0.0f, half});
}

void addGround(Scene& scene) {
    Mesh& mesh = scene.meshes.emplace_back();
    const float h = float(kGroundHalf);
    mesh.positions = {{-h, 0, -h}, {-h, 0, h}, {h, 0, h}, {h, 0, -h}};
    mesh.normals.assign(4, {0, 1, 0});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    Primitive& all = mesh.primitives.emplace_back();
    all.indexCount = 6;
    all.vertexCount = 4;
    all.material = 0;
    all.hasNormals = true;
    scene.nodes[std::size_t(add(scene, "Ground", glm::dvec3(0.0)))].mesh = 0;
}

void addMaterials(Scene& scene) {
    const glm::vec4 colors[] = {
        {0.6, 0.58, 0.55, 1}, {0.7, 0.3, 0.2, 1}, {0.8, 0.62, 0.25, 1}, {0.25, 0.45, 0.68, 1}, {0.35, 0.55, 0.3, 1}};
    for (const glm::vec4& color : colors) {
        Material& material = scene.materials.emplace_back();
        material.baseColor = color;
        material.metallic = 0.0f;
        material.roughness = 0.6f;
    }
}

/// Cuts of the octahedrons' edges: `less` of them, and one more for the last bodies.
struct Cuts {
    int less = 1, bodiesWithMore = 0;

    Cuts(int triangles, int bodies) {
        const double each = double(triangles) / bodies;
        less = std::max(1, int(std::sqrt(each / 8.0)));
        const double spare = triangles - 8.0 * less * less * bodies, step = 8.0 * (2.0 * less + 1.0);
        bodiesWithMore = std::clamp(int(std::lround(spare / step)), 0, bodies);
    }
};

void addBodies(Scene& scene, const GeneratedLayer& layer) {
    const int side = int(std::ceil(std::sqrt(double(layer.columns))));
    const int bodies = layer.columns * layer.layers;
    const Cuts cuts(layer.triangles, bodies);
    const double cell = 2.0 * kFieldHalf / side, storey = (kHighest - kLowest) / layer.layers;
    const double radius = 0.36 * cell / (1.0 + layer.roughness);
    const glm::dvec3 extents(radius, std::min(radius, 0.45 * storey / (1.0 + layer.roughness)), radius);
    for (int body = 0; body < bodies; ++body) {
        const int column = body % layer.columns, storeys = body / layer.columns;
        const glm::dvec3 astray(scattered(column, kGolden) - 0.5, 0.0, scattered(column, kRoot2) - 0.5);
        const glm::dvec3 at = glm::dvec3((column % side + 0.5) * cell - kFieldHalf, kLowest + (storeys + 0.5) * storey,
                                         (column / side + 0.5) * cell - kFieldHalf) +
                              0.24 * cell * astray;
        const int k = cuts.less + (body >= bodies - cuts.bodiesWithMore ? 1 : 0);
        scene.meshes.push_back(noisyBody(k, extents, layer.roughness, 16u * std::uint32_t(body)));
        scene.meshes.back().primitives.front().material = Index(1 + column % 4);
        const Index node = add(scene, fmt::format("Body{}", body), at);
        scene.nodes[std::size_t(node)].mesh = Index(scene.meshes.size() - 1);
        // Whole counts of moving bodies, spread evenly over all.
        if (std::floor((body + 1) * layer.moving / 100.0) == std::floor(body * layer.moving / 100.0)) continue;
        circle(scene, node, 0.2 * radius);
        turn(scene, node);
    }
}

void addLights(Scene& scene, const GeneratedLayer& layer) {
    constexpr float kCandela = 900.0f;  // of all
    for (int i = 0; i < layer.lights; ++i) {
        Light& light = scene.lights.emplace_back();
        const float warmth = float(scattered(i, kRoot3));
        light.color = {0.7f + 0.3f * warmth, 0.85f, 1.0f - 0.4f * warmth};
        light.intensity = kCandela / float(layer.lights);
        light.rangeMetres = float(layer.lightRangeMetres);
        const glm::dvec3 at(kFieldHalf * (2.0 * scattered(i, kGolden) - 1.0), 7.0 + 3.0 * scattered(i, kRoot3),
                            kFieldHalf * (2.0 * scattered(i, kRoot2) - 1.0));
        const Index node = add(scene, fmt::format("Light{}", i), at);
        scene.nodes[std::size_t(node)].light = i;
        if (layer.movingLights) circle(scene, node, 1.0);
    }
}

void addCamera(Scene& scene) {
    scene.cameras.push_back({.name = "Camera", .yfov = 0.75, .znear = 0.1});
    const glm::dvec3 from(-1.5, 7.0, 19.0), to(1.5, 7.5, 18.5);
    const Index node = add(scene, "Camera", from);
    scene.nodes[std::size_t(node)].camera = 0;
    scene.nodes[std::size_t(node)].rotation = lookRotation(glm::dvec3(0.0, 1.2, 0.0) - 0.5 * (from + to));
    move(scene, node, Target::Translation, 3,
         {float(from.x), float(from.y), float(from.z), float(to.x), float(to.y), float(to.z)});
}

}  // namespace

Scene generatedScene(const GeneratedLayer& layer) {
    Scene scene;
    scene.animations.push_back({.name = "Move", .tracks = {}, .channels = {}});
    addMaterials(scene);
    addGround(scene);
    addBodies(scene, layer);
    addLights(scene, layer);
    addCamera(scene);
    return scene;
}

}  // namespace umbrage
