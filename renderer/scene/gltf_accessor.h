// SPDX-License-Identifier: Apache-2.0
// The one reader of glTF accessors: stride, normalisation, sparse values and accessors without data. It relies on
// validateGltf() for every range, and checks what only the bytes can tell.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <string>
#include <vector>

#include "scene/gltf_budget.h"

namespace umbrage {

class AccessorReader {
public:
    /// All three must outlive the reader.
    AccessorReader(const tinygltf::Model& model, const std::string& file, MemoryBudget& budget)
        : model_(model), file_(file), budget_(budget) {}

    std::size_t count(int accessor) const { return model_.accessors[static_cast<std::size_t>(accessor)].count; }

    /// All components of all elements, matrices by columns; normalised integers as glTF 2.0, 3.6.2.2 converts them.
    /// @throws Error(Input) at `pointer` for NaN and infinities
    std::vector<float> floats(int accessor, const std::string& pointer) const;

    /// All components of an accessor of unsigned integers.
    std::vector<std::uint32_t> integers(int accessor, const std::string& pointer) const;

private:
    template <class T>
    std::vector<T> read(int accessor, const std::string& pointer, T (*decode)(const unsigned char*)) const;

    const tinygltf::Model& model_;
    const std::string& file_;
    MemoryBudget& budget_;
};

}  // namespace umbrage
