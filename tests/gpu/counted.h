// SPDX-License-Identifier: Apache-2.0
// A frame with all its counters, and what is needed to count the same by brute force.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "judge/truth.h"
#include "subjects.h"

namespace umbrage::test {

/// A side quad: its edge, run through as the light-oriented surface does, as often as it counts.
struct Quad {
    glm::dvec3 a, b;
    int times = 0;
};

/// Every count of one light apart, unless `halve`.
struct Counted {
    explicit Counted(const Subject& subject, const How& how = {.counts = true}, int samples = 1);

    double value(const char* counter) const { return json["values"].value(counter, 0.0); }
    double value(const std::string& light, const char* counter) const {
        return json["lights"][light]["values"].value(counter, 0.0);
    }

    /// Different edges of casting triangles.
    std::size_t edgeCount() const;

    /// The side quads of a light's volumes, by exact facing.
    std::vector<Quad> quadsOf(const glm::dvec4& light) const;

    Moment moment;
    FramePixels pixels;
    Truth truth;
    nlohmann::json json;                                // the frame's part of the statistics file
    std::map<std::uint32_t, std::uint32_t> instanceOf;  // by the oracle's triangle

private:
    using Point = std::array<double, 3>;
    /// By instance and ends, the lesser first: how often the light's side of the surface runs through it that way. An
    /// edge counts as often as `facing` says its triangles do.
    std::map<std::pair<std::uint32_t, std::array<Point, 2>>, int> edges(
        const std::function<int(const Corners&)>& facing) const;
};

/// What one view ray meets of a light's volumes.
struct Crossings {
    int sides = 0, lightCaps = 0, darkCaps = 0;
    int passed = 0, failed = 0;  // before what is seen, and not
    int entered = 0, left = 0;   // of those that count

    int all() const { return passed + failed; }
    int updates() const { return entered + left; }
    Crossings& operator+=(const Crossings& other);
};

/// @param byFail  by z-fail, with caps, or by z-pass without them
/// @param seen  where the surface is, or the view ends, in lengths of the ray's direction
Crossings crossingsOf(const Counted& counted, const oracle::Ray& ray, const std::vector<Quad>& quads,
                      const glm::dvec4& light, bool byFail, double seen);

/// Where the camera's view ends, in lengths of the ray's direction.
double farthest(const PlacedCamera& camera, const oracle::Ray& ray);

}  // namespace umbrage::test
