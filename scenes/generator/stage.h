// SPDX-License-Identifier: Apache-2.0
// What most scenes need around their casters: a ground, lights and cameras that move along keys.
#pragma once

#include <functional>
#include <vector>

#include "document.h"

namespace generator {

inline constexpr double kSequenceSeconds = 2.0;  // 48 frames at 24 a second

/// A flat square of cells x cells in the plane y = 0, a receiver.
void addGround(Document& document, double halfSize, int cells, const dvec3& color);

/// A light of its own node, moving linearly through `positions`, evenly over the sequence; one position: at rest.
int addMovingLight(Document& document, const LightSpec& spec, const std::vector<dvec3>& positions);

/// A spot or directional light that shines from `from` to `to`; successive targets turn it.
int addAimedLight(Document& document, const LightSpec& spec, const dvec3& from, const std::vector<dvec3>& to);

/// A camera that glides through the positions (a spline) and looks at the targets, both evenly over the sequence.
/// One position: at rest.
int addCamera(Document& document, const char* name, double yfovDegrees, double znear,
              const std::vector<dvec3>& positions, const std::vector<dvec3>& targets);

/// A node whose mesh is one closed shape in one material.
int addSolid(Document& document, const char* name, const Shape& shape, int material,
             const dvec3& translation = dvec3(0), double creaseDegrees = 40);

/// Keys for a rotation that swings or turns: `degreesAt(t)` about `axis`, t in [0, 1] over the sequence.
void swing(Document& document, int node, const dvec3& axis, int keys, const std::function<double(double)>& degreesAt,
           const dquat& rest = {1, 0, 0, 0});

}  // namespace generator
