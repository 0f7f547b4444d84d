// SPDX-License-Identifier: Apache-2.0
// Nodes by their paths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "job/glob.h"
#include "job/job.h"
#include "scene/scene.h"

namespace umbrage {

/// The node of that path, or kNone.
Index findNode(const Scene& scene, std::string_view path);

/// `path`, or with an index behind it where a node of `scene` has it already.
std::string freePath(const Scene& scene, const std::string& path);

/// Adds a node at the end. @param parent  kNone for a root
Index addNode(Scene& scene, Index parent, const std::string& name, const std::string& path);

/// Nodes that have something: &Node::light, &Node::mesh, &Node::camera.
std::vector<Index> nodesWith(const Scene& scene, Index Node::*what);

/// Throws Error(Input) at the place of a glob that matches no node with a `noun`. @param paths  of those there are
[[noreturn]] void refuseGlob(const Located<std::string>& glob, const std::string& noun,
                             const std::vector<std::string>& paths);

/// Those of them that the glob matches. @throws Error(Input) at the glob's place if there is none
/// @param noun  what they have, for the message: "light"
std::vector<Index> matchingNodes(const Scene& scene, const Located<std::string>& glob, Index Node::*what,
                                 const std::string& noun);

}  // namespace umbrage
