// SPDX-License-Identifier: Apache-2.0
// The ledge (Kilgard 2001): a part of the depth range before what is seen, for the caps of volumes that are cut before
// the near plane. Volumes are drawn into the whole range with a nearer near plane, so that depths stay comparable.
#pragma once

#include "shadow/eye.h"

namespace umbrage {

/// Forward depths in [0, 1], the scene's in [n, f] between planes at distances N and F.
struct DepthRange {
    double n = 0.0, f = 1.0, N = 0.1, F = 100.0;
};

/// The near plane that makes depths in [nearest, f] comparable with those of the scene. As printed, the term with
/// `nearest` has the wrong sign: with nearest = n that does not give N.
double nearPlaneWithLedge(const DepthRange& scene, double nearest);

/// The same where depth is reversed and infinite: the scene's in [0, 1 - ledge], volumes' in [0, 1].
inline double nearPlaneWithLedge(double znear, double ledge) {
    return (1.0 - ledge) * znear;
}

/// Distance along the view axis of the plane whose depth is in the middle of the ledge; without one of that before
/// which nothing is seen.
double capDistance(const Eye& eye);

}  // namespace umbrage
