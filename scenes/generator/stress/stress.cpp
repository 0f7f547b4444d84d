// SPDX-License-Identifier: Apache-2.0
#include "stress/stress.h"

namespace generator::stress {

std::vector<Case> cases() {
    std::vector<Case> all;
    for (auto* const family : {lightCases, eyeCases, projectionCases, topologyCases, storageCases, magnitudeCases,
                               countCases, lightShapeCases, rasterCases})
        for (Case& one : family()) all.push_back(std::move(one));
    return all;
}

}  // namespace generator::stress
