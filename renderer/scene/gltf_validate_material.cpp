// SPDX-License-Identifier: Apache-2.0
// Images, textures, samplers and materials. Factors outside their range are clamped by the conversion, with a note.
#include <fmt/format.h>

#include "scene/gltf_validate_parts.h"

namespace umbrage {
namespace {

constexpr std::uint64_t kLargestImage = 0x7FFFFFFF;  // tinygltf takes the size as an int

void validateImage(Validation& validation, const JsonView& image) {
    const auto uri = image.find("uri");
    const auto view = image.index("bufferView", validation.bufferViews.size(), "buffer view");
    if (uri.has_value() == view.has_value()) {
        image.fail("must have either a \"uri\" or a \"bufferView\"");
    }
    if (const auto mimeType = image.find("mimeType")) {
        mimeType->text();
    }
    std::uint64_t sizeBytes = 0;
    std::optional<GltfSource> source;
    if (uri) {
        source = validation.files.resolve(*uri);
        sizeBytes = source->sizeBytes;
    } else {
        const JsonView& json = validation.bufferViews[*view];
        sizeBytes = json.at("byteLength").value().get<std::uint64_t>();
        if (!validation.facts.buffers[json.at("buffer").value().get<std::size_t>()]) {
            image.fail(fmt::format("is in buffer view {}, whose buffer has no data", *view));
        }
    }
    if (sizeBytes == 0 || sizeBytes > kLargestImage) {
        image.fail(fmt::format("has {} bytes; from 1 to {} can be an image", sizeBytes, kLargestImage));
    }
    validation.facts.images.push_back(std::move(source));
}

void validateSampler(const JsonView& sampler) {
    if (const auto filter = sampler.find("magFilter")) {
        requireEnum(*filter, {9728, 9729});
    }
    if (const auto filter = sampler.find("minFilter")) {
        requireEnum(*filter, {9728, 9729, 9984, 9985, 9986, 9987});
    }
    for (const char* key : {"wrapS", "wrapT"}) {
        if (const auto wrap = sampler.find(key)) {
            requireEnum(*wrap, {33071, 33648, 10497});
        }
    }
}

void validateTextureUse(const Validation& validation, const JsonView& parent, const std::string& key) {
    const auto use = parent.find(key);
    if (!use) {
        return;
    }
    constexpr std::uint64_t kMostSets = 1000;
    use->at("index").index(validation.textureCount, "texture");
    use->integer("texCoord", 0, kMostSets);
    use->number("scale", 1.0);
    use->number("strength", 1.0);
    if (const auto transform = use->extension("KHR_texture_transform")) {
        for (const char* pair : {"offset", "scale"}) {
            if (const auto value = transform->find(pair)) {
                value->numbers(2);
            }
        }
        transform->number("rotation", 0.0);
        transform->integer("texCoord", 0, kMostSets);
    }
}

void validateMaterial(const Validation& validation, const JsonView& material) {
    if (const auto pbr = material.find("pbrMetallicRoughness")) {
        if (const auto color = pbr->find("baseColorFactor")) {
            color->numbers(4);
        }
        pbr->number("metallicFactor", 1.0);
        pbr->number("roughnessFactor", 1.0);
        validateTextureUse(validation, *pbr, "baseColorTexture");
        validateTextureUse(validation, *pbr, "metallicRoughnessTexture");
    }
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
        validateTextureUse(validation, material, key);
    }
    if (const auto emissive = material.find("emissiveFactor")) {
        emissive->numbers(3);
    }
    if (const auto mode = material.find("alphaMode")) {
        requireEnum(*mode, {"OPAQUE", "MASK", "BLEND"});
    }
    material.number("alphaCutoff", 0.5);
    if (const auto doubleSided = material.find("doubleSided")) {
        doubleSided->flag();
    }
    if (const auto strength = material.extension("KHR_materials_emissive_strength")) {
        strength->number("emissiveStrength", 1.0);
    }
    material.extension("KHR_materials_unlit");
}

}  // namespace

void validateImagesAndTextures(Validation& validation) {
    for (const JsonView& image : validation.root.objects("images")) {
        validateImage(validation, image);
    }
    for (const JsonView& sampler : validation.root.objects("samplers")) {
        validateSampler(sampler);
    }
    for (const JsonView& texture : validation.root.objects("textures")) {
        texture.index("sampler", validation.samplerCount, "sampler");
        texture.index("source", validation.imageCount, "image");
        if (const auto webp = texture.extension("EXT_texture_webp")) {
            webp->index("source", validation.imageCount, "image");
        }
    }
}

void validateMaterials(const Validation& validation) {
    for (const JsonView& material : validation.root.objects("materials")) {
        validateMaterial(validation, material);
    }
}

}  // namespace umbrage
