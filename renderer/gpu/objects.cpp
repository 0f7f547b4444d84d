// SPDX-License-Identifier: Apache-2.0
#include "gpu/objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "error.h"
#include "shaders/shared.h"

namespace umbrage::gpu {

void deleteBuffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
void deleteTexture(GLuint name) {
    glDeleteTextures(1, &name);
}
void deleteFramebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}
void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}
void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

void checkGl(const std::string& doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    const char* what = error == GL_OUT_OF_MEMORY ? "the device is out of memory, error" : "error";
    throw Error(ErrorKind::Device, "", fmt::format("OpenGL failed {}: {} 0x{:x}", doing, what, error),
                "a smaller picture, fewer samples or fewer lights need less");
}

Buffer::Buffer(const char* label, std::size_t sizeBytes, const void* data) : sizeBytes_(sizeBytes) {
    if (data) activity().uploadedBytes += sizeBytes;
    GLuint name = 0;
    glCreateBuffers(1, &name);
    handle_ = Handle<deleteBuffer>(name);
    // An empty buffer is given a little: a binding of size 0 is an error, and nothing reads it.
    const std::size_t allocated = sizeBytes ? sizeBytes : 16;
    allocation_ = Allocation(allocated);
    glNamedBufferStorage(name, GLsizeiptr(allocated), sizeBytes ? data : nullptr, GL_DYNAMIC_STORAGE_BIT);
    glObjectLabel(GL_BUFFER, name, -1, label);
    checkGl(fmt::format("to make the buffer '{}' of {} bytes", label, sizeBytes));
}

void Buffer::write(std::size_t offsetBytes, std::size_t sizeBytes, const void* data) {
    activity().uploadedBytes += sizeBytes;
    if (sizeBytes) glNamedBufferSubData(name(), GLintptr(offsetBytes), GLsizeiptr(sizeBytes), data);
}

void Buffer::clearToZero() {
    glClearNamedBufferData(name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void Buffer::bindStorage(GLuint binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name());
}

void Buffer::bindUniform(GLuint binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, name());
}

void Buffer::bindUniform(GLuint binding, std::size_t offsetBytes, std::size_t sizeBytes) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, binding, name(), GLintptr(offsetBytes), GLsizeiptr(sizeBytes));
}

void Buffer::read(std::size_t offsetBytes, std::size_t sizeBytes, void* data) const {
    activity().readBackBytes += sizeBytes;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(name(), GLintptr(offsetBytes), GLsizeiptr(sizeBytes), data);
}

bool Buffer::reserve(const char* label, std::size_t sizeBytes) {
    if (name() && sizeBytes <= sizeBytes_) return false;
    *this = Buffer(label, sizeBytes);
    return true;
}

static std::uint64_t bytesOf(GLenum internalFormat, const Texture::Size& size) {
    std::uint64_t texels = 0;
    for (int level = 0; level < size.levels; ++level) {
        texels += std::uint64_t(std::max(1, size.width >> level)) * std::uint64_t(std::max(1, size.height >> level));
    }
    return texels * std::uint64_t(std::max(1, size.layers) * size.samples) * bytesOfTexel(internalFormat);
}

Texture::Texture(const char* label, GLenum internalFormat, const Size& size)
    : allocation_(bytesOf(internalFormat, size)), size_(size) {
    const bool array = size.layers > 0, multisample = size.samples > 1;
    const GLenum target = multisample ? (array ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_MULTISAMPLE)
                                      : (array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D);
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    handle_ = Handle<deleteTexture>(name);
    if (multisample && array) {
        glTextureStorage3DMultisample(name, size.samples, internalFormat, size.width, size.height, size.layers,
                                      GL_TRUE);
    } else if (multisample) {
        glTextureStorage2DMultisample(name, size.samples, internalFormat, size.width, size.height, GL_TRUE);
    } else if (array) {
        glTextureStorage3D(name, size.levels, internalFormat, size.width, size.height, size.layers);
    } else {
        glTextureStorage2D(name, size.levels, internalFormat, size.width, size.height);
    }
    if (!multisample) {
        glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glObjectLabel(GL_TEXTURE, name, -1, label);
    checkGl(
        fmt::format("to make the texture '{}' of {} x {} x {} samples", label, size.width, size.height, size.samples));
}

void Texture::bind(GLuint unit) const {
    glBindTextureUnit(unit, name());
}

Framebuffer::Framebuffer(const char* label, std::span<const Attachment> colors, const Texture* depthStencil) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    handle_ = Handle<deleteFramebuffer>(name);
    std::vector<GLenum> outputs;
    for (const Attachment& color : colors) {
        const GLenum point = GL_COLOR_ATTACHMENT0 + GLenum(outputs.size());
        outputs.push_back(point);
        if (color.layer >= 0) {
            glNamedFramebufferTextureLayer(name, point, color.texture->name(), 0, color.layer);
        } else {
            glNamedFramebufferTexture(name, point, color.texture->name(), 0);
        }
        width_ = color.texture->size().width;
        height_ = color.texture->size().height;
    }
    if (depthStencil) {
        glNamedFramebufferTexture(name, GL_DEPTH_STENCIL_ATTACHMENT, depthStencil->name(), 0);
        width_ = depthStencil->size().width;
        height_ = depthStencil->size().height;
    }
    glNamedFramebufferDrawBuffers(name, GLsizei(outputs.size()), outputs.data());
    check(label);
}

Framebuffer::Framebuffer(const char* label, const Texture& depth, int layer)
    : width_(depth.size().width), height_(depth.size().height) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    handle_ = Handle<deleteFramebuffer>(name);
    glNamedFramebufferTextureLayer(name, GL_DEPTH_ATTACHMENT, depth.name(), 0, layer);
    glNamedFramebufferDrawBuffers(name, 0, nullptr);
    check(label);
}

void Framebuffer::check(const char* label) const {
    glObjectLabel(GL_FRAMEBUFFER, name(), -1, label);
    if (const GLenum status = glCheckNamedFramebufferStatus(name(), GL_FRAMEBUFFER);
        status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(
            ErrorKind::Device, "",
            fmt::format("the device cannot draw into '{}' of {} x {} pixels (0x{:x})", label, width_, height_, status),
            "a smaller picture or fewer samples need less");
    }
}

void Framebuffer::bind() const {
    ++activity().stateChanges;
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    constexpr float kScale = float(VIEWPORT_SCALE);
    const float width = float(width_), height = float(height_);
    glViewportIndexedf(0, 0.5f * (1.0f - kScale) * width, 0.5f * (1.0f - kScale) * height, kScale * width,
                       kScale * height);
}

VertexArray::VertexArray(const char* label) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    handle_ = Handle<deleteVertexArray>(name);
    glObjectLabel(GL_VERTEX_ARRAY, name, -1, label);
}

void VertexArray::bind() const {
    glBindVertexArray(name());
}

void VertexArray::attribute(GLuint index, const Buffer& buffer, int components, std::size_t strideBytes) {
    glEnableVertexArrayAttrib(name(), index);
    glVertexArrayVertexBuffer(name(), index, buffer.name(), 0, GLsizei(strideBytes));
    glVertexArrayAttribFormat(name(), index, components, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(name(), index, index);
}

void VertexArray::integerAttribute(GLuint index, const Buffer& buffer, std::size_t strideBytes, bool perInstance) {
    glEnableVertexArrayAttrib(name(), index);
    glVertexArrayVertexBuffer(name(), index, buffer.name(), 0, GLsizei(strideBytes));
    glVertexArrayAttribIFormat(name(), index, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(name(), index, index);
    glVertexArrayBindingDivisor(name(), index, perInstance ? 1 : 0);
}

void VertexArray::elements(const Buffer& buffer) {
    glVertexArrayElementBuffer(name(), buffer.name());
}

SampleQuery::SampleQuery(const char* label) {
    GLuint name = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
    handle_ = Handle<deleteQuery>(name);
    glObjectLabel(GL_QUERY, name, -1, label);
}

void SampleQuery::begin() const {
    glBeginQuery(GL_SAMPLES_PASSED, handle_.get());
}

void SampleQuery::end() const {
    glEndQuery(GL_SAMPLES_PASSED);
}

std::uint64_t SampleQuery::result() const {
    GLuint64 samples = 0;
    glGetQueryObjectui64v(handle_.get(), GL_QUERY_RESULT, &samples);
    return samples;
}

}  // namespace umbrage::gpu
