// SPDX-License-Identifier: Apache-2.0
// OpenGL objects with owners, types and labels. Thin: one call of GL is one call here.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/activity.h"

namespace umbrage::gpu {

/// A GL name that is deleted with its owner. `Delete` is called with the name when it is not 0.
template <void (*Delete)(GLuint)>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_) Delete(name_);
    }
    GLuint get() const { return name_; }

private:
    GLuint name_ = 0;
};

void deleteBuffer(GLuint name);
void deleteTexture(GLuint name);
void deleteFramebuffer(GLuint name);
void deleteVertexArray(GLuint name);
void deleteQuery(GLuint name);

/// @throws Error(Device) if GL reports an error since the last call; `doing` completes "OpenGL failed ..."
void checkGl(const std::string& doing);

/// Device memory. Grows by being made anew: contents are not kept.
class Buffer {
public:
    Buffer() = default;
    Buffer(const char* label, std::size_t sizeBytes, const void* data = nullptr);

    template <class T>
    static Buffer of(const char* label, std::span<const T> values) {
        return Buffer(label, values.size_bytes(), values.data());
    }

    GLuint name() const { return handle_.get(); }
    std::size_t sizeBytes() const { return sizeBytes_; }

    void write(std::size_t offsetBytes, std::size_t sizeBytes, const void* data);
    template <class T>
    void write(std::span<const T> values) {
        write(0, values.size_bytes(), values.data());
    }
    void clearToZero();
    void bindStorage(GLuint binding) const;
    void bindUniform(GLuint binding) const;
    void bindUniform(GLuint binding, std::size_t offsetBytes, std::size_t sizeBytes) const;

    /// Waits for the device.
    void read(std::size_t offsetBytes, std::size_t sizeBytes, void* data) const;
    template <class T>
    std::vector<T> readAll() const {
        std::vector<T> values(sizeBytes_ / sizeof(T));
        if (!values.empty()) read(0, values.size() * sizeof(T), values.data());
        return values;
    }

    /// Makes it at least that large; says whether it was made anew.
    bool reserve(const char* label, std::size_t sizeBytes);

private:
    Handle<deleteBuffer> handle_;
    Allocation allocation_;
    std::size_t sizeBytes_ = 0;
};

/// A 2D texture, 2D array or multisample 2D (array) texture with immutable storage.
class Texture {
public:
    Texture() = default;
    struct Size {
        int width = 0, height = 0;
        int layers = 0;   // 0: not an array
        int samples = 1;  // 1: not multisampled
        int levels = 1;
    };
    Texture(const char* label, GLenum internalFormat, const Size& size);

    GLuint name() const { return handle_.get(); }
    const Size& size() const { return size_; }
    void bind(GLuint unit) const;

private:
    Handle<deleteTexture> handle_;
    Allocation allocation_;
    Size size_;
};

/// Attachments are given once; colour attachment i goes to fragment output i.
class Framebuffer {
public:
    struct Attachment {
        const Texture* texture = nullptr;
        int layer = -1;  // -1: the whole texture
    };
    Framebuffer() = default;
    Framebuffer(const char* label, std::span<const Attachment> colors, const Texture* depthStencil);
    /// Depth alone, one layer of an array.
    Framebuffer(const char* label, const Texture& depth, int layer);

    GLuint name() const { return handle_.get(); }
    void bind() const;

private:
    void check(const char* label) const;

    Handle<deleteFramebuffer> handle_;
    int width_ = 0, height_ = 0;
};

class VertexArray {
public:
    explicit VertexArray(const char* label);
    GLuint name() const { return handle_.get(); }
    void bind() const;

    /// A float attribute of `components` values read from a buffer; `perInstance` advances with the base instance.
    void attribute(GLuint index, const Buffer& buffer, int components, std::size_t strideBytes);
    void integerAttribute(GLuint index, const Buffer& buffer, std::size_t strideBytes, bool perInstance);
    void elements(const Buffer& buffer);

private:
    Handle<deleteVertexArray> handle_;
};

/// Samples that passed (GL_SAMPLES_PASSED), exactly (T16).
class SampleQuery {
public:
    explicit SampleQuery(const char* label);
    void begin() const;
    void end() const;
    std::uint64_t result() const;  // waits

private:
    Handle<deleteQuery> handle_;
};

}  // namespace umbrage::gpu
