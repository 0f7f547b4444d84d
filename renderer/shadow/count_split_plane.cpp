// SPDX-License-Identifier: Apache-2.0
// Counts by parts of the casters (Laine 2005): from the eye at pixels before the part's split plane, from infinity and
// with caps at those behind it. Both counts of a part are right at every pixel, so any choice between them is.
//
// Added up in floats: sides and caps are drawn once by each rule under the fixed depth test, and the shader drops the
// pixels that the other rule has. Stencil bits would need every part's plane drawn first and its volume apart from all
// others, and would be taken from the count; depth bounds know no slanted plane. Floats also let a fragment of a halved
// side stand for two crossings beside caps that stand for one.
#include "shadow/counts.h"

namespace umbrage {
namespace {

using Kind = VolumePart::Kind;
using Rule = VolumePart::Rule;
using Start = VolumePart::Start;

class SplitPlaneCount : public CountTechnique {
public:
    bool byParts() const override { return true; }

    std::vector<CountPlan> plan(const CountInput& input) const override {
        // Neither count has a constant there, and view rays cross no sides: z-pass needs nothing but caps (T5).
        if (input.parallelToView) return CountTechnique::plan(input);
        const Silhouettes& silhouettes = input.silhouettes;
        if (silhouettes.hostCasters.empty()) return {};
        CountPlan plan;
        plan.byParts = plan.wide = true;
        plan.layerBound = input.layerBound;
        for (const std::uint32_t list : {LIST_HALVED, LIST_WHOLE}) {
            const int crossings = list == LIST_HALVED && input.settings.halve ? 2 : 1;
            for (const std::uint32_t what : {list, list + LIST_EDGE_ON}) {
                if (silhouettes.hostSummaries[input.l].lists[what].count == 0) continue;
                plan.parts.push_back({Kind::Sides, Rule::Split, Start::Eye, what, {}, crossings});
            }
        }
        addCaps(input, plan);
        const auto [first, last] = silhouettes.parts->partsOf(input.l);
        for (std::uint32_t part = first; part < last && input.settings.eyeConstant; ++part) {
            const gpu::SplitPart& found = silhouettes.parts->host[part];
            if (found.eyeInside[SPLIT_PASS] + found.eyeInside[SPLIT_FAIL] > 0) plan.starts.push_back(part);
        }
        return {std::move(plan)};
    }

private:
    /// Those far away count behind the planes only, of themselves: nothing lies behind them.
    void addCaps(const CountInput& input, CountPlan& plan) const {
        const Silhouettes& silhouettes = input.silhouettes;
        std::vector<std::uint32_t> all, notInDepthBuffer, dark;
        for (std::uint32_t i = 0; i < silhouettes.hostCasters.size(); ++i) {
            all.push_back(i);
            if (needsDarkCap(input, i)) dark.push_back(i);
            if (input.settings.holed[i] || silhouettes.hostCasters[i].missing != 0) notInDepthBuffer.push_back(i);
        }
        if (!notInDepthBuffer.empty()) {
            for (const std::uint32_t cap : {CAP_TRUE, CAP_EDGE_ON}) {
                plan.parts.push_back({Kind::Cap, Rule::Split, Start::Eye, cap, notInDepthBuffer});
            }
        }
        plan.parts.push_back({Kind::Cap, Rule::Split, Start::Eye, CAP_FAR, all});
        if (!dark.empty()) plan.parts.push_back({Kind::Cap, Rule::Split, Start::Eye, CAP_DARK, dark});
    }
};

}  // namespace

std::unique_ptr<CountTechnique> makeSplitPlane() {
    return std::make_unique<SplitPlaneCount>();
}

}  // namespace umbrage
