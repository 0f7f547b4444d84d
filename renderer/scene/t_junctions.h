// SPDX-License-Identifier: Apache-2.0
// Where a mesh only looks closed: a corner of one triangle in the middle of another's edge. Shadow volumes of such
// meshes are right, but both edges are open, so they are counted whole instead of halved.
#pragma once

#include <cstddef>

#include "scene/topology.h"

namespace umbrage {

/// Ends of open edges that lie within another open edge, to 2^-20 of its length.
std::size_t countTJunctions(const Mesh& mesh, const MeshTopology& topology);

}  // namespace umbrage
