// SPDX-License-Identifier: Apache-2.0
#include "shadow/ledge.h"

namespace umbrage {

double nearPlaneWithLedge(const DepthRange& scene, double nearest) {
    const auto& [n, f, N, F] = scene;
    return (f - n) * F * N / (f * F - n * N - nearest * (F - N));
}

double capDistance(const Eye& eye) {
    const double depth = 1.0 - 0.5 * eye.ledge;  // in the whole range
    if (eye.perspective) return nearPlaneWithLedge(eye.znear, eye.ledge) / depth;
    return eye.zfar - depth / (1.0 - eye.ledge) * (eye.zfar - eye.znear);
}

}  // namespace umbrage
