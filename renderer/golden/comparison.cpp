// SPDX-License-Identifier: Apache-2.0
#include "golden/comparison.h"

#include <algorithm>

namespace umbrage {

bool Comparison::passes() const {
    const auto good = [](const auto& result) { return infoOf(result.outcome).passes; };
    return std::all_of(images.begin(), images.end(), good) && std::all_of(statistics.begin(), statistics.end(), good) &&
           !anyExceeded(budgets);
}

std::string fileAt(const std::string& place, const ImageResult& image) {
    if (place.empty() || place.ends_with(".png") || place.ends_with(".exr")) return place.empty() ? image.name : place;
    return place + "/" + image.name;
}

}  // namespace umbrage
