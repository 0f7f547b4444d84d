// SPDX-License-Identifier: Apache-2.0
// z-fail as Kilgard 2001 describes it of Carmack's Doom: volumes are clipped to the bounds of what the light shines on
// (its range, a spot's cone, all receivers) and capped there. Where no face of the bounds is crossed by all rays
// through a caster, they go on to infinity. The infinite projection stands for the far plane that he moves out to hold
// them.
//
// Told a distance, they end there, as in Doom itself, at all corners alike. The cap of a triangle is flat, so near a
// light its middle comes nearer than its corners: seen from the light under a wide angle, the volume collapses and lets
// light through.
#include <cmath>

#include "shadow/counts.h"

namespace umbrage {
namespace {

/// The least distance from the light of a cap whose corners are one away from it, if it is within a box; 0 where the
/// light is too near to say.
double nearestOfCap(const Geometry::Bounds& box, const glm::dvec3& light) {
    const double radius = 0.5 * glm::distance(box.low, box.high);
    const double sine = radius / std::max(glm::distance(0.5 * (box.low + box.high), light), 1e-300);
    return sine < 1.0 ? std::sqrt(1.0 - sine * sine) : 0.0;
}

double farthestOf(const Geometry::Bounds& box, const glm::dvec3& point) {
    return glm::length(glm::max(glm::abs(box.low - point), glm::abs(box.high - point)));
}

class ZFailFinite : public CountTechnique {
public:
    explicit ZFailFinite(double endMetres) : endMetres_(endMetres) {}

    bool fromInfinity() const override { return true; }
    bool hasEyeConstant() const override { return endMetres_ == 0.0; }  // of volumes that do not end
    bool endsVolumes() const override { return true; }
    double endMetres() const override { return endMetres_; }

    void begin(const CountFrame& frame) override {
        const std::vector<Geometry::Bounds> boxes = worldBounds(frame.geometry, frame.modelBounds);
        collapses_.clear();
        for (std::size_t l = 0; l < frame.lights.size(); ++l) {
            collapses_.push_back(endMetres_ > 0.0 && collapses(boxes, frame.lights[l], frame.rangesMetres[l]));
        }
    }

    std::string whyInexact(std::uint32_t light) const override {
        return collapses_[light] ? "a caster's volume may end before what it shades" : "";
    }

private:
    bool collapses(const std::vector<Geometry::Bounds>& boxes, const ShadowLight& light, double rangeMetres) const {
        if (light.w == 0.0) return endMetres_ < 2.0 * radiusOf(boxes);  // parallel caps are as far as their corners
        const glm::dvec3 at(light);
        double lit = rangeMetres;
        if (lit <= 0.0) {
            for (const Geometry::Bounds& box : boxes) lit = std::max(lit, farthestOf(box, at));
        }
        return std::ranges::any_of(boxes, [&](const Geometry::Bounds& box) {
            return !outOfReach(box, {.light = light, .rangeMetres = lit}) && endMetres_ * nearestOfCap(box, at) < lit;
        });
    }

    double endMetres_;
    std::vector<bool> collapses_;  // per light of the frame
};

}  // namespace

std::unique_ptr<CountTechnique> makeZFailFinite(double endMetres) {
    return std::make_unique<ZFailFinite>(endMetres);
}

}  // namespace umbrage
