// SPDX-License-Identifier: Apache-2.0
// Counts from infinity (Bilodeau & Songy 1999, Carmack 2000, Everitt & Kilgard 2002): volumes with both caps, whose
// farther ends lie at infinity.
#include "shadow/counts.h"

namespace umbrage {
namespace {

class ZFail : public CountTechnique {
public:
    bool fromInfinity() const override { return true; }
};

}  // namespace

std::unique_ptr<CountTechnique> makeZFail() {
    return std::make_unique<ZFail>();
}

}  // namespace umbrage
