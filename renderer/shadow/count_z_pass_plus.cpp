// SPDX-License-Identifier: Apache-2.0
// z-pass plus (Hornus, Hoberock, Lefebvre & Hart 2005): sides are clipped at the near plane, and the volumes that pass
// through the picture's rectangle there are counted beforehand: what stands between light and rectangle, seen from the
// light, so that its pixels are the picture's. Two projections must agree along the near plane, and they round
// differently: it claims no exactness.
#include <cmath>

#include "shadow/counts.h"

namespace umbrage {
namespace {

class ZPassPlus : public CountTechnique {
public:
    VolumePart::Start start() const override { return VolumePart::Start::NearPlane; }
    bool countsWhole(std::uint32_t instance) const override { return reaching_.any(instance); }

    void begin(const CountFrame& frame) override {
        reaching_.find(frame, frame.eye.znear);
        collapses_.clear();
        for (const ShadowLight& light : frame.lights) {
            const glm::dvec4 inView = frame.eye.viewFromWorld * light;
            const double away = std::abs(inView.z + frame.eye.znear * inView.w);
            collapses_.push_back(away <= HAZARD * glm::length(glm::dvec3(inView)));
        }
    }

    std::string whyInexact(std::uint32_t light) const override {
        return collapses_[light] ? "the light is in the near plane, where its view of the picture collapses" : "";
    }

protected:
    void addStart(CountPlan& whole, const CountInput& input) const override {
        VolumePart caps{VolumePart::Kind::Cap, VolumePart::Rule::Pass, start(), CAP_LIGHT_VIEW, reaching_.of(input)};
        if (!caps.instances.empty()) whole.parts.push_back(std::move(caps));
    }

private:
    ReachingCasters reaching_;
    std::vector<bool> collapses_;  // per light of the frame
};

}  // namespace

std::unique_ptr<CountTechnique> makeZPassPlus() {
    return std::make_unique<ZPassPlus>();
}

}  // namespace umbrage
