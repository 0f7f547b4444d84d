// SPDX-License-Identifier: Apache-2.0
// Counts from a plane just before the near plane (Kilgard 2001): what is left of the volumes when they are cut there is
// closed by caps in the plane, so no view ray begins in a volume, no constant is needed, and the eye is nowhere in
// danger (T4). His cases of capping come out of one rule: shaders/near_cap.vert.glsl.
#include "shadow/counts.h"
#include "shadow/ledge.h"

namespace umbrage {
namespace {

class NearCap : public CountTechnique {
public:
    double ledge() const override { return LEDGE; }
    VolumePart::Start start() const override { return VolumePart::Start::CapPlane; }
    void begin(const CountFrame& frame) override { reaching_.find(frame, capDistance(frame.eye)); }
    bool countsWhole(std::uint32_t instance) const override { return reaching_.any(instance); }

protected:
    void addStart(CountPlan& whole, const CountInput& input) const override {
        VolumePart caps{VolumePart::Kind::Cap, VolumePart::Rule::Pass, start(), CAP_SECTION, reaching_.of(input)};
        if (!caps.instances.empty()) whole.parts.push_back(std::move(caps));
    }

private:
    ReachingCasters reaching_;
};

}  // namespace

std::unique_ptr<CountTechnique> makeNearCap() {
    return std::make_unique<NearCap>();
}

}  // namespace umbrage
