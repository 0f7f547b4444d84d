// SPDX-License-Identifier: Apache-2.0
// The registry of quantities that have a value at every pixel and go into the statistics as distributions.
#pragma once

#include <array>
#include <string_view>

#include "diagnostics/table_row.h"

namespace umbrage {

struct QuantityInfo {
    std::string_view name, unit, doc;
    std::string_view aov;  // the channel that holds the values themselves
};

// clang-format off
inline constexpr std::array kQuantities{
    QuantityInfo{"scene", "fragments/pixel", "fragments of opaque surfaces at each covered pixel", "scene.fragments"},
    QuantityInfo{"shaded", "fragments/pixel", "fragments of opaque surfaces that passed the depth test, at each covered pixel", "scene.shaded"},
    QuantityInfo{"overdraw", "fragments/pixel", "fragments of shadow volumes at each pixel of the picture", "overdraw.fragments"},
    QuantityInfo{"updates", "updates/pixel", "stencil updates at each pixel of the picture", "overdraw.updates"},
    QuantityInfo{"stencil", "volumes/pixel", "shadow volumes of the light that hold the surface point, at each pixel of the picture", "stencil.<light>"},
};
// clang-format on

/// A quantity by its name: record(frame, place, "overdraw", distribution).
class Quantity : public TableRow<kQuantities, Quantity> {
public:
    using TableRow::TableRow;
    template <std::size_t N>
    consteval Quantity(const char (&name)[N]) : TableRow(find({name, N - 1})) {}
};

}  // namespace umbrage
