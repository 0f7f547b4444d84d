// SPDX-License-Identifier: Apache-2.0
// The stage of stress family C: casters that float above a ground, and what several of them are made with.
#pragma once

#include "numbers.h"
#include "stress/parts.h"
#include "stress/stress.h"

namespace generator::stress {

inline const std::string kAsWithRays = "as with rays; pixels at a shadow's edge may differ by rounding";

/// A look down at casters one to three metres above the ground, lit by two lights.
std::string lookDown(const std::string& frames = "1", int samples = 1);

/// A case whose casters are one mesh of a double-sided material.
Case floating(const std::string& id, const std::string& what, const std::string& answer, const std::string& catches,
              const std::function<Mesh()>& make);

Mesh oddlyPlaced(Mesh mesh, const dvec3& centre);
/// Three vertices a triangle.
Mesh unshared(const Mesh& mesh);
/// Evenly in the unit ball.
dvec3 inBall(Random& random);

}  // namespace generator::stress
