// SPDX-License-Identifier: Apache-2.0
// Counts from the eye (Heidmann 1991), with one integer for the volumes that hold it (after Usta et al. 2019): what
// every technique does that does not say otherwise.
#include "shadow/counts.h"

namespace umbrage {

std::unique_ptr<CountTechnique> makeZPass() {
    return std::make_unique<CountTechnique>();
}

}  // namespace umbrage
