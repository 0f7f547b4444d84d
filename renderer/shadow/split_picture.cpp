// SPDX-License-Identifier: Apache-2.0
#include "shadow/split_picture.h"

#include <algorithm>

namespace umbrage {
namespace {

constexpr float kHidden = 0.25f;  // weight of a plane where something stands before it

double depthAt(const Eye& eye, double distance) {
    return eye.perspective ? eye.znear / distance : (eye.zfar - distance) / (eye.zfar - eye.znear);
}

/// Depth of a plane (not turned) at a place, or -1 where it is not in the part's shadow.
double depthInShadow(const glm::dvec4& plane, std::span<const glm::dvec4> shadow, const glm::dvec2& ndc) {
    const double depth = -(plane.x * ndc.x + plane.y * ndc.y + plane.w) / plane.z;
    const bool inside = depth > 0.0 && depth < 1.0 && std::all_of(shadow.begin(), shadow.end(), [&](const auto& p) {
                            return glm::dot(p, glm::dvec4(ndc, depth, 1.0)) >= 0.0;
                        });
    return inside ? depth : -1.0;
}

}  // namespace

void SplitPicture::add(const LightParts& parts, const Homogeneous& light, const Eye& eye, const glm::vec3& color,
                       std::span<const float> distances) {
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
        double perimeter = 0.0;
        const std::vector<glm::dvec4> shadow = shadowOnScreen(parts.extremes[p], light, eye, perimeter);
        const glm::dvec4 plane = screenPlane(parts.parts[p], light, eye).plane;
        if (plane.z == 0.0) continue;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::dvec2 ndc(2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height);
                const double depth = depthInShadow(plane, shadow, ndc);
                if (depth < 0.0) continue;
                const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
                const float weight = depth > depthAt(eye, distances[i]) ? 1.0f : kHidden;
                for (int k = 0; k < 3; ++k) values[4 * i + std::size_t(k)] += weight * color[k];
                values[4 * i + 3] += weight;
            }
        }
    }
}

}  // namespace umbrage
