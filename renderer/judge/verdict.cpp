// SPDX-License-Identifier: Apache-2.0
#include "judge/verdict.h"

namespace umbrage {

double LightVerdict::signedBias() const {
    const double difference = double(hardFalseDark + bandFalseDark) - double(hardFalseLit + bandFalseLit);
    return boundaryLength > 0.0 ? difference / samplesPerPixel / boundaryLength : 0.0;
}

std::uint64_t FrameVerdict::hard() const {
    std::uint64_t sum = 0;
    for (const LightVerdict& light : lights) sum += light.hard();
    return sum;
}

std::uint64_t FrameVerdict::hardCounts() const {
    std::uint64_t sum = 0;
    for (const LightVerdict& light : lights) sum += light.hardCountErrors;
    return sum;
}

}  // namespace umbrage
