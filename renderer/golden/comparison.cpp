// SPDX-License-Identifier: Apache-2.0
#include "golden/comparison.h"

#include <algorithm>

namespace umbrage {

bool Comparison::passes() const {
    const auto good = [](const auto& result) { return infoOf(result.outcome).passes; };
    return std::all_of(images.begin(), images.end(), good) && std::all_of(statistics.begin(), statistics.end(), good) &&
           !anyExceeded(budgets);
}

}  // namespace umbrage
