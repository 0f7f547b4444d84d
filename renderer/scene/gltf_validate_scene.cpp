// SPDX-License-Identifier: Apache-2.0
// Cameras, lights, nodes, scenes and skins. The node graph must be a forest, which is found out in linear time.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <unordered_set>

#include "scene/gltf_validate_parts.h"

namespace umbrage {
namespace {

constexpr std::size_t kNoParent = static_cast<std::size_t>(-1);

void requirePositive(const JsonView& value) {
    if (!(value.number() > 0.0)) {
        value.fail(fmt::format("must be greater than 0, but is {}", value.number()));
    }
}

void validateDepths(const JsonView& lens) {
    const auto zfar = lens.find("zfar");
    const JsonView znear = lens.at("znear");
    if (zfar && !(zfar->number() > znear.number())) {
        zfar->fail(
            fmt::format("must be greater than znear, but is {} and znear is {}", zfar->number(), znear.number()));
    }
}

void validateCamera(const JsonView& camera) {
    const JsonView type = camera.at("type");
    requireEnum(type, {"perspective", "orthographic"});
    const JsonView lens = camera.at(type.text());
    if (type.text() == "perspective") {
        const JsonView yfov = lens.at("yfov");
        if (!(yfov.number() > 0.0 && yfov.number() < std::numbers::pi)) {
            yfov.fail(fmt::format("must be between 0 and pi radians, but is {}", yfov.number()));
        }
        requirePositive(lens.at("znear"));
    } else {
        for (const char* key : {"xmag", "ymag"}) {
            if (lens.at(key).number() == 0.0) {
                lens.at(key).fail("must not be 0");
            }
        }
        if (lens.at("znear").number() < 0.0) {
            lens.at("znear").fail(fmt::format("must not be negative, but is {}", lens.at("znear").number()));
        }
        lens.at("zfar");
    }
    validateDepths(lens);
}

void validateSpot(const JsonView& spot) {
    const double inner = spot.number("innerConeAngle", 0.0);
    const double outer = spot.number("outerConeAngle", std::numbers::pi / 4);
    constexpr double kRounding = 1e-6;  // pi/2 as a float is a little more than pi/2
    if (!(inner >= 0.0 && inner < outer && outer <= std::numbers::pi / 2 + kRounding)) {
        spot.fail(fmt::format("the cone angles must be 0 <= inner < outer <= pi/2, but inner is {} and outer is {}",
                              inner, outer));
    }
}

void validateLight(const JsonView& light) {
    const JsonView type = light.at("type");
    requireEnum(type, {"point", "spot", "directional"});
    if (const auto color = light.find("color")) {
        for (const double component : color->numbers(3)) {
            if (component < 0.0) {
                color->fail(fmt::format("must not be negative, but has a component of {}", component));
            }
        }
    }
    if (const auto intensity = light.find("intensity"); intensity && intensity->number() < 0.0) {
        intensity->fail(fmt::format("must not be negative, but is {}", intensity->number()));
    }
    if (const auto range = light.find("range")) {
        requirePositive(*range);
    }
    if (type.text() == "spot") {
        validateSpot(light.at("spot"));
    }
}

void validateTransform(const JsonView& node) {
    if (const auto matrix = node.find("matrix")) {
        const auto values = matrix->numbers(16);
        constexpr double kRounding = 1e-6;
        if (std::abs(values[3]) + std::abs(values[7]) + std::abs(values[11]) + std::abs(values[15] - 1.0) > kRounding) {
            matrix->fail(fmt::format("its last row must be 0 0 0 1, but is {} {} {} {}", values[3], values[7],
                                     values[11], values[15]));
        }
        for (const char* key : {"translation", "rotation", "scale"}) {
            if (const auto part = node.find(key)) {
                part->fail("a node has either a matrix or translation, rotation and scale");
            }
        }
    }
    for (const char* key : {"translation", "scale"}) {
        if (const auto part = node.find(key)) {
            part->numbers(3);
        }
    }
    if (const auto rotation = node.find("rotation")) {
        const auto q = rotation->numbers(4);
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(length > 0.0)) {
            rotation->fail("is the zero quaternion, which is no rotation");
        }
    }
}

void validateNode(const Validation& validation, const JsonView& node) {
    validateTransform(node);
    node.index("camera", validation.cameraCount, "camera");
    const auto mesh = node.index("mesh", validation.meshTargetCounts.size(), "mesh");
    const auto skin = node.index("skin", validation.skinCount, "skin");
    if (mesh && skin && !validation.meshHasJoints[*mesh]) {
        node.at("skin").fail(
            fmt::format("mesh {} cannot be skinned: not all of its primitives have JOINTS_0 and WEIGHTS_0", *mesh));
    }
    if (const auto weights = node.find("weights")) {
        weights->numbers(mesh ? validation.meshTargetCounts[*mesh] : 0);
    }
    if (const auto light = node.extension("KHR_lights_punctual")) {
        light->at("light").index(validation.lightCount, "light");
    }
}

std::vector<std::size_t> findParents(const std::vector<JsonView>& nodes) {
    std::vector<std::size_t> parents(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (!children) {
            continue;
        }
        for (const JsonView& child : children->items()) {
            const std::size_t node = child.index(nodes.size(), "node");
            if (parents[node] != kNoParent) {
                child.fail(fmt::format("node {} already is a child of node {}", node, parents[node]));
            }
            parents[node] = i;
        }
    }
    return parents;
}

// With at most one parent each, exactly the nodes that no root reaches lie in or below a cycle.
void requireNoCycles(const std::vector<JsonView>& nodes, const std::vector<std::size_t>& parents) {
    std::vector<bool> reached(nodes.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (parents[i] == kNoParent) {
            open.push_back(i);
        }
    }
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        reached[node] = true;
        if (const auto children = nodes[node].find("children")) {
            for (const auto& child : children->value()) {
                open.push_back(child.get<std::size_t>());
            }
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!reached[i]) {
            nodes[i].fail("is its own ancestor, or the descendant of a node that is");
        }
    }
}

void validateScenes(const Validation& validation, const std::vector<std::size_t>& parents) {
    for (const JsonView& scene : validation.root.objects("scenes")) {
        const auto roots = scene.find("nodes");
        std::unordered_set<std::size_t> seen;
        for (const JsonView& root : roots ? roots->items() : std::vector<JsonView>{}) {
            const std::size_t node = root.index(parents.size(), "node");
            if (parents[node] != kNoParent) {
                root.fail(
                    fmt::format("node {} is a child of node {}, so it cannot be a scene's root", node, parents[node]));
            }
            if (!seen.insert(node).second) {
                root.fail(fmt::format("node {} is named twice", node));
            }
        }
    }
    validation.root.index("scene", validation.sceneCount, "scene");
}

}  // namespace

void validateCamerasAndLights(const Validation& validation) {
    for (const JsonView& camera : validation.root.objects("cameras")) {
        validateCamera(camera);
    }
    if (const auto lights = validation.root.extension("KHR_lights_punctual")) {
        for (const JsonView& light : lights->objects("lights")) {
            validateLight(light);
        }
    }
}

void validateNodesAndScenes(const Validation& validation) {
    const auto nodes = validation.root.objects("nodes");
    for (const JsonView& node : nodes) {
        validateNode(validation, node);
    }
    const auto parents = findParents(nodes);
    requireNoCycles(nodes, parents);
    validateScenes(validation, parents);
}

void validateSkins(const Validation& validation) {
    for (const JsonView& skin : validation.root.objects("skins")) {
        const JsonView joints = skin.at("joints");
        std::unordered_set<std::size_t> seen;
        for (const JsonView& joint : joints.items()) {
            if (!seen.insert(joint.index(validation.nodeCount, "node")).second) {
                joint.fail(fmt::format("node {} is a joint twice", joint.value().dump()));
            }
        }
        if (seen.empty()) {
            joints.fail("a skin needs at least one joint");
        }
        skin.index("skeleton", validation.nodeCount, "node");
        if (const auto matrices = skin.find("inverseBindMatrices")) {
            const AccessorFacts& facts = requireAccessor(validation, *matrices, "MAT4", kFloat);
            if (facts.count < seen.size()) {
                matrices->fail(fmt::format("has {} matrices for {} joints", facts.count, seen.size()));
            }
        }
    }
}

}  // namespace umbrage
