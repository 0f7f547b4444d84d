// SPDX-License-Identifier: Apache-2.0
// Small glTF documents for tests: a JSON object to edit and a buffer that grows with every accessor.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "error.h"
#include "scene/load_gltf.h"

namespace umbrage {

using nlohmann::json;

constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
              kFloatComponent = 5126;

template <class T>
constexpr int componentTypeOf() {
    if constexpr (std::is_same_v<T, std::int8_t>) {
        return kByte;
    } else if constexpr (std::is_same_v<T, std::uint8_t>) {
        return kUnsignedByte;
    } else if constexpr (std::is_same_v<T, std::int16_t>) {
        return kShort;
    } else if constexpr (std::is_same_v<T, std::uint16_t>) {
        return kUnsignedShort;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return kUnsignedInt;
    } else {
        static_assert(std::is_same_v<T, float>);
        return kFloatComponent;
    }
}

inline std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](std::size_t k) -> unsigned { return k < bytes.size() ? bytes[k] : 0u; };
        const unsigned bits = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        for (int digit = 0; digit < 4; ++digit) {
            text += i + static_cast<std::size_t>(digit) > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * digit) & 63];
        }
    }
    return text;
}

inline std::span<const std::byte> asBytes(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

struct GltfBuilder {
    json document = {{"asset", {{"version", "2.0"}}}, {"accessors", json::array()}, {"bufferViews", json::array()}};
    std::vector<unsigned char> bytes;

    template <class T>
    int view(const std::vector<T>& values, int stride = 0) {
        while (bytes.size() % 4 != 0) {
            bytes.push_back(0);
        }
        const std::size_t offset = bytes.size(), size = values.size() * sizeof(T);
        bytes.resize(offset + size);
        std::memcpy(bytes.data() + offset, values.data(), size);
        json result = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
        if (stride != 0) {
            result["byteStride"] = stride;
        }
        document["bufferViews"].push_back(result);
        return static_cast<int>(document["bufferViews"].size()) - 1;
    }

    int accessor(json description) {
        document["accessors"].push_back(std::move(description));
        return static_cast<int>(document["accessors"].size()) - 1;
    }

    template <class T>
    int accessor(const char* type, const std::vector<T>& values, std::size_t count, bool normalized = false) {
        json description = {
            {"bufferView", view(values)}, {"componentType", componentTypeOf<T>()}, {"count", count}, {"type", type}};
        if (normalized) {
            description["normalized"] = true;
        }
        return accessor(description);
    }

    int scalars(const std::vector<float>& values) { return accessor("SCALAR", values, values.size()); }
    int vec3s(const std::vector<float>& values) { return accessor("VEC3", values, values.size() / 3); }
    int vec4s(const std::vector<float>& values) { return accessor("VEC4", values, values.size() / 4); }

    /// One mesh of one primitive on one node in one scene.
    json& triangle() {
        document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", vec3s({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}}}}};
        document["nodes"] = {{{"mesh", 0}}};
        document["scenes"] = {{{"nodes", {0}}}};
        return primitive();
    }
    json& primitive() { return document["meshes"][0]["primitives"][0]; }

    std::string text() const {
        json complete = document;
        if (!bytes.empty()) {
            complete["buffers"] = {
                {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        }
        return complete.dump();
    }

    std::string glb() const {
        json complete = document;
        complete["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string jsonChunk = complete.dump(), binary(bytes.begin(), bytes.end());
        jsonChunk.resize((jsonChunk.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        const auto word = [](std::size_t value) {
            const auto narrow = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&narrow), 4);
        };
        return "glTF" + word(2) + word(28 + jsonChunk.size() + binary.size()) + word(jsonChunk.size()) + "JSON" +
               jsonChunk + word(binary.size()) + std::string("BIN\0", 4) + binary;
    }

    Scene load(const GltfOptions& options = {}) const { return loadGltf(asBytes(text()), "test.gltf", options); }
};

/// Loading must fail at "test.gltf: pointer" with a message that has the key words.
inline void expectGltfError(const std::string& text, const std::string& pointer, const std::string& words,
                            const GltfOptions& options = {}) {
    try {
        loadGltf(asBytes(text), "test.gltf", options);
        ADD_FAILURE() << "no error at " << pointer << " with \"" << words << '"';
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::Input);
        EXPECT_EQ(e.where(), pointer.empty() ? "test.gltf" : "test.gltf: " + pointer) << e.what();
        EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
}

inline void expectGltfError(const GltfBuilder& builder, const std::string& pointer, const std::string& words,
                            const GltfOptions& options = {}) {
    expectGltfError(builder.text(), pointer, words, options);
}

inline bool hasNote(const Scene& scene, const std::string& words) {
    return std::any_of(scene.notes.begin(), scene.notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

}  // namespace umbrage
