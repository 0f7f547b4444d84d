// SPDX-License-Identifier: Apache-2.0
#include "shadow/counts.h"

namespace umbrage {
namespace {

using Rule = VolumePart::Rule;
using Kind = VolumePart::Kind;
using Start = VolumePart::Start;

/// Instances of the group's casters that a part is for; `wanted` says which by index.
template <class Wanted>
void addCap(CountPlan& plan, std::uint32_t cap, Rule rule, Start start, const Silhouettes& silhouettes, std::uint32_t l,
            Wanted wanted) {
    VolumePart part{Kind::Cap, rule, start, cap, {}};
    for (std::uint32_t i = 0; i < silhouettes.hostCasters.size(); ++i) {
        const bool byFail = silhouettes.hostCasters[i].countedByFail >> l & 1u;
        if (byFail == (rule == Rule::Fail) && wanted(i)) part.instances.push_back(i);
    }
    if (!part.instances.empty()) plan.parts.push_back(std::move(part));
}

void addSides(CountPlan& plan, std::uint32_t list, Rule rule, Start start, const gpu::LightSummary& summary) {
    for (const std::uint32_t part : {list, list + LIST_EDGE_ON}) {
        if (summary.lists[part].count > 0) plan.parts.push_back({Kind::Sides, rule, start, part, {}});
    }
}

void keepParity(CountPlan& plan) {
    plan.inverted = true;
    plan.fullLitValue = plan.litValue;
    plan.fullIsWide = plan.wide;
    plan.wide = false;
    plan.litValue = -(plan.litValue & 1);  // no bit, or all
    for (VolumePart& part : plan.parts) part.inverts = true;
}

}  // namespace

std::vector<CountPlan> CountTechnique::plan(const CountInput& input) const {
    const auto& [silhouettes, group, l, layerBound, parallelToView, settings] = input;
    if (silhouettes.hostCasters.empty()) return {};
    const gpu::LightSummary& summary = silhouettes.hostSummaries[l];
    const Start start = this->start();
    const auto eyeInside = [&](std::uint32_t list) {
        return settings.eyeConstant && hasEyeConstant() ? int(summary.eyeInside[list]) : 0;
    };
    std::vector<CountPlan> plans;

    CountPlan halved;
    halved.layerBound = layerBound;
    if (!parallelToView) addSides(halved, LIST_HALVED, Rule::Pass, start, summary);
    halved.crossings = settings.halve ? 2 : 1;
    halved.eyeLayers = eyeInside(LIST_HALVED);
    halved.litValue = -halved.eyeLayers / halved.crossings;
    halved.wide = layerBound > (settings.halve ? 511 : 255);
    halved.allDark = settings.halve && halved.eyeLayers % 2 != 0;
    if (!halved.parts.empty() || halved.eyeLayers != 0) plans.push_back(std::move(halved));

    const auto notInDepthBuffer = [&](std::uint32_t i) {
        return settings.holed[i] || silhouettes.hostCasters[i].missing != 0;
    };
    const auto all = [](std::uint32_t) { return true; };
    CountPlan whole;
    whole.layerBound = layerBound;
    if (!parallelToView) addSides(whole, LIST_WHOLE, Rule::Pass, start, summary);
    for (const std::uint32_t cap : {CAP_TRUE, CAP_EDGE_ON}) {
        addCap(whole, cap, Rule::Pass, start, silhouettes, l, notInDepthBuffer);
        addCap(whole, cap, Rule::Fail, Start::Eye, silhouettes, l, notInDepthBuffer);
    }
    addSides(whole, LIST_FAIL, Rule::Fail, Start::Eye, summary);
    addCap(whole, CAP_FAR, Rule::Fail, Start::Eye, silhouettes, l, all);
    addCap(whole, CAP_DARK, Rule::Fail, Start::Eye, silhouettes, l,
           [&](std::uint32_t i) { return needsDarkCap(input, i); });
    addStart(whole, input);
    whole.wide = layerBound > 255;
    whole.eyeLayers = eyeInside(LIST_WHOLE) + eyeInside(LIST_FAIL);
    whole.litValue = -whole.eyeLayers;
    if (!whole.parts.empty() || whole.eyeLayers != 0) plans.push_back(std::move(whole));
    for (CountPlan& plan : plans) {
        if (inverts()) keepParity(plan);
        for (VolumePart& part : plan.parts) part.endMetres = float(endMetres());
    }
    return plans;
}

bool CountTechnique::needsDarkCap(const CountInput& input, std::uint32_t instance) const {
    const Silhouettes& silhouettes = input.silhouettes;
    if (endMetres() > 0.0 || endOfVolume(silhouettes.hostCasters[instance], input.l) != 0) return true;
    // All infinite ends of a directional light's volumes meet in one point, and an orthographic eye sees none.
    const bool positional = silhouettes.hostLightsInModel[input.group.first + input.l].w != 0.0f;
    return input.settings.perspective && positional;
}

void ReachingCasters::find(const CountFrame& frame, double distance) {
    std::vector<glm::dvec4> lights;
    for (const ShadowLight& light : frame.lights) lights.push_back(frame.eye.viewFromWorld * light);
    reach_.assign(frame.modelBounds.size(), std::vector<bool>(lights.size()));
    for (std::size_t i = 0; i < reach_.size(); ++i) {
        const glm::dmat4 viewFromModel = frame.eye.viewFromWorld * frame.geometry.worldFromModel(i);
        BoxCorners corners = cornersOf(frame.modelBounds[i]);
        for (glm::dvec3& corner : corners) corner = glm::dvec3(viewFromModel * glm::dvec4(corner, 1.0));
        for (std::size_t l = 0; l < lights.size(); ++l)
            reach_[i][l] = mayReach({frame.eye, distance}, corners, lights[l]);
    }
}

std::vector<std::uint32_t> ReachingCasters::of(const CountInput& input) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < reach_.size(); ++i) {
        const gpu::CasterState& caster = input.silhouettes.hostCasters[i];
        if (!reach_[i][input.group.first + input.l]) continue;
        if (((caster.outOfReach | caster.outOfView | caster.countedByFail) >> input.l & 1u) == 0) found.push_back(i);
    }
    return found;
}

}  // namespace umbrage
