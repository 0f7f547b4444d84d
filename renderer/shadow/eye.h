// SPDX-License-Identifier: Apache-2.0
// The camera of a frame as shadows and shading see it, in double, and its float form for the device.
#pragma once

#include <glm/glm.hpp>

#include "scene/moment.h"
#include "shaders/shared.h"

namespace umbrage {

struct Eye {
    glm::dmat4 viewFromWorld{1.0};
    glm::dmat4 worldFromView{1.0};
    glm::dmat4 clipFromView{1.0};  // reversed depth in [0, 1]; perspective: infinite; see VIEWPORT_SCALE
    bool perspective = true;
    double znear = 0.1, zfar = 0.0;  // zfar 0: infinite
    glm::dvec2 rayScale{1.0};        // half extent of the image at distance 1 (perspective) or in metres
    glm::dvec2 shift{0.0};           // NDC: what a place on the picture shows lies there without (PlacedCamera)
    double ledge = 0.0;              // share of the depth range before the near plane (shadow/ledge.h)

    /// What the depth buffer is cleared to: nothing is seen beyond zfar, and nothing is clipped there either, so that
    /// what casts from beyond is whole (T12).
    float emptyDepth() const { return perspective && zfar > 0.0 ? float((1.0 - ledge) * znear / zfar) : 0.0f; }

    glm::dvec3 position() const { return glm::dvec3(worldFromView[3]); }
    /// Homogeneous: the eye, or for an orthographic camera the direction towards the viewer, w = 0.
    glm::dvec4 point() const { return perspective ? worldFromView[3] : worldFromView[2]; }
};

/// The image's aspect ratio wins over the camera's: the vertical field of view (or ymag) is kept (T12).
Eye makeEye(const PlacedCamera& camera, int width, int height);

/// Everything but lights, ambient and background.
gpu::ViewData viewDataOf(const Eye& eye);

}  // namespace umbrage
