// SPDX-License-Identifier: Apache-2.0
#include "shading/lights.h"

#include <algorithm>
#include <cmath>

namespace umbrage {

bool isOn(const Light& light) {
    return light.intensity > 0.0f && (light.color.r > 0.0f || light.color.g > 0.0f || light.color.b > 0.0f);
}

gpu::LightData lightData(const PlacedLight& placed, const Eye& eye) {
    const Light& light = placed.light;
    gpu::LightData data{};
    data.position = gpu::vec4(eye.viewFromWorld * shadowLight(placed));
    if (light.type == LightType::Directional) data.position = {glm::normalize(glm::vec3(data.position)), 0.0f};
    const float range = light.rangeMetres;
    data.direction = gpu::vec4(eye.viewFromWorld * glm::dvec4(placed.direction, 0.0));
    data.direction.w = range > 0.0f ? 1.0f / (range * range) : 0.0f;
    data.color = {light.color, isOn(light) ? light.intensity : 0.0f};
    data.cone = {0.0f, 1.0f};
    if (light.type == LightType::Spot) {
        const double inner = std::cos(double(light.innerConeAngle)), outer = std::cos(double(light.outerConeAngle));
        const double scale = 1.0 / std::max(0.001, inner - outer);  // as KHR_lights_punctual recommends
        data.cone = {float(scale), float(-outer * scale)};
    }
    return data;
}

ShadowLight shadowLight(const PlacedLight& placed) {
    return placed.light.type == LightType::Directional ? glm::dvec4(-placed.direction, 0.0)
                                                       : glm::dvec4(placed.position, 1.0);
}

LightReach lightReach(const PlacedLight& placed, const ShadowLight& light) {
    LightReach reach{light, placed.light.rangeMetres};
    if (placed.light.type == LightType::Spot) {
        reach.axis = placed.direction;
        reach.coneAngle = placed.light.outerConeAngle;
    }
    return reach;
}

bool parallelToView(const PlacedLight& placed, const Eye& eye) {
    if (eye.perspective || placed.light.type != LightType::Directional) return false;
    const glm::dvec3 direction(eye.viewFromWorld * glm::dvec4(placed.direction, 0.0));
    return std::hypot(direction.x, direction.y) < 0x1p-24;
}

}  // namespace umbrage
