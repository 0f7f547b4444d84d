// SPDX-License-Identifier: Apache-2.0
#include "shading/materials.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "image/image.h"
#include "shaders/shared.h"

namespace umbrage {
namespace {

bool isColor(int use) {
    return use == TEXTURE_BASE_COLOR || use == TEXTURE_EMISSIVE;
}

std::array<const TextureUse*, TEXTURE_COUNT> usesOf(const Material& m) {
    return {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture,
            &m.emissiveTexture};
}

float linearFromSrgb(float c) {
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

/// RGBA of the image's own type: grey is repeated, a missing alpha is 1.
template <class T>
std::vector<T> toRgba(const DecodedImage& image) {
    const std::size_t pixelCount = std::size_t(image.width) * std::size_t(image.height);
    const auto n = std::size_t(image.channelCount);
    std::vector<T> rgba(4 * pixelCount);
    for (std::size_t i = 0; i < pixelCount; ++i) {
        T in[4];
        std::memcpy(in, image.pixels.data() + i * n * sizeof(T), n * sizeof(T));
        for (std::size_t c = 0; c < 3; ++c) rgba[4 * i + c] = in[n >= 3 ? c : 0];
        rgba[4 * i + 3] = n == 4 ? in[3] : n == 2 ? in[1] : std::numeric_limits<T>::max();
    }
    return rgba;
}

GLint wrapMode(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return GL_REPEAT;
        case Wrap::MirroredRepeat:
            return GL_MIRRORED_REPEAT;
        default:
            return GL_CLAMP_TO_EDGE;
    }
}

GLint minifyMode(const Sampler& sampler) {
    const bool linear = sampler.minify == Filter::Linear;
    if (!sampler.betweenMipmaps) return linear ? GL_LINEAR : GL_NEAREST;
    if (*sampler.betweenMipmaps == Filter::Linear) return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
}

gpu::Texture upload(const DecodedImage& image, const Sampler& sampler, bool color) {
    gpu::Texture::Size size{image.width, image.height};
    if (sampler.betweenMipmaps) size.levels = 1 + int(std::log2(std::max(image.width, image.height)));
    const bool wide = image.type == PixelType::UInt16;
    // There is no 16-bit sRGB format, so such colours are made linear here.
    const GLenum format = wide ? (color ? GL_RGBA16F : GL_RGBA16) : (color ? GL_SRGB8_ALPHA8 : GL_RGBA8);
    gpu::Texture texture("material texture", format, size);
    if (!wide) {
        glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                            toRgba<std::uint8_t>(image).data());
    } else if (!color) {
        glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_SHORT,
                            toRgba<std::uint16_t>(image).data());
    } else {
        const std::vector<std::uint16_t> rgba = toRgba<std::uint16_t>(image);
        std::vector<float> linear(rgba.size());
        for (std::size_t i = 0; i < rgba.size(); ++i) {
            const float value = float(rgba[i]) / 65535.0f;
            linear[i] = i % 4 == 3 ? value : linearFromSrgb(value);
        }
        glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, linear.data());
    }
    if (sampler.betweenMipmaps) glGenerateTextureMipmap(texture.name());
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, wrapMode(sampler.wrapS));
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, wrapMode(sampler.wrapT));
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, minifyMode(sampler));
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER,
                        sampler.magnify == Filter::Linear ? GL_LINEAR : GL_NEAREST);
    return texture;
}

/// Decodes images on all cores; the first error (in the order of images) is thrown.
std::map<Index, DecodedImage> decodeAll(const Scene& scene, const std::set<Index>& wanted) {
    std::vector<std::pair<Index, DecodedImage>> decoded;
    for (const Index i : wanted) decoded.emplace_back(i, DecodedImage{});
    std::vector<std::exception_ptr> errors(decoded.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < decoded.size(); i = next++) {
            try {
                const Image& image = scene.images[std::size_t(decoded[i].first)];
                decoded[i].second = codec().decode(image.encoded, image.name);
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> workers;
        for (std::size_t i = 1; i < std::min<std::size_t>(std::thread::hardware_concurrency(), decoded.size()); ++i) {
            workers.emplace_back(work);
        }
        work();
    }
    for (const std::exception_ptr& error : errors) {
        if (error) std::rethrow_exception(error);
    }
    return {std::make_move_iterator(decoded.begin()), std::make_move_iterator(decoded.end())};
}

static_assert(sizeof(gpu::MaterialData) % 256 == 0);  // the coarsest alignment of uniform buffer offsets GL allows

gpu::MaterialData deviceMaterial(const Material& m) {
    gpu::MaterialData data{};
    data.baseColor = m.baseColor;
    data.emissive = {m.emissive, m.alphaMode == AlphaMode::Mask ? m.alphaCutoff : -1.0f};
    data.factors = {m.metallic, m.roughness, m.normalScale, m.occlusionStrength};
    if (m.unlit) data.flags |= MATERIAL_UNLIT;
    return data;
}

}  // namespace

Materials::Materials(const Scene& scene) : materials_(scene.materials) {
    materials_.emplace_back();
    std::set<Index> images;
    const auto textureOf = [&](const TextureUse& use) -> const Texture* {
        if (use.texture == kNone) return nullptr;
        const Texture& texture = scene.textures[std::size_t(use.texture)];
        return texture.image == kNone ? nullptr : &texture;
    };
    for (const Material& material : materials_) {
        for (const TextureUse* use : usesOf(material)) {
            if (const Texture* texture = textureOf(*use)) images.insert(texture->image);
        }
    }
    const std::map<Index, DecodedImage> decoded = decodeAll(scene, images);

    std::map<std::pair<Index, bool>, int> uploaded;  // texture of the scene, as colour or as data
    std::vector<gpu::MaterialData> data;
    for (const Material& material : materials_) {
        data.push_back(deviceMaterial(material));
        data.back().entry = gpu::uint(data.size() - 1);
        textureOf_.push_back({-1, -1, -1, -1, -1});
        for (int u = 0; u < TEXTURE_COUNT; ++u) {
            const TextureUse& use = *usesOf(material)[std::size_t(u)];
            const Texture* texture = textureOf(use);
            if (!texture) continue;
            const auto [entry, isNew] = uploaded.try_emplace({use.texture, isColor(u)}, int(textures_.size()));
            if (isNew) textures_.push_back(upload(decoded.at(texture->image), texture->sampler, isColor(u)));
            textureOf_.back()[std::size_t(u)] = entry->second;
            data.back().textures |= 1u << u;
            for (int r = 0; r < 2; ++r) {
                const glm::mat3x2& m = use.uvFromTexCoord;
                data.back().uvRows[2 * u + r] = {m[0][r], m[1][r], m[2][r], float(use.texCoordSet)};
            }
        }
    }
    buffer_ = gpu::Buffer::of("materials", std::span<const gpu::MaterialData>(data));
    white_ = gpu::Texture("no texture", GL_RGBA8, {1, 1});
}

std::uint32_t Materials::texturesOf(std::uint32_t entry) const {
    std::uint32_t bits = 0;
    for (std::size_t u = 0; u < TEXTURE_COUNT; ++u) bits |= std::uint32_t(textureOf_[entry][u] >= 0) << u;
    return bits;
}

void Materials::bind(std::uint32_t entry) const {
    buffer_.bindUniform(BIND_MATERIAL, entry * sizeof(gpu::MaterialData), sizeof(gpu::MaterialData));
    for (std::size_t u = 0; u < TEXTURE_COUNT; ++u) {
        const int texture = textureOf_[entry][u];
        (texture < 0 ? white_ : textures_[std::size_t(texture)]).bind(GLuint(u));
    }
}

}  // namespace umbrage
