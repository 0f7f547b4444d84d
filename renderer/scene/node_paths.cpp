// SPDX-License-Identifier: Apache-2.0
#include "scene/node_paths.h"

#include <fmt/core.h>

#include <algorithm>

#include "error.h"
#include "job/nearest.h"

namespace umbrage {

Index findNode(const Scene& scene, std::string_view path) {
    const auto found =
        std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) { return node.path == path; });
    return found == scene.nodes.end() ? kNone : static_cast<Index>(found - scene.nodes.begin());
}

std::string freePath(const Scene& scene, const std::string& path) {
    std::string candidate = path;
    for (int i = 1; findNode(scene, candidate) != kNone; ++i) candidate = fmt::format("{}_{}", path, i);
    return candidate;
}

Index addNode(Scene& scene, Index parent, const std::string& name, const std::string& path) {
    const auto index = static_cast<Index>(scene.nodes.size());
    Node& node = scene.nodes.emplace_back();
    node.name = name;
    node.path = path;
    node.parent = parent;
    if (parent != kNone) scene.nodes[static_cast<std::size_t>(parent)].children.push_back(index);
    return index;
}

std::vector<Index> nodesWith(const Scene& scene, Index Node::*what) {
    std::vector<Index> found;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].*what != kNone) found.push_back(static_cast<Index>(i));
    return found;
}

void refuseGlob(const Located<std::string>& glob, const std::string& noun, const std::vector<std::string>& paths) {
    throw Error(ErrorKind::Input, glob.place.text(), fmt::format("\"{}\" matches no node with a {}", glob.value, noun),
                paths.empty() ? fmt::format("the scene has no {}", noun) : hintForName(glob.value, paths));
}

std::vector<Index> matchingNodes(const Scene& scene, const Located<std::string>& glob, Index Node::*what,
                                 const std::string& noun) {
    std::vector<Index> matching;
    std::vector<std::string> paths;
    for (const Index index : nodesWith(scene, what)) {
        const std::string& path = scene.nodes[static_cast<std::size_t>(index)].path;
        if (matchesGlob(glob.value, path)) matching.push_back(index);
        paths.push_back(path);
    }
    if (matching.empty()) refuseGlob(glob, noun, paths);
    return matching;
}

}  // namespace umbrage
