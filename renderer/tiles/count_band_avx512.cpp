// SPDX-License-Identifier: Apache-2.0
#include "tiles/count_band.h"
#include "tiles/count_band.inl"

namespace umbrage {

void countBandAvx512(const Band& band) {
    countBandOf(band);
}

}  // namespace umbrage
