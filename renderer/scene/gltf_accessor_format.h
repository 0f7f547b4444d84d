// SPDX-License-Identifier: Apache-2.0
// Component and element types of glTF accessors (glTF 2.0, 3.6.2), shared by the validator and the reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace umbrage {

/// glTF's own numbers.
enum class ComponentType : std::uint16_t { I8 = 5120, U8 = 5121, I16 = 5122, U16 = 5123, U32 = 5125, Float = 5126 };

constexpr std::size_t componentBytes(ComponentType type) {
    switch (type) {
        case ComponentType::I8:
        case ComponentType::U8:
            return 1;
        case ComponentType::I16:
        case ComponentType::U16:
            return 2;
        case ComponentType::U32:
        case ComponentType::Float:
            break;
    }
    return 4;
}

/// Columns of rows: VEC3 is one column of three rows.
struct ElementType {
    std::string_view name;
    std::uint8_t columns, rows;

    constexpr std::size_t componentCount() const { return std::size_t{columns} * rows; }
};

inline constexpr ElementType kElementTypes[] = {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4},
                                                {"MAT2", 2, 2},   {"MAT3", 3, 3}, {"MAT4", 4, 4}};

constexpr const ElementType* findElementType(std::string_view name) {
    for (const ElementType& type : kElementTypes) {
        if (type.name == name) {
            return &type;
        }
    }
    return nullptr;
}

/// The columns of matrices start at multiples of four bytes.
constexpr std::size_t elementBytes(const ElementType& type, ComponentType component) {
    const std::size_t column = type.rows * componentBytes(component);
    return type.columns == 1 ? column : type.columns * ((column + 3) / 4 * 4);
}

/// One bit for every way to store a component, so that a set of allowed ones is a word.
using ComponentFormats = std::uint16_t;
inline constexpr ComponentFormats kI8 = 1, kI8Norm = 2, kU8 = 4, kU8Norm = 8, kI16 = 16, kI16Norm = 32, kU16 = 64,
                                  kU16Norm = 128, kU32 = 256, kFloat = 512;

constexpr ComponentFormats formatOf(ComponentType type, bool normalized) {
    switch (type) {
        case ComponentType::I8:
            return normalized ? kI8Norm : kI8;
        case ComponentType::U8:
            return normalized ? kU8Norm : kU8;
        case ComponentType::I16:
            return normalized ? kI16Norm : kI16;
        case ComponentType::U16:
            return normalized ? kU16Norm : kU16;
        case ComponentType::U32:
            return kU32;
        case ComponentType::Float:
            break;
    }
    return kFloat;
}

/// "VEC3 of normalised UNSIGNED_BYTE"
std::string formatName(const ElementType& type, ComponentType component, bool normalized);

}  // namespace umbrage
