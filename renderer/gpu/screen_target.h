// SPDX-License-Identifier: Apache-2.0
// A picture that is drawn into and read back: rows from the top, one value a component and pixel, whatever the number
// of samples. What reading several samples needs besides is made on first use.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/objects.h"

namespace umbrage::gpu {

class ScreenTarget {
public:
    ScreenTarget() = default;
    /// @param depthStencil  attached, too, where there is one; not owned
    ScreenTarget(const char* label, GLenum internalFormat, const Texture::Size& size, const Texture* depthStencil);

    const Texture& texture() const { return texture_; }
    const Framebuffer& framebuffer() const { return framebuffer_; }
    explicit operator bool() const { return texture_.name() != 0; }

    /// All bits 0.
    void clear() const;

    /// Mean of the samples. Waits. @param components  the first 1 to 4 of them
    std::vector<float> readMean(int components) const;
    /// The first sample. Waits.
    std::vector<float> readFirst(int components) const;
    std::vector<std::uint32_t> readFirstIntegers(int components) const;

private:
    struct Single;  // a copy with one sample
    Single& single() const;
    template <class T>
    std::vector<T> readFirstAs(int components) const;

    Texture texture_;
    Framebuffer framebuffer_;
    GLenum internalFormat_ = 0;
    mutable std::shared_ptr<Single> single_;
};

}  // namespace umbrage::gpu
