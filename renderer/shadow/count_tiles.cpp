// SPDX-License-Identifier: Apache-2.0
// z-pass, counted by the processor tile by tile: see tiles/tile_counter.h. Only the lists of sides of its plans are
// used; the eye's constant and the caps that are missing are found in shadow/tile_lights.
#include "shadow/counts.h"

namespace umbrage {
namespace {

class Tiles : public CountTechnique {
public:
    bool byTiles() const override { return true; }
};

}  // namespace

std::unique_ptr<CountTechnique> makeTiles() {
    return std::make_unique<Tiles>();
}

}  // namespace umbrage
