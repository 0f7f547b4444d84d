// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <glm/gtc/quaternion.hpp>

#include "error.h"
#include "scene/append_scene.h"
#include "scene/compose_parts.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

glm::dvec3 vectorOf(const std::array<double, 3>& value) {
    return {value[0], value[1], value[2]};
}

void setTransform(Node& node, const LayerTransform& transform) {
    const glm::dvec3 angles = glm::radians(vectorOf(transform.rotateDegrees));
    node.translation = vectorOf(transform.translate);
    node.rotation = glm::angleAxis(angles.z, glm::dvec3(0, 0, 1)) * glm::angleAxis(angles.y, glm::dvec3(0, 1, 0)) *
                    glm::angleAxis(angles.x, glm::dvec3(1, 0, 0));
    node.scale = vectorOf(transform.scale);
}

bool isIdentity(const LayerTransform& transform) {
    const LayerTransform identity;
    return transform.translate == identity.translate && transform.rotateDegrees == identity.rotateDegrees &&
           transform.scale == identity.scale;
}

// Makes the parts of the path that are not there.
Index nodeAt(Scene& scene, const std::string& path) {
    Index node = kNone;
    for (std::size_t end = 0; end < path.size();) {
        const std::size_t begin = end + 1;
        end = std::min(path.find('/', begin), path.size());
        const std::string ancestor = path.substr(0, end);
        const Index existing = findNode(scene, ancestor);
        node = existing != kNone ? existing : addNode(scene, node, path.substr(begin, end - begin), ancestor);
    }
    return node;
}

Index parentOf(Scene& scene, const GltfLayer& layer) {
    const std::string& at = layer.at.value;
    if (at.find("//") != std::string::npos)
        throw Error(ErrorKind::Input, layer.at.place.text(), fmt::format("\"{}\" has an empty part", at),
                    "write one '/' between names");
    const bool existed = at.empty() || findNode(scene, at) != kNone;
    Index parent = nodeAt(scene, at);
    if (isIdentity(layer.transform)) return parent;
    if (existed) {
        const std::string name = layer.file.value.stem().string();
        const std::string above = parent == kNone ? "" : scene.nodes[static_cast<std::size_t>(parent)].path;
        parent = addNode(scene, parent, name, freePath(scene, above + "/" + name));
    }
    setTransform(scene.nodes[static_cast<std::size_t>(parent)], layer.transform);
    return parent;
}

}  // namespace

void addLayer(Scene& scene, const GltfLayer& layer, GltfOptions options) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(layer.file.value, ignored))
        throw Error(ErrorKind::Input, layer.file.place.text(),
                    fmt::format("there is no file {}", layer.file.value.string()),
                    "paths are read from the folder of the sequence file");
    if (!layer.scene.value.empty()) options.scene = layer.scene.value;
    Scene loaded = loadGltf(layer.file.value, options);
    const Index parent = parentOf(scene, layer);
    appendScene(scene, std::move(loaded), parent);
}

}  // namespace umbrage
