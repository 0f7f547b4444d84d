// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/gltf_accessor_format.h"

namespace umbrage {
namespace {

using Accessor = tinygltf::Accessor;

// Rounded once: every small integer and every divisor is exact in float, and float division rounds correctly.
template <class Stored, bool kNormalized>
float decodeFloat(const unsigned char* bytes) {
    Stored stored;
    std::memcpy(&stored, bytes, sizeof stored);
    const auto value = static_cast<float>(stored);
    return kNormalized ? std::max(value / static_cast<float>(std::numeric_limits<Stored>::max()), -1.0f) : value;
}

template <class Stored>
std::uint32_t decodeInteger(const unsigned char* bytes) {
    Stored stored;
    std::memcpy(&stored, bytes, sizeof stored);
    return stored;
}

using FloatDecoder = float (*)(const unsigned char*);
using IntegerDecoder = std::uint32_t (*)(const unsigned char*);

FloatDecoder floatDecoder(ComponentType type, bool normalized) {
    switch (type) {
        case ComponentType::I8:
            return normalized ? decodeFloat<std::int8_t, true> : decodeFloat<std::int8_t, false>;
        case ComponentType::U8:
            return normalized ? decodeFloat<std::uint8_t, true> : decodeFloat<std::uint8_t, false>;
        case ComponentType::I16:
            return normalized ? decodeFloat<std::int16_t, true> : decodeFloat<std::int16_t, false>;
        case ComponentType::U16:
            return normalized ? decodeFloat<std::uint16_t, true> : decodeFloat<std::uint16_t, false>;
        case ComponentType::U32:
            return decodeFloat<std::uint32_t, false>;
        case ComponentType::Float:
            break;
    }
    return decodeFloat<float, false>;
}

IntegerDecoder integerDecoder(ComponentType type) {
    switch (componentBytes(type)) {
        case 1:
            return decodeInteger<std::uint8_t>;
        case 2:
            return decodeInteger<std::uint16_t>;
        default:
            return decodeInteger<std::uint32_t>;
    }
}

ComponentType componentOf(const Accessor& accessor) {
    return static_cast<ComponentType>(accessor.componentType);
}

ElementType elementOf(const Accessor& accessor) {
    switch (accessor.type) {
        case TINYGLTF_TYPE_SCALAR:
            return kElementTypes[0];
        case TINYGLTF_TYPE_MAT2:
        case TINYGLTF_TYPE_MAT3:
        case TINYGLTF_TYPE_MAT4:
            return kElementTypes[accessor.type - TINYGLTF_TYPE_MAT2 + 4];
        default:
            return kElementTypes[accessor.type - TINYGLTF_TYPE_VEC2 + 1];
    }
}

// Decodes the components of one element, skipping the padding between a matrix's columns.
template <class T>
void decodeElement(const unsigned char* bytes, const ElementType& type, ComponentType component,
                   T (*decode)(const unsigned char*), T* result) {
    const std::size_t columnBytes = elementBytes(type, component) / type.columns;
    for (std::size_t column = 0; column < type.columns; ++column) {
        for (std::size_t row = 0; row < type.rows; ++row) {
            *result++ = decode(bytes + column * columnBytes + row * componentBytes(component));
        }
    }
}

}  // namespace

template <class T>
std::vector<T> AccessorReader::read(int index, const std::string& pointer, T (*decode)(const unsigned char*)) const {
    const Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    const ElementType type = elementOf(accessor);
    const ComponentType component = componentOf(accessor);
    const std::size_t width = type.componentCount();
    budget_.spend(accessor.count * width * sizeof(T), file_, pointer);
    std::vector<T> result(accessor.count * width);

    const auto bytesOf = [&](int view, std::size_t offset) {
        const tinygltf::BufferView& bufferView = model_.bufferViews[static_cast<std::size_t>(view)];
        return model_.buffers[static_cast<std::size_t>(bufferView.buffer)].data.data() + bufferView.byteOffset + offset;
    };
    const std::size_t packedBytes = elementBytes(type, component);
    if (accessor.bufferView >= 0) {
        const std::size_t declared = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        const std::size_t stride = declared == 0 ? packedBytes : declared;
        const unsigned char* bytes = bytesOf(accessor.bufferView, accessor.byteOffset);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            decodeElement(bytes + i * stride, type, component, decode, &result[i * width]);
        }
    }
    if (accessor.sparse.isSparse) {
        const auto& sparse = accessor.sparse;
        const auto indexType = static_cast<ComponentType>(sparse.indices.componentType);
        const IntegerDecoder decodeIndex = integerDecoder(indexType);
        const unsigned char* indices =
            bytesOf(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset));
        const unsigned char* values =
            bytesOf(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset));
        std::int64_t previous = -1;
        for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
            const std::uint32_t target = decodeIndex(indices + i * componentBytes(indexType));
            if (target <= previous || target >= accessor.count) {
                failAt(file_, fmt::format("/accessors/{}/sparse/indices", index),
                       fmt::format("index {} is {} after {}, but they must increase and stay below {}", i, target,
                                   previous, accessor.count));
            }
            previous = target;
            decodeElement(values + i * packedBytes, type, component, decode, &result[target * width]);
        }
    }
    return result;
}

std::vector<float> AccessorReader::floats(int index, const std::string& pointer) const {
    const Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    auto result = read(index, pointer, floatDecoder(componentOf(accessor), accessor.normalized));
    const auto bad = std::find_if(result.begin(), result.end(), [](float value) { return !std::isfinite(value); });
    if (bad != result.end()) {
        failAt(file_, pointer,
               fmt::format("element {} of accessor {} has the component {}, which is not a finite number",
                           static_cast<std::size_t>(bad - result.begin()) / elementOf(accessor).componentCount(), index,
                           *bad));
    }
    return result;
}

std::vector<std::uint32_t> AccessorReader::integers(int index, const std::string& pointer) const {
    return read(index, pointer, integerDecoder(componentOf(model_.accessors[static_cast<std::size_t>(index)])));
}

}  // namespace umbrage
