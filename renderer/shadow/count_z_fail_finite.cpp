// SPDX-License-Identifier: Apache-2.0
// z-fail as Kilgard 2001 describes it of Carmack's Doom: volumes end at a finite distance from the light, beyond the
// bounds of what it lights, and are capped there. The infinite projection stands for the far plane that he moves out to
// hold them. The cap of a triangle is flat, so near a light its middle comes nearer than its corners: seen from the
// light under a wide angle, the volume collapses and lets light through.
#include <cmath>
#include <numbers>

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
    bool hasEyeConstant() const override { return false; }
    double endMetres(std::uint32_t light) const override { return ends_[light]; }

    void begin(const CountFrame& frame) override {
        const std::vector<Geometry::Bounds> boxes = worldBounds(frame.geometry, frame.modelBounds);
        ends_.clear();
        collapses_.clear();
        for (std::size_t l = 0; l < frame.lights.size(); ++l) measure(boxes, frame.lights[l], frame.rangesMetres[l]);
    }

    std::string whyInexact(std::uint32_t light) const override {
        return collapses_[light] ? "a caster is so near the light that its volume may end before what it shades" : "";
    }

private:
    void measure(const std::vector<Geometry::Bounds>& boxes, const ShadowLight& light, double rangeMetres) {
        if (light.w == 0.0) {  // parallel caps do not collapse
            const double across = 2.0 * radiusOf(boxes);
            ends_.push_back(endMetres_ > 0.0 ? endMetres_ : across * (1.0 + 1e-3));
            collapses_.push_back(ends_.back() < across);
            return;
        }
        const glm::dvec3 at(light);
        double lit = rangeMetres;
        if (lit <= 0.0) {
            for (const Geometry::Bounds& box : boxes) lit = std::max(lit, farthestOf(box, at));
        }
        // The sphere around the box of the light's range.
        ends_.push_back(endMetres_ > 0.0 ? endMetres_ : std::numbers::sqrt3 * lit);
        bool collapses = false;
        for (const Geometry::Bounds& box : boxes) {
            collapses = collapses || (!outOfReach(box, at, lit) && ends_.back() * nearestOfCap(box, at) < lit);
        }
        collapses_.push_back(collapses);
    }

    double endMetres_;
    std::vector<double> ends_;  // these two per light of the frame
    std::vector<bool> collapses_;
};

}  // namespace

std::unique_ptr<CountTechnique> makeZFailFinite(double endMetres) {
    return std::make_unique<ZFailFinite>(endMetres);
}

}  // namespace umbrage
