// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <string>

#include "shadow/counts.h"

namespace umbrage {

// One line a technique; each is in a file of its name.
std::unique_ptr<CountTechnique> makeZPass();
std::unique_ptr<CountTechnique> makeZFail();
std::unique_ptr<CountTechnique> makeNearCap();
std::unique_ptr<CountTechnique> makeZPassPlus();
std::unique_ptr<CountTechnique> makeInvert();
std::unique_ptr<CountTechnique> makeZFailFinite(double endMetres);
std::unique_ptr<CountTechnique> makeSplitPlane();
std::unique_ptr<CountTechnique> makeTiles();

std::unique_ptr<CountTechnique> makeCountTechnique(std::string_view name, const CountOptions& options) {
    if (name == "z-pass") return makeZPass();
    if (name == "z-fail") return makeZFail();
    if (name == "near-cap") return makeNearCap();
    if (name == "z-pass-plus") return makeZPassPlus();
    if (name == "invert") return makeInvert();
    if (name == "z-fail-finite") return makeZFailFinite(options.endMetres);
    if (name == "split-plane") return makeSplitPlane();
    if (name == "tiles") return makeTiles();
    throw std::logic_error("no such count technique: " + std::string(name));
}

}  // namespace umbrage
