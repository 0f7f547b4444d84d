// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <charconv>
#include <glm/trigonometric.hpp>

#include "error.h"
#include "job/nearest.h"
#include "scene/aim.h"
#include "scene/compose_parts.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

Index addDescribed(Scene& scene, const JobCamera& described) {
    const Index node = addNode(scene, kNone, "camera", freePath(scene, "/camera"));
    scene.nodes.back().camera = static_cast<Index>(scene.cameras.size());
    scene.cameras.push_back({.name = "camera",
                             .perspective = described.perspective,
                             .yfov = glm::radians(described.yfovDegrees),
                             .xmag = described.ymag,  // the image's aspect ratio decides (T12)
                             .ymag = described.ymag,
                             .znear = described.znear,
                             .zfar = described.zfar});
    aim(scene, node, described.position, &described.target, described.interpolation);
    return node;
}

/// By path, by the name of node or camera, by index among the nodes with a camera; in this order.
std::vector<Index> camerasCalled(const Scene& scene, const std::string& wanted, const std::vector<Index>& nodes) {
    std::vector<Index> found;
    for (const Index index : nodes)
        if (scene.nodes[static_cast<std::size_t>(index)].path == wanted) return {index};
    for (const Index index : nodes) {
        const Node& node = scene.nodes[static_cast<std::size_t>(index)];
        if (node.name == wanted || scene.cameras[static_cast<std::size_t>(node.camera)].name == wanted)
            found.push_back(index);
    }
    std::size_t number = 0;
    const auto [end, status] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (found.empty() && status == std::errc{} && end == wanted.data() + wanted.size() && number < nodes.size())
        return {nodes[number]};
    return found;
}

std::vector<std::string> pathsOf(const Scene& scene, const std::vector<Index>& nodes) {
    std::vector<std::string> paths;
    for (const Index node : nodes) paths.push_back(scene.nodes[static_cast<std::size_t>(node)].path);
    return paths;
}

}  // namespace

Index chooseCamera(Scene& scene, const JobCamera& camera) {
    if (camera.described) return addDescribed(scene, camera);
    const std::vector<Index> nodes = nodesWith(scene, &Node::camera);
    const std::string& wanted = camera.node.value;
    if (wanted.empty()) return nodes.empty() ? kNone : nodes.front();

    const std::vector<Index> found = camerasCalled(scene, wanted, nodes);
    if (found.size() == 1) return found.front();
    const std::string where = camera.node.place.text();
    if (found.size() > 1)
        throw Error(ErrorKind::Input, where, fmt::format("{} cameras are called \"{}\"", found.size(), wanted),
                    fmt::format("name one by its path: {}", fmt::join(pathsOf(scene, found), ", ")));
    const bool isNode = findNode(scene, wanted) != kNone;
    throw Error(
        ErrorKind::Input, where,
        isNode ? fmt::format("the node {} has no camera", wanted) : fmt::format("there is no camera \"{}\"", wanted),
        nodes.empty() ? "the scene has no camera; leave it out, or describe one with position and target"
                      : hintForName(wanted, pathsOf(scene, nodes)));
}

}  // namespace umbrage
