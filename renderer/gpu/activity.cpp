// SPDX-License-Identifier: Apache-2.0
#include "gpu/activity.h"

#include <fmt/format.h>

#include <stdexcept>

namespace umbrage::gpu {

Activity& activity() {
    static thread_local Activity counted;
    return counted;
}

std::uint64_t bytesOfTexel(GLenum internalFormat) {
    switch (internalFormat) {
        case GL_R8:
            return 1;
        case GL_RG8:
        case GL_R16:
            return 2;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_RG16:
        case GL_R32F:
        case GL_R32UI:
        case GL_DEPTH_COMPONENT32F:
            return 4;
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_RG32F:
        case GL_RG32UI:
        case GL_DEPTH32F_STENCIL8:
            return 8;
        case GL_RGBA32F:
        case GL_RGBA32UI:
            return 16;
        default:
            throw std::logic_error(fmt::format("no size is known for texels of format 0x{:x}", internalFormat));
    }
}

void readPixels(GLuint framebuffer, int width, int height, GLenum format, GLenum type, std::uint64_t bytes,
                void* pixels) {
    activity().readBackBytes += bytes;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, width, height, format, type, pixels);
}

}  // namespace umbrage::gpu
