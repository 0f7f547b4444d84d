// SPDX-License-Identifier: Apache-2.0
#include "shadow/eye.h"

#include <cmath>

#include "shadow/ledge.h"

namespace umbrage {

Eye makeEye(const PlacedCamera& placed, int width, int height) {
    const Camera& camera = placed.camera;
    const double aspect = double(width) / double(height);
    Eye eye;
    eye.worldFromView = placed.worldFromCamera;
    eye.viewFromWorld = glm::inverse(placed.worldFromCamera);
    eye.perspective = camera.perspective;
    eye.znear = camera.znear;
    eye.zfar = camera.zfar;
    const double halfHeight = camera.perspective ? std::tan(0.5 * camera.yfov) : camera.ymag;
    eye.rayScale = {halfHeight * aspect, halfHeight};
    eye.shift = placed.shiftPixels * glm::dvec2(2.0 / width, -2.0 / height);

    glm::dmat4& clip = eye.clipFromView;
    clip = glm::dmat4(0.0);
    clip[0][0] = 1.0 / (VIEWPORT_SCALE * eye.rayScale.x);
    clip[1][1] = 1.0 / (VIEWPORT_SCALE * eye.rayScale.y);
    if (camera.perspective) {
        clip[3][2] = camera.znear;  // z_clip = znear, w_clip = -z
        clip[2][3] = -1.0;
        clip[2][0] = eye.shift.x / VIEWPORT_SCALE;
        clip[2][1] = eye.shift.y / VIEWPORT_SCALE;
    } else {
        clip[2][2] = 1.0 / (camera.zfar - camera.znear);  // depth = (zfar - e) / (zfar - znear), e = -z
        clip[3][2] = camera.zfar / (camera.zfar - camera.znear);
        clip[3][3] = 1.0;
        clip[3][0] = -eye.shift.x / VIEWPORT_SCALE;
        clip[3][1] = -eye.shift.y / VIEWPORT_SCALE;
    }
    return eye;
}

gpu::ViewData viewDataOf(const Eye& eye) {
    gpu::ViewData data{};
    data.clipFromView = glm::mat4(eye.clipFromView);
    data.rayScale = {glm::vec2(eye.rayScale), 0.0f, 0.0f};
    data.upInView = glm::vec4(eye.viewFromWorld * glm::dvec4(0.0, 1.0, 0.0, 0.0));
    data.znear = float(eye.znear);
    data.zfar = float(eye.zfar);
    data.perspective = eye.perspective;
    data.emptyDepth = eye.emptyDepth();
    data.capDistance = float(capDistance(eye));
    data.shift = glm::vec2(eye.shift);
    data.sceneDepths = float(1.0 - eye.ledge);
    return data;
}

}  // namespace umbrage
