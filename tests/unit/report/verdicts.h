// SPDX-License-Identifier: Apache-2.0
// Made-up verdicts with known figures.
#pragma once

#include "report/verify_report.h"

namespace umbrage {

inline VerifyHeader header() {
    return {"0.1.0", "A device", "A driver", "umbrage verify a.yaml b.yaml", "", {}, 0};
}

/// 1000 samples that face the light, `hard` of them too dark, two in the band.
inline LightVerdict light(const std::string& id, std::uint64_t hard = 0) {
    LightVerdict made;
    made.light = id;
    made.litFacing = 1000;
    made.exactDark = 400;
    made.hardFalseDark = hard;
    made.boundary = 1;
    made.grazing = 1;
    made.bandFalseDark = 2;
    made.bandPopulation = 50;
    made.boundaryLength = 200.0;
    made.largestComponent = hard + 2;
    made.largestExtent = 3;
    return made;
}

inline FrameVerdict frame(int number, const std::string& technique, std::vector<LightVerdict> lights) {
    FrameVerdict made;
    made.frame = number;
    made.technique = technique;
    made.lights = std::move(lights);
    made.radiance = {0.25 * number, 0.01, number, 0.5};
    made.renderMilliseconds = 10.0 * number;
    made.oracleMilliseconds = 100.0;
    return made;
}

/// Two sequences, two techniques, the second only on the first frame; one hard error by the second technique.
inline VerifyReport twoSequences() {
    VerifyReport report(header());
    for (const char* sequence : {"A1", "B1"}) {
        for (const int number : {1, 2, 3}) {
            report.add(sequence, true, frame(number, "compute:z-pass", {light("Key"), light("Fill")}));
            if (number == 1) {
                report.add(sequence, true,
                           frame(number, "cpu:z-fail", {light("Key", sequence[0] == 'B'), light("Fill")}));
            }
        }
    }
    return report;
}

}  // namespace umbrage
