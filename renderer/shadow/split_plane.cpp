// SPDX-License-Identifier: Apache-2.0
#include "shadow/split_plane.h"

namespace umbrage {
namespace {

/// From a point towards a homogeneous one; not normalised.
glm::dvec3 towards(const Homogeneous& to, const glm::dvec3& from) {
    return to.w == 0.0 ? glm::dvec3(to) : glm::dvec3(to) - to.w * from;
}

Plane through(const glm::dvec3& p, const glm::dvec3& normal) {
    return {normal, -glm::dot(normal, p)};
}

}  // namespace

Plane pointCameraLight(const glm::dvec3& p, const Homogeneous& eye, const Homogeneous& light) {
    // The paper crosses (c - l) with (p - l); (c - p) differs from (c - l) by a multiple of (p - l), and stays finite
    // for a directional light.
    const glm::dvec3 alongLight = towards(light, p);
    return through(p, glm::cross(glm::cross(towards(eye, p), alongLight), alongLight));
}

Plane pointPointLight(const glm::dvec3& p1, const glm::dvec3& p2, const Homogeneous& light) {
    return through(p1, glm::cross(p2 - p1, towards(light, p1)));
}

SplitPlaneKind automaticKind(const PartShape& shape, const Homogeneous& light) {
    constexpr double kThin = 4.0;
    if (shape.thinness < kThin) return SplitPlaneKind::PointCameraLight;
    const glm::dvec3 axis = shape.axisEnds[1] - shape.axisEnds[0];
    const glm::dvec3 ray = towards(light, shape.center());
    // Seen from the light a part is shorter by this sine, but no thinner; pointing at the light it spans no plane.
    const double sine = glm::length(glm::cross(axis, ray)) / (glm::length(axis) * glm::length(ray));
    return sine * shape.thinness >= kThin ? SplitPlaneKind::PointPointLight : SplitPlaneKind::PointCameraLight;
}

Plane splitPlane(const PartShape& shape, const SplitChoice& choice, const Homogeneous& eye, const Homogeneous& light) {
    if (choice.points) return pointPointLight((*choice.points)[0], (*choice.points)[1], light);
    if (choice.kind.value_or(automaticKind(shape, light)) == SplitPlaneKind::PointPointLight) {
        return pointPointLight(shape.axisEnds[0], shape.axisEnds[1], light);
    }
    return pointCameraLight(shape.center(), eye, light);
}

ScreenPlane screenPlane(const Plane& plane, const Eye& eye) {
    const Plane inView = glm::transpose(eye.worldFromView) * plane;
    glm::dvec4 onScreen;
    if (eye.perspective) {
        // What is seen lies at (x sx, y sy, -1) znear / depth: multiplied by depth / znear, which is not negative.
        onScreen = {inView.x * eye.rayScale.x, inView.y * eye.rayScale.y, inView.w / eye.znear, -inView.z};
    } else {
        // It lies at (x sx, y sy, depth (zfar - znear) - zfar).
        onScreen = {inView.x * eye.rayScale.x, inView.y * eye.rayScale.y, inView.z * (eye.zfar - eye.znear),
                    inView.w - inView.z * eye.zfar};
    }
    // With reversed depth the eye is at (0, 0, +1, 0) on screen (the paper has it at -1).
    return {onScreen.z < 0.0 ? -onScreen : onScreen.z > 0.0 ? onScreen : glm::dvec4(0.0)};
}

}  // namespace umbrage
