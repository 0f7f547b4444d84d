// SPDX-License-Identifier: Apache-2.0
#include "shadow/counts.h"

namespace umbrage {
namespace {

using Rule = VolumePart::Rule;
using Kind = VolumePart::Kind;

/// Instances of the group's casters that a part is for; `wanted` says which by index.
template <class Wanted>
void addCap(CountPlan& plan, std::uint32_t cap, Rule rule, const Silhouettes& silhouettes, std::uint32_t l,
            Wanted wanted) {
    VolumePart part{Kind::Cap, rule, cap, {}};
    for (std::uint32_t i = 0; i < silhouettes.hostCasters.size(); ++i) {
        const bool byFail = silhouettes.hostCasters[i].countedByFail >> l & 1u;
        if (byFail == (rule == Rule::Fail) && wanted(i)) part.instances.push_back(i);
    }
    if (!part.instances.empty()) plan.parts.push_back(std::move(part));
}

void addSides(CountPlan& plan, std::uint32_t list, Rule rule, const gpu::LightSummary& summary) {
    for (const std::uint32_t part : {list, list + LIST_EDGE_ON}) {
        if (summary.lists[part].count > 0) plan.parts.push_back({Kind::Sides, rule, part, {}});
    }
}

}  // namespace

std::vector<CountPlan> CountTechnique::plan(const CountInput& input) const {
    const auto& [silhouettes, group, l, layerBound, parallelToView, settings] = input;
    if (silhouettes.hostCasters.empty()) return {};
    const gpu::LightSummary& summary = silhouettes.hostSummaries[l];
    const auto eyeInside = [&](std::uint32_t list) {
        return input.settings.eyeConstant ? int(summary.eyeInside[list]) : 0;
    };
    std::vector<CountPlan> plans;

    CountPlan halved;
    halved.layerBound = layerBound;
    if (!parallelToView) addSides(halved, LIST_HALVED, Rule::Pass, summary);
    const int crossings = settings.halve ? 2 : 1;  // for a quad
    halved.litValue = -eyeInside(LIST_HALVED) / crossings;
    halved.wide = layerBound > (settings.halve ? 511 : 255);
    halved.allDark = settings.halve && eyeInside(LIST_HALVED) % 2 != 0;
    if (!halved.parts.empty() || eyeInside(LIST_HALVED) != 0) plans.push_back(std::move(halved));

    const auto notInDepthBuffer = [&](std::uint32_t i) {
        return input.settings.holed[i] || input.silhouettes.hostCasters[i].missing != 0;
    };
    CountPlan whole;
    whole.layerBound = layerBound;
    if (!parallelToView) addSides(whole, LIST_WHOLE, Rule::Pass, summary);
    for (const std::uint32_t cap : {CAP_TRUE, CAP_EDGE_ON}) {
        addCap(whole, cap, Rule::Pass, silhouettes, l, notInDepthBuffer);
        addCap(whole, cap, Rule::Fail, silhouettes, l, notInDepthBuffer);
    }
    addSides(whole, LIST_FAIL, Rule::Fail, summary);
    addCap(whole, CAP_FAR, Rule::Fail, silhouettes, l, [](std::uint32_t) { return true; });
    // All ends of a directional light's volumes meet in one point, and an orthographic eye sees no point at infinity.
    const bool positional = silhouettes.hostLightsInModel[group.first + l].w != 0.0f;
    if (settings.perspective && positional) {
        addCap(whole, CAP_DARK, Rule::Fail, silhouettes, l, [](std::uint32_t) { return true; });
    }
    whole.wide = layerBound > 255;
    whole.litValue = -(eyeInside(LIST_WHOLE) + eyeInside(LIST_FAIL));
    if (!whole.parts.empty() || whole.litValue != 0) plans.push_back(std::move(whole));
    return plans;
}

}  // namespace umbrage
