// SPDX-License-Identifier: Apache-2.0
// Images, textures and materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/gltf_convert.h"

namespace umbrage {
namespace {

std::string mimeTypeOf(const std::vector<unsigned char>& bytes) {
    const auto startsWith = [&](std::string_view magic, std::size_t offset = 0) {
        return bytes.size() >= offset + magic.size() &&
               std::memcmp(bytes.data() + offset, magic.data(), magic.size()) == 0;
    };
    if (startsWith("\x89PNG")) {
        return "image/png";
    }
    if (startsWith("\xFF\xD8\xFF")) {
        return "image/jpeg";
    }
    return startsWith("RIFF") && startsWith("WEBP", 8) ? "image/webp" : "";
}

Image convertImage(tinygltf::Image& image, std::size_t index, const std::string& file) {
    Image result;
    result.name = image.name.empty() ? fmt::format("image {} of {}", index, file) : image.name;
    const auto* begin = reinterpret_cast<const std::byte*>(image.image.data());
    result.encoded.assign(begin, begin + image.image.size());
    // The bytes are right where file and bytes disagree; decoders go by them too.
    result.mimeType = mimeTypeOf(image.image);
    if (result.mimeType.empty()) {
        result.mimeType = image.mimeType;
    }
    image.image = {};
    return result;
}

Wrap convertWrap(int wrap) {
    switch (wrap) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::ClampToEdge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::MirroredRepeat;
        default:
            return Wrap::Repeat;
    }
}

Sampler convertSampler(const tinygltf::Sampler& sampler) {
    Sampler result;
    result.wrapS = convertWrap(sampler.wrapS);
    result.wrapT = convertWrap(sampler.wrapT);
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) {
        result.magnify = Filter::Nearest;
    }
    switch (sampler.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            result.minify = Filter::Nearest;
            break;
        default:
            break;
    }
    switch (sampler.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            result.betweenMipmaps.reset();
            break;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            result.betweenMipmaps = Filter::Nearest;
            break;
        default:
            break;
    }
    return result;
}

const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

double numberOf(const tinygltf::Value& object, const std::string& key, double otherwise) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : otherwise;
}

glm::dvec2 pairOf(const tinygltf::Value& object, const std::string& key, double otherwise) {
    if (!object.Has(key)) {
        return glm::dvec2(otherwise);
    }
    return {object.Get(key).Get(0).GetNumberAsDouble(), object.Get(key).Get(1).GetNumberAsDouble()};
}

// KHR_texture_transform: translation * rotation * scale, with rotation counter-clockwise in a space whose v points
// down.
glm::mat3x2 uvTransform(const tinygltf::Value& transform) {
    const glm::dvec2 offset = pairOf(transform, "offset", 0.0), scale = pairOf(transform, "scale", 1.0);
    const double angle = numberOf(transform, "rotation", 0.0);
    const double c = std::cos(angle), s = std::sin(angle);
    return glm::mat3x2(glm::dmat3x2(c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x, offset.y));
}

class MaterialConverter {
public:
    MaterialConverter(GltfConversion& conversion, std::size_t index)
        : conversion_(conversion),
          source_(conversion.model.materials[index]),
          pointer_(fmt::format("/materials/{}", index)) {}

    Material convert() const {
        const auto& pbr = source_.pbrMetallicRoughness;
        Material result;
        result.name = source_.name;
        for (int i = 0; i < 4; ++i) {
            result.baseColor[i] =
                unit(pbr.baseColorFactor[static_cast<std::size_t>(i)], "/pbrMetallicRoughness/baseColorFactor");
        }
        result.metallic = unit(pbr.metallicFactor, "/pbrMetallicRoughness/metallicFactor");
        result.roughness = unit(pbr.roughnessFactor, "/pbrMetallicRoughness/roughnessFactor");
        result.baseColorTexture = use(pbr.baseColorTexture, "/pbrMetallicRoughness/baseColorTexture");
        result.metallicRoughnessTexture =
            use(pbr.metallicRoughnessTexture, "/pbrMetallicRoughness/metallicRoughnessTexture");
        result.normalTexture = use(source_.normalTexture, "/normalTexture");
        result.normalScale = static_cast<float>(source_.normalTexture.scale);
        result.occlusionTexture = use(source_.occlusionTexture, "/occlusionTexture");
        result.occlusionStrength = unit(source_.occlusionTexture.strength, "/occlusionTexture/strength");
        result.emissiveTexture = use(source_.emissiveTexture, "/emissiveTexture");
        result.emissive = emissive();
        result.alphaMode = source_.alphaMode == "MASK"    ? AlphaMode::Mask
                           : source_.alphaMode == "BLEND" ? AlphaMode::Blend
                                                          : AlphaMode::Opaque;
        // Above 1 it means that everything is cut away, so only the lower end is a limit.
        result.alphaCutoff = clamped(source_.alphaCutoff, 0.0, source_.alphaCutoff, "/alphaCutoff");
        result.doubleSided = source_.doubleSided;
        result.unlit = findExtension(source_.extensions, "KHR_materials_unlit") != nullptr;
        return result;
    }

private:
    float clamped(double value, double least, double most, const char* member) const {
        const double result = std::max(least, std::min(value, most));
        if (result != value) {
            conversion_.notes.add(pointer_ + member, fmt::format("{} is out of range and became {}", value, result));
        }
        return static_cast<float>(result);
    }
    float unit(double value, const char* member) const { return clamped(value, 0.0, 1.0, member); }

    glm::vec3 emissive() const {
        double strength = 1.0;
        if (const auto* extension = findExtension(source_.extensions, "KHR_materials_emissive_strength")) {
            strength = clamped(numberOf(*extension, "emissiveStrength", 1.0), 0.0, 3.4e38,
                               "/extensions/KHR_materials_emissive_strength");
        }
        glm::vec3 result;
        for (int i = 0; i < 3; ++i) {
            result[i] = static_cast<float>(
                unit(source_.emissiveFactor[static_cast<std::size_t>(i)], "/emissiveFactor") * strength);
        }
        return result;
    }

    template <class TextureInfo>
    TextureUse use(const TextureInfo& info, const char* member) const {
        TextureUse result;
        if (info.index < 0) {
            return result;
        }
        result.texCoordSet = info.texCoord;
        if (const auto* transform = findExtension(info.extensions, "KHR_texture_transform")) {
            result.uvFromTexCoord = uvTransform(*transform);
            result.texCoordSet = static_cast<int>(numberOf(*transform, "texCoord", info.texCoord));
        }
        if (result.texCoordSet >= kTexCoordSetCount) {
            conversion_.notes.add(
                pointer_ + member,
                fmt::format("uses texture coordinate set {}, but only {} are supported; it is left out",
                            result.texCoordSet, kTexCoordSetCount));
            return {};
        }
        if (conversion_.scene.textures[static_cast<std::size_t>(info.index)].image == kNone) {
            conversion_.notes.add(pointer_ + member,
                                  "uses a texture without an image in a supported format; it is left out");
            return {};
        }
        result.texture = info.index;
        return result;
    }

    GltfConversion& conversion_;
    const tinygltf::Material& source_;
    std::string pointer_;
};

}  // namespace

void convertTextures(GltfConversion& conversion) {
    auto& model = conversion.model;
    for (std::size_t i = 0; i < model.images.size(); ++i) {
        conversion.scene.images.push_back(convertImage(model.images[i], i, conversion.file));
    }
    for (const tinygltf::Texture& texture : model.textures) {
        Texture result;
        result.image = texture.source;
        if (const auto* webp = findExtension(texture.extensions, "EXT_texture_webp");
            webp != nullptr && webp->Has("source")) {
            result.image = webp->Get("source").GetNumberAsInt();
        }
        if (texture.sampler >= 0) {
            result.sampler = convertSampler(model.samplers[static_cast<std::size_t>(texture.sampler)]);
        }
        conversion.scene.textures.push_back(result);
    }
}

void convertMaterials(GltfConversion& conversion) {
    for (std::size_t i = 0; i < conversion.model.materials.size(); ++i) {
        conversion.scene.materials.push_back(MaterialConverter(conversion, i).convert());
    }
}

}  // namespace umbrage
