// SPDX-License-Identifier: Apache-2.0
// The exact answer: which triangle is seen at a place of the picture, and which triangles lie between that point and a
// light. Everything in world space and double; nothing is shared with how the renderer makes shadows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "oracle/candidates.h"
#include "oracle/predicates.h"
#include "scene/moment.h"

namespace umbrage::oracle {

inline constexpr std::uint32_t kNothing = 0xffffffffu;

struct Triangle {
    Corners corners;
    bool casts = true;
    bool visible = true;       // blended surfaces are not: what is behind them is judged
    bool singleSided = false;  // not seen from behind
    bool holed = false;        // alpha-masked: casts as a whole, is seen or not (see Oracle::see)
};

/// An eye ray; its parameter is the distance along the view axis in metres.
struct EyeRay : Ray {
    double near = 0.0, far = 0.0;  // what is seen is between these
};

/// The image's aspect ratio wins over the camera's: the vertical field of view or extent is kept.
class EyeRays {
public:
    EyeRays(const PlacedCamera& camera, int width, int height);

    /// @param x, y  in pixels from the upper left corner: the first pixel's centre is (0.5, 0.5)
    EyeRay at(double x, double y) const;

    const glm::dvec3& eye() const { return eye_; }
    const glm::dvec3& forward() const { return forward_; }

private:
    glm::dvec3 eye_, right_, up_, forward_;
    glm::dvec2 halfExtent_, pixelSize_;
    bool perspective_;
    double near_, far_;
};

/// Homogeneous: a position, or the direction towards a directional light, w = 0.
glm::dvec4 placeOf(const PlacedLight& light);

class Oracle {
public:
    explicit Oracle(std::vector<Triangle> triangles);

    const std::vector<Triangle>& triangles() const { return triangles_; }
    const Triangle& operator[](std::uint32_t i) const { return triangles_[i]; }

    /// The nearest visible triangle, or kNothing; of several at the same depth the first. Holed triangles are holes all
    /// over, but for `solid`: alpha textures are not judged.
    std::uint32_t see(const EyeRay& ray, std::uint32_t solid = kNothing) const;

    /// Along the ray, rounded.
    double distanceTo(std::uint32_t seen, const Ray& ray) const;

    /// Whether the light is on the same side of the triangle as the eye.
    bool turnedTo(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const;

    /// A casting triangle between the point of `seen` at the ray and the light, or kNothing.
    std::uint32_t hiddenBy(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const;

    /// How many there are.
    std::uint32_t layersBefore(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const;

    /// How many shadow volumes hold the place just before the surface: the same, and the surface's own where the eye
    /// looks at its shaded side. What counting volumes gives.
    std::uint32_t volumesAround(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const;

private:
    /// Calls visit(index, point) for casting triangles that may lie between the point seen and the light, until it
    /// returns false.
    template <class Visit>
    void towards(const glm::dvec4& light, std::uint32_t seen, const Ray& ray, const Visit& visit) const;

    std::vector<Triangle> triangles_;
    std::vector<Corners> corners_;
    std::unique_ptr<Candidates> candidates_;
};

}  // namespace umbrage::oracle
