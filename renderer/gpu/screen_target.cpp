// SPDX-License-Identifier: Apache-2.0
#include "gpu/screen_target.h"

#include <array>

#include "gpu/program.h"
#include "gpu/state.h"

namespace umbrage::gpu {
namespace {

bool isInteger(GLenum internalFormat) {
    return internalFormat == GL_R32UI || internalFormat == GL_RG32UI || internalFormat == GL_RGBA32UI;
}

template <class T>
std::vector<T> readAll(const Framebuffer& from, const Texture& texture, int components) {
    constexpr std::array kFloats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
    constexpr std::array kIntegers{GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER, GL_RGBA_INTEGER};
    constexpr bool kFloat = std::is_same_v<T, float>;
    const int width = texture.size().width, height = texture.size().height;
    std::vector<T> pixels(std::size_t(components) * std::size_t(width) * std::size_t(height));
    const auto format = GLenum((kFloat ? kFloats : kIntegers)[std::size_t(components - 1)]);
    gpu::readPixels(from.name(), width, height, format, kFloat ? GL_FLOAT : GL_UNSIGNED_INT, pixels.size() * sizeof(T),
                    pixels.data());
    return pixels;
}

void allowColorWrites() {
    RasterState state;
    state.color = ColorOp::Replace;
    apply(state);
}

}  // namespace

ScreenTarget::ScreenTarget(const char* label, GLenum internalFormat, const Texture::Size& size,
                           const Texture* depthStencil)
    : texture_(label, internalFormat, size), internalFormat_(internalFormat) {
    const Framebuffer::Attachment color{&texture_};
    framebuffer_ = Framebuffer(label, std::span(&color, 1), depthStencil);
}

struct ScreenTarget::Single {
    Texture texture;
    Framebuffer framebuffer;
    Program firstSample;
    VertexArray noVertices{"full screen"};
};

ScreenTarget::Single& ScreenTarget::single() const {
    if (!single_) {
        single_ = std::make_shared<Single>();
        const Texture::Size size{texture_.size().width, texture_.size().height};
        single_->texture = Texture("one value a pixel", internalFormat_, size);
        const Framebuffer::Attachment color{&single_->texture};
        single_->framebuffer = Framebuffer("one value a pixel", std::span(&color, 1), nullptr);
        single_->firstSample =
            Program("fullscreen.vert", "first_sample.frag", {isInteger(internalFormat_) ? "INTEGERS 1" : "FLOATS 1"});
    }
    return *single_;
}

void ScreenTarget::clear() const {
    allowColorWrites();
    constexpr GLuint kNone[4] = {};
    constexpr GLfloat kZero[4] = {};
    if (isInteger(internalFormat_)) {
        glClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 0, kNone);
    } else {
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kZero);
    }
}

std::vector<float> ScreenTarget::readMean(int components) const {
    const int width = texture_.size().width, height = texture_.size().height;
    if (texture_.size().samples == 1) return readAll<float>(framebuffer_, texture_, components);
    const Single& mean = single();
    glBlitNamedFramebuffer(framebuffer_.name(), mean.framebuffer.name(), 0, 0, width, height, 0, 0, width, height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return readAll<float>(mean.framebuffer, mean.texture, components);
}

template <class T>
std::vector<T> ScreenTarget::readFirstAs(int components) const {
    if (texture_.size().samples == 1) return readAll<T>(framebuffer_, texture_, components);
    const Single& first = single();
    first.framebuffer.bind();
    allowColorWrites();
    texture_.bind(0);
    first.firstSample.use();
    first.noVertices.bind();
    ++activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return readAll<T>(first.framebuffer, first.texture, components);
}

std::vector<float> ScreenTarget::readFirst(int components) const {
    return readFirstAs<float>(components);
}

std::vector<std::uint32_t> ScreenTarget::readFirstIntegers(int components) const {
    return readFirstAs<std::uint32_t>(components);
}

}  // namespace umbrage::gpu
