// SPDX-License-Identifier: Apache-2.0
// Known geometry under an eye that looks straight down at the ground, y = 0, on which 16 pixels are a metre.
#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "judge/explain.h"

namespace umbrage {

using oracle::Corners;
using oracle::kNothing;

inline constexpr int kStageSize = 128;
inline constexpr double kEyeHeight = 20.0;

inline double pixelOf(double metres) {
    return 64.0 + 16.0 * metres;
}

inline PlacedLight directional(const glm::dvec3& direction) {
    PlacedLight light;
    light.light.type = LightType::Directional;
    light.direction = glm::normalize(direction);
    return light;
}

inline PlacedLight pointLight(const glm::dvec3& position, float range = 0.0f) {
    PlacedLight light;
    light.light.type = LightType::Point;
    light.light.rangeMetres = range;
    light.position = position;
    return light;
}

inline PlacedLight spotLight(const glm::dvec3& position, const glm::dvec3& direction, double outerCone) {
    PlacedLight light = pointLight(position);
    light.light.type = LightType::Spot;
    light.light.outerConeAngle = float(outerCone);
    light.direction = glm::normalize(direction);
    return light;
}

inline std::vector<Corners> square(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    return {Corners{a, b, c}, Corners{a, c, d}};
}

/// Level, facing up, between two corners.
inline std::vector<Corners> level(double x0, double z0, double x1, double z1, double y) {
    return square({x0, y, z0}, {x0, y, z1}, {x1, y, z1}, {x1, y, z0});
}

class Stage {
public:
    /// The ground is always there.
    explicit Stage(std::initializer_list<std::vector<Corners>> pieces, bool perspective = false, double near = 0.1)
        : oracle_(trianglesOf(pieces)),
          rays_(eye(perspective, near), kStageSize, kStageSize),
          explainer_(oracle_, rays_, Tolerance{}, kEyeHeight) {}

    std::uint32_t seen(double x, double y) const { return oracle_.see(rays_.at(x, y)); }

    bool exact(const PlacedLight& light, double x, double y) const {
        return exactly(oracle_, JudgedLight(light), seen(x, y), rays_.at(x, y)).reaches;
    }

    /// Of the wrong mask at a place of the picture.
    SampleVerdict ofWrongMask(const PlacedLight& light, double x, double y) const {
        return ofWrongMask(light, x, y, seen(x, y));
    }
    /// @param claimed  the triangle that the renderer says is seen
    SampleVerdict ofWrongMask(const PlacedLight& light, double x, double y, std::uint32_t claimed) const {
        return explainer_.explainMask(JudgedLight(light), {x, y, seen(x, y), claimed}, !exact(light, x, y));
    }

    bool explainsCount(const PlacedLight& light, double x, double y, std::uint32_t count) const {
        return explainer_.explainsCount(JudgedLight(light), {x, y, seen(x, y), seen(x, y)},
                                        [=](std::uint32_t layers) { return layers == count; });
    }

    bool changesNearby(const PlacedLight& light, double x, double y) const {
        return explainer_.changesNearby(JudgedLight(light), {x, y, seen(x, y), seen(x, y)}, exact(light, x, y));
    }

private:
    static std::vector<oracle::Triangle> trianglesOf(std::initializer_list<std::vector<Corners>> pieces) {
        std::vector<oracle::Triangle> triangles;
        const auto add = [&](const std::vector<Corners>& piece) {
            for (const Corners& corners : piece) triangles.emplace_back().corners = corners;
        };
        add(level(-10, -10, 10, 10, 0.0));
        for (const std::vector<Corners>& piece : pieces) add(piece);
        return triangles;
    }

    static PlacedCamera eye(bool perspective, double near) {
        PlacedCamera placed;
        placed.camera.perspective = perspective;
        placed.camera.xmag = placed.camera.ymag = 4.0;
        placed.camera.yfov = 2.0 * std::atan(4.0 / kEyeHeight);
        placed.camera.znear = near;
        placed.camera.zfar = perspective ? 0.0 : 40.0;
        placed.worldFromCamera = {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                                  glm::dvec4(0, kEyeHeight, 0, 1)};
        return placed;
    }

    oracle::Oracle oracle_;
    oracle::EyeRays rays_;
    Explainer explainer_;
};

}  // namespace umbrage
