// SPDX-License-Identifier: Apache-2.0
#include "bench/shadow_map_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "scene/aim.h"

namespace umbrage {
namespace {

class Range3 {
public:
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

/// The corners of a box's view between two distances along the view axis.
std::array<glm::dvec3, 8> cornersOfView(const Eye& eye, double from, double to) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 ndc = glm::dvec2(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0) + eye.shift;
        const double distance = i & 4 ? to : from;
        const glm::dvec2 aside = ndc * eye.rayScale * (eye.perspective ? distance : 1.0);
        corners[i] = glm::dvec3(eye.worldFromView * glm::dvec4(aside, -distance, 1.0));
    }
    return corners;
}

Eye perspectiveFace(const glm::dvec3& from, const glm::dquat& rotation, double angle, double farthest) {
    PlacedCamera camera;
    camera.camera.yfov = 2.0 * angle;
    camera.camera.znear = 1e-6 * farthest;  // costs a reversed float nothing
    camera.camera.zfar = 0.0;
    camera.worldFromCamera = glm::mat4_cast(rotation);
    camera.worldFromCamera[3] = glm::dvec4(from, 1.0);
    return makeEye(camera, 1, 1);
}

/// As small as what is seen allows, as deep as what casts.
std::vector<Eye> directionalFace(const glm::dvec3& direction, std::span<const Geometry::Bounds> boxes,
                                 const std::vector<bool>& unseen, const Eye& eye) {
    const glm::dquat worldFromLight = lookRotation(direction), lightFromWorld = glm::conjugate(worldFromLight);
    Range3 casters, receivers, view, depths;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const glm::dvec3& corner : cornersOf(boxes[i])) {
            const glm::dvec3 p = lightFromWorld * corner;
            casters.add(p);
            if (unseen[i]) continue;
            receivers.add(p);
            depths.add(glm::dvec3(eye.viewFromWorld * glm::dvec4(corner, 1.0)));
        }
    }
    const double from = std::max(eye.znear, -depths.high.z), to = -depths.low.z;
    if (!(to > from)) return {};
    for (const glm::dvec3& corner : cornersOfView(eye, from, to)) view.add(lightFromWorld * corner);
    const glm::dvec3 low = glm::max(receivers.low, view.low), high = glm::min(receivers.high, view.high);
    const glm::dvec2 half = 0.5 * glm::dvec2(high - low);
    if (!(half.x > 0.0 && half.y > 0.0)) return {};
    PlacedCamera camera;
    camera.camera.perspective = false;
    camera.camera.ymag = half.y;
    camera.camera.znear = 0.0;
    camera.camera.zfar = (casters.high.z - low.z) * (1.0 + 1e-6);
    camera.worldFromCamera = glm::mat4_cast(worldFromLight);
    const glm::dvec3 middle(0.5 * glm::dvec2(low + high), casters.high.z);
    camera.worldFromCamera[3] = glm::dvec4(worldFromLight * middle, 1.0);
    Eye face = makeEye(camera, 1, 1);
    face.rayScale.x = half.x;
    face.clipFromView[0][0] = 1.0 / (VIEWPORT_SCALE * half.x);
    return {face};
}

}  // namespace

std::vector<Eye> shadowMapFaces(const PlacedLight& light, std::span<const Geometry::Bounds> boxes,
                                const std::vector<bool>& unseen, const Eye& eye) {
    if (light.light.type == LightType::Directional) return directionalFace(light.direction, boxes, unseen, eye);
    double farthest = 0.0;
    for (const Geometry::Bounds& box : boxes) {
        for (const glm::dvec3& corner : cornersOf(box)) {
            farthest = std::max(farthest, glm::distance(corner, light.position));
        }
    }
    const double cone = light.light.type == LightType::Spot ? double(light.light.outerConeAngle) : HUGE_VAL;
    if (cone <= kWidestSpot) {
        return {perspectiveFace(light.position, lookRotation(light.direction), cone, farthest)};
    }
    std::vector<Eye> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 direction(0.0);
            direction[axis] = sign;
            faces.push_back(perspectiveFace(light.position, lookRotation(direction), std::atan(1.0), farthest));
        }
    }
    return faces;
}

}  // namespace umbrage
