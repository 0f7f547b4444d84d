// SPDX-License-Identifier: Apache-2.0
// What is asked of the device, counted where it is asked. As GL's own state, there is one of it per thread.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <utility>

namespace umbrage::gpu {

struct Activity {
    std::uint64_t draws = 0, dispatches = 0;
    std::uint64_t stateChanges = 0;  // of raster state, program or framebuffer
    std::uint64_t uploadedBytes = 0, readBackBytes = 0;
    std::uint64_t allocatedBytes = 0;  // of buffers and textures that are alive
};

/// Since the thread began.
Activity& activity();

/// While it lives, what is asked of the device is not counted: diagnostics measure the frame, not themselves.
class Uncounted {
public:
    Uncounted() : before_(activity()) {}
    ~Uncounted() {
        const std::uint64_t allocated = activity().allocatedBytes;
        activity() = before_;
        activity().allocatedBytes = allocated;
    }
    Uncounted(const Uncounted&) = delete;
    Uncounted& operator=(const Uncounted&) = delete;

private:
    Activity before_;
};

/// Bytes of the device that live as long as this.
class Allocation {
public:
    Allocation() = default;
    explicit Allocation(std::uint64_t bytes) : bytes_(bytes) { activity().allocatedBytes += bytes; }
    Allocation(Allocation&& other) noexcept : bytes_(std::exchange(other.bytes_, 0)) {}
    Allocation& operator=(Allocation&& other) noexcept {
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~Allocation() { activity().allocatedBytes -= bytes_; }

private:
    std::uint64_t bytes_ = 0;
};

/// Of a texel in the sized internal formats that are used here. @throws std::logic_error for others
std::uint64_t bytesOfTexel(GLenum internalFormat);

/// glReadPixels() of a whole framebuffer, rows from the top. Waits.
void readPixels(GLuint framebuffer, int width, int height, GLenum format, GLenum type, std::uint64_t bytes,
                void* pixels);

}  // namespace umbrage::gpu
