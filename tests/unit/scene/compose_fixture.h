// SPDX-License-Identifier: Apache-2.0
// A small room, and what composing layers of it gives.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/component_wise.hpp>
#include <nlohmann/json.hpp>

#include "error.h"
#include "job/job.h"
#include "scene/compose.h"
#include "scene/moment.h"
#include "scene/node_paths.h"

namespace umbrage::test {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

// Three positions of a triangle in x, y; the times 0 and 1; the points (0, 0, 0) and (2, 0, 0).
inline const char* const kBuffer =
    "data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAABAAAAAAAAAAAA=";

/// A room with a lamp twice (one shared light), a spot, a camera, a triangle and an animation that moves it.
inline Json room() {
    return Json::parse(R"({
      "asset": {"version": "2.0"},
      "extensionsUsed": ["KHR_lights_punctual"],
      "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "name": "bulb", "intensity": 5},
        {"type": "spot", "name": "beam", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}]}},
      "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [
        {"name": "Room", "children": [1, 2, 3, 4, 5]},
        {"name": "LampA", "translation": [0, 1, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "LampB", "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "Spot", "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"name": "Cam", "camera": 0, "translation": [0, 0, 5]},
        {"name": "Figure", "mesh": 0}],
      "cameras": [{"name": "wide", "type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
      "materials": [{"name": "paint"}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                      {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
      "buffers": [{"byteLength": 68}],
      "animations": [{"name": "walk", "samplers": [{"input": 1, "output": 2}],
                      "channels": [{"sampler": 0, "target": {"node": 5, "path": "translation"}}]}]})");
}

/// The triangle alone.
inline Json figure() {
    Json json = room();
    json.erase("extensions");
    json.erase("extensionsUsed");
    json.erase("cameras");
    json.erase("animations");
    json["nodes"] = {{{"name", "Figure"}, {"mesh", 0}}};
    return json;
}

class Compose : public testing::Test {
protected:
    Compose() {
        folder_ = std::filesystem::temp_directory_path() / ("umbrage_compose_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        write("room.gltf", room());
        write("figure.gltf", figure());
    }
    ~Compose() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, Json json) {
        json["buffers"][0]["uri"] = kBuffer;
        std::ofstream(folder_ / name) << json.dump();
    }

    Composition composed(const std::string& layers, const std::string& more = "") const {
        return compose(parseJob("umbrage: 1\nscene:\n" + layers + more, "s.yaml", folder_));
    }

    void expectError(const std::string& layers, const std::string& more, const std::string& where,
                     const std::string& message, const std::string& hint) const {
        SCOPED_TRACE(layers + more);
        try {
            composed(layers, more);
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.where(), where) << error.what();
            EXPECT_THAT(error.message(), HasSubstr(message));
            EXPECT_THAT(error.hint(), HasSubstr(hint));
        }
    }

    std::filesystem::path folder_;
};

inline const std::string kRoom = "- gltf: room.gltf\n";
inline const std::string kFigure = "- gltf: figure.gltf\n";

inline std::vector<std::string> pathsOf(const Scene& scene) {
    std::vector<std::string> paths;
    for (const Node& node : scene.nodes) paths.push_back(node.path);
    return paths;
}

inline const Node& nodeAt(const Scene& scene, const std::string& path) {
    const Index node = findNode(scene, path);
    if (node == kNone) throw std::runtime_error("no node " + path);
    return scene.nodes[static_cast<std::size_t>(node)];
}

inline const Light& lightAt(const Scene& scene, const std::string& path) {
    return scene.lights.at(static_cast<std::size_t>(nodeAt(scene, path).light));
}

inline const LightTrack* trackOn(const Scene& scene, const std::string& path, LightProperty property) {
    for (const LightTrack& track : scene.lightTracks)
        if (track.node == findNode(scene, path) && track.property == property) return &track;
    return nullptr;
}

inline glm::dvec3 worldPosition(const Composition& composition, const std::string& path, double timeSeconds) {
    const Moment moment = evaluate(composition.scene, composition.animations, timeSeconds);
    return glm::dvec3(moment.worldFromNode.at(static_cast<std::size_t>(findNode(composition.scene, path)))[3]);
}

inline glm::dvec3 worldForward(const Composition& composition, Index node, double timeSeconds) {
    const Moment moment = evaluate(composition.scene, composition.animations, timeSeconds);
    return -glm::dvec3(moment.worldFromNode.at(static_cast<std::size_t>(node))[2]);
}

inline void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-6) {
    EXPECT_LT(glm::compMax(glm::abs(actual - expected)), tolerance)
        << actual.x << ", " << actual.y << ", " << actual.z << " is not " << expected.x << ", " << expected.y << ", "
        << expected.z;
}

inline void expectParentsFirst(const Scene& scene) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        EXPECT_LT(scene.nodes[i].parent, static_cast<Index>(i));
        for (const Index child : scene.nodes[i].children)
            EXPECT_EQ(scene.nodes.at(static_cast<std::size_t>(child)).parent, static_cast<Index>(i));
    }
}

}  // namespace umbrage::test
