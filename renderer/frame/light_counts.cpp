// SPDX-License-Identifier: Apache-2.0
#include "frame/light_counts.h"

#include <fmt/format.h>

#include "error.h"

namespace umbrage {

LightCounts::LightCounts(const FrameSettings& settings)
    : name_(settings.count),
      whenInexact_(settings.whenInexact),
      chosen_(makeCountTechnique(settings.count, {settings.extrusionMetres})) {}

void LightCounts::begin(const CountFrame& frame, int number, std::vector<std::string> ids) {
    frame_ = number;
    ids_ = std::move(ids);
    fellBack_.assign(ids_.size(), false);
    chosen_->begin(frame);
    for (std::uint32_t l = 0; l < ids_.size(); ++l) {
        if (const std::string why = chosen_->whyInexact(l); !why.empty()) notExact(l, why);
    }
}

void LightCounts::notExact(std::uint32_t light, const std::string& why) {
    if (whenInexact_ == WhenInexact::Allow) return;
    if (whenInexact_ == WhenInexact::Refuse) {
        throw Error(ErrorKind::Input, fmt::format("frame {}, light {}", frame_, ids_[light]),
                    fmt::format("{} is not exact: {}", name_, why),
                    "shadow.whenInexact: fall-back counts such lights by z-pass, allow takes the errors");
    }
    fellBack_[light] = true;
    std::string note = fmt::format("light {} is counted by z-pass where {} is not exact: {}", ids_[light], name_, why);
    if (said_.insert(note).second) notes_.push_back(std::move(note));
}

template <class Holds>
std::uint32_t LightCounts::bitsOf(const LightGroup& group, Holds holds) const {
    std::uint32_t bits = 0;
    for (std::uint32_t l = 0; l < group.count; ++l) bits |= std::uint32_t(holds(of(group.first + l))) << l;
    return bits;
}

std::uint32_t LightCounts::fromInfinity(const LightGroup& group) const {
    return bitsOf(group, [](const CountTechnique& technique) { return technique.fromInfinity(); });
}

std::uint32_t LightCounts::withEyeConstant(const LightGroup& group) const {
    return bitsOf(group, [](const CountTechnique& technique) { return technique.hasEyeConstant(); });
}

std::vector<CountPlan> LightCounts::plan(const CountInput& input, Masks& masks, VolumeRenderer& volumes,
                                         const Geometry& geometry) {
    const std::uint32_t light = input.group.first + input.l;
    std::vector<CountPlan> plans = of(light).plan(input);
    if (fellBack_[light] || whenInexact_ == WhenInexact::Allow) return plans;
    for (const CountPlan& plan : plans) {
        if (!plan.inverted || masks.parityTells(plan, volumes, geometry, input.silhouettes, input.group, input.l))
            continue;
        notExact(light, "some count is even, so its parity does not tell it from none");
        return of(light).plan(input);
    }
    return plans;
}

}  // namespace umbrage
