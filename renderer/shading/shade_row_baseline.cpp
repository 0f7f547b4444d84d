// SPDX-License-Identifier: Apache-2.0
#include "shading/shade_row.h"
#include "shading/shade_row.inl"

namespace umbrage {

void shadeRowBaseline(const ShadeRow& row) {
    shadeRowOf(row);
}

}  // namespace umbrage
