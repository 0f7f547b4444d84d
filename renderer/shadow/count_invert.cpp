// SPDX-License-Identifier: Apache-2.0
// Heidmann's first form: every crossing inverts the stencil buffer, so only the parity of counts is kept, and an even
// count is taken for none. Valid where no sample has such a count, which is proven by counting (docs/rules.md, T11).
#include "shadow/counts.h"

namespace umbrage {
namespace {

class Invert : public CountTechnique {
public:
    bool inverts() const override { return true; }
};

}  // namespace

std::unique_ptr<CountTechnique> makeInvert() {
    return std::make_unique<Invert>();
}

}  // namespace umbrage
