// SPDX-License-Identifier: Apache-2.0
#include "bench/tracer_tile.h"
#include "bench/tracer_tile.inl"

namespace umbrage {

void traceTileAvx512(const TracerFrame& frame, int left, int top) {
    traceTileOf(frame, left, top);
}

}  // namespace umbrage
