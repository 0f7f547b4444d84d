// SPDX-License-Identifier: Apache-2.0
// Table 1 of Laine 2005 as far as counts go. Ratios are not kept: one of the printed ones is a slip (16KNIGHTS, pixels
// updated by ZF+DB: 5167.6 / 1966.5 is 2.63, printed 2.35).
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

/// Thousands a frame.
struct PrintedFigures {
    double tiles, pixels, updates;  // not culled, processed, updated
};

struct PrintedRow {
    std::string_view name;
    PrintedFigures zPass, zFail, splitPlane;  // ZP+DB, ZF+DB, SPSV

    /// @return  null for methods the paper does not have
    const PrintedFigures* of(std::string_view method) const {
        if (method == "ZP+DB") return &zPass;
        if (method == "ZF+DB") return &zFail;
        return method == "SPSV" ? &splitPlane : nullptr;
    }
};

inline constexpr std::array kPrintedRows = {
    PrintedRow{"KNIGHT", {22.2, 512.3, 452.7}, {20.8, 490.8, 441.4}, {7.7, 170.4, 129.1}},
    PrintedRow{"16KNIGHTS", {326.5, 8016.1, 6744.7}, {286.1, 6425.5, 5167.6}, {131.1, 2738.7, 1966.5}},
    PrintedRow{"TREE", {128.8, 4008.8, 3881.4}, {96.6, 2724.6, 2456.3}, {52.8, 1454.9, 1187.5}},
    PrintedRow{"TREE-DECOMPOSED", {71.8, 2170.4, 1925.5}, {70.8, 1976.9, 1681.0}, {19.0, 412.5, 136.6}},
};

}  // namespace umbrage
