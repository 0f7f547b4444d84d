// SPDX-License-Identifier: Apache-2.0
#include "shadow/extent.h"

#include <algorithm>
#include <limits>

namespace umbrage {
LightExtent::LightExtent(std::span<const Geometry::Bounds> receivers, const LightReach& reach, const Eye& eye)
    : light_(reach.light) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kInfinity), high(-kInfinity);
    for (const Geometry::Bounds& box : receivers) {
        if (outOfReach(box, reach)) continue;
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    const Geometry::Bounds reached = boxOf(reach);
    low = glm::max(low, reached.low);
    high = glm::min(high, reached.high);
    if (eye.perspective) {
        low = glm::min(low, eye.position());
        high = glm::max(high, eye.position());
    }
    // Far beyond what the floats of corners can miss.
    const double margin = 1e-2 * glm::length(high - low);
    for (std::size_t k = 0; k < 3; ++k) {
        const int axis = int(k);
        faces_[2 * k].normal[axis] = 1.0;
        faces_[2 * k].offset = high[axis] + margin;
        faces_[2 * k + 1].normal[axis] = -1.0;
        faces_[2 * k + 1].offset = margin - low[axis];
    }
    for (std::size_t face = 0; face < kFaces; ++face) {
        open_[face] = !eye.perspective && glm::dot(faces_[face].normal, glm::dvec3(eye.point())) > 0.0;
    }
}

std::uint32_t LightExtent::endOf(const BoxCorners& caster) const {
    constexpr double kLeastSlope = 0.02;  // flatter ones end far away, where floats are coarse
    std::uint32_t best = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t face = 0; face < kFaces; ++face) {
        if (open_[face]) continue;
        double longest = 0.0;
        for (const glm::dvec3& corner : caster) {
            const glm::dvec3 away = corner * light_.w - glm::dvec3(light_);
            const double slope = glm::dot(faces_[face].normal, away), length = glm::length(away);
            const double before = faces_[face].offset - glm::dot(faces_[face].normal, corner);
            longest = std::max(longest, slope > kLeastSlope * length && before > 0.0
                                            ? before / slope * length
                                            : std::numeric_limits<double>::infinity());
        }
        if (longest >= shortest) continue;
        shortest = longest;
        best = std::uint32_t(1 + face);
    }
    return best;
}

std::array<glm::vec4, LightExtent::kFaces> LightExtent::facesInView(const Eye& eye) const {
    std::array<glm::vec4, kFaces> faces;
    for (std::size_t face = 0; face < kFaces; ++face) {
        const HalfSpace& own = faces_[face];
        const glm::dvec3 normal(eye.viewFromWorld * glm::dvec4(own.normal, 0.0));
        const glm::dvec3 onFace(eye.viewFromWorld * glm::dvec4(own.offset * own.normal, 1.0));
        faces[face] = glm::vec4(glm::dvec4(normal, glm::dot(normal, onFace)));
    }
    return faces;
}

std::array<HalfSpace, 4> sidesOfView(const Eye& eye) {
    std::array<HalfSpace, 4> sides;
    for (std::size_t k = 0; k < 4; ++k) {
        const int axis = int(k / 2);
        const double sign = k % 2 ? -1.0 : 1.0;
        glm::dvec3 normal(0.0);
        normal[axis] = sign;
        const double border = (1.0 + sign * eye.shift[axis]) * eye.rayScale[axis];
        if (eye.perspective) normal.z = border;  // x <= -z * border
        sides[k].normal = glm::normalize(glm::dvec3(eye.worldFromView * glm::dvec4(normal, 0.0)));
        glm::dvec3 onSide(0.0);
        if (!eye.perspective) onSide[axis] = sign * border;
        sides[k].offset = glm::dot(sides[k].normal, glm::dvec3(eye.worldFromView * glm::dvec4(onSide, 1.0)));
    }
    return sides;
}

bool outOfView(const BoxCorners& box, std::span<const HalfSpace> sidesOfView) {
    return std::ranges::any_of(sidesOfView, [&](const HalfSpace& side) {
        return std::ranges::all_of(box, [&](const glm::dvec3& corner) {
            const double margin = 1e-6 * (glm::length(corner) + std::abs(side.offset));
            return glm::dot(side.normal, corner) - side.offset > margin;
        });
    });
}

bool outOfView(const BoxCorners& caster, const ShadowLight& light, std::span<const HalfSpace> sidesOfView) {
    return std::any_of(sidesOfView.begin(), sidesOfView.end(), [&](const HalfSpace& side) {
        return std::all_of(caster.begin(), caster.end(), [&](const glm::dvec3& corner) {
            const glm::dvec3 away = corner * light.w - glm::dvec3(light);
            const double beyond = glm::dot(side.normal, corner) - side.offset;
            const double margin = 1e-6 * (glm::length(corner) + std::abs(side.offset));
            return beyond > margin && glm::dot(side.normal, away) >= 1e-6 * glm::length(away);
        });
    });
}

}  // namespace umbrage
