// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace umbrage {

/// A row of `table`, an array of structures with a `name`.
///
/// @tparam Row  the class that derives from this one
template <const auto& table, class Row>
class TableRow {
public:
    explicit constexpr TableRow(std::size_t index) : index_(index) {}

    /// The row at a position in the table.
    static constexpr Row at(std::size_t index) { return Row(index); }

    constexpr std::size_t index() const { return index_; }
    constexpr const auto& info() const { return table[index_]; }

protected:
    /// While compiling: a misspelt name does not compile.
    static consteval std::size_t find(std::string_view name) {
        for (std::size_t i = 0; i < table.size(); ++i) {
            if (table[i].name == name) return i;
        }
        throw std::invalid_argument("no such name");
    }

private:
    std::size_t index_;
};

}  // namespace umbrage
