// SPDX-License-Identifier: Apache-2.0
// z-pass, counted by the processor tile by tile wherever no caps are needed: see tiles/tile_counter.h. It has the same
// constant of the eye, so the same casters are counted otherwise near their volumes' faces (T4).
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
