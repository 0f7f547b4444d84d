// SPDX-License-Identifier: Apache-2.0
// How much memory a glTF file may ask for. Small files can name huge arrays (accessors without data, one buffer view
// shared by thousands of primitives), so whatever is made from a file is charged against the bytes it really has.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "scene/gltf_json.h"

namespace umbrage {

class MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t sourceBytes) : sourceBytes_(sourceBytes) {}

    /// @throws Error(Input) at that place when this is more than the file's size allows
    void spend(std::uint64_t bytes, const std::string& file, const std::string& pointer) {
        // Quantised data and indices grow fourfold, strips threefold more, and instances by copies of a mesh's data.
        constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{64} << 20, kGrowth = 64;
        const std::uint64_t limit = kAlwaysAllowed + kGrowth * sourceBytes_;
        if (bytes > limit - spentBytes_) {
            failAt(file, pointer,
                   fmt::format(
                       "needs {} more bytes of memory; {} of the {} that are allowed for {} bytes of files are in use",
                       bytes, spentBytes_, limit, sourceBytes_));
        }
        spentBytes_ += bytes;
    }

private:
    std::uint64_t sourceBytes_, spentBytes_ = 0;
};

}  // namespace umbrage
