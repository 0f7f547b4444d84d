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

SplitPoints splitPoints(const PartShape& shape, const SplitChoice& choice, const Homogeneous& light) {
    using Kind = SplitPoints::Kind;
    if (choice.points) return {{(*choice.points)[0], (*choice.points)[1]}, Kind::PointPointLight};
    if (choice.kind.value_or(automaticKind(shape, light)) == SplitPlaneKind::PointPointLight) {
        return {{shape.axisEnds[0], shape.axisEnds[1]}, Kind::PointPointLight};
    }
    return {{shape.center(), glm::dvec3(0.0)}, Kind::PointCameraLight};
}

Plane splitPlane(const PartShape& shape, const SplitChoice& choice, const Homogeneous& eye, const Homogeneous& light) {
    const SplitPoints made = splitPoints(shape, choice, light);
    return made.kind == SplitPoints::Kind::PointPointLight ? pointPointLight(made.points[0], made.points[1], light)
                                                           : pointCameraLight(made.points[0], eye, light);
}

glm::dvec4 onScreen(const Plane& plane, const Eye& eye) {
    const Plane inView = glm::transpose(eye.worldFromView) * plane;
    const double x = inView.x * eye.rayScale.x, y = inView.y * eye.rayScale.y;
    // What is seen lies at (x sx, y sy, -1) znear / depth: multiplied by depth / znear, which is not negative.
    if (eye.perspective) return {x, y, inView.w / eye.znear, -inView.z};
    // It lies at (x sx, y sy, depth (zfar - znear) - zfar).
    return {x, y, inView.z * (eye.zfar - eye.znear), inView.w - inView.z * eye.zfar};
}

ScreenPlane screenPlane(const Plane& plane, const Eye& eye) {
    const glm::dvec4 p = onScreen(plane, eye);
    // With reversed depth the eye is at (0, 0, +1, 0) on screen (the paper has it at -1).
    return {p.z < 0.0 ? -p : p.z > 0.0 ? p : glm::dvec4(0.0)};
}

ScreenPlane screenPlane(const SplitPoints& made, const Homogeneous& light, const Eye& eye) {
    switch (made.kind) {
        case SplitPoints::Kind::PointPointLight:
            return screenPlane(pointPointLight(made.points[0], made.points[1], light), eye);
        case SplitPoints::Kind::Nowhere:
            return {{0.0, 0.0, 0.0, 1.0}};
        default:
            return screenPlane(pointCameraLight(made.points[0], eye.point(), light), eye);
    }
}

}  // namespace umbrage
