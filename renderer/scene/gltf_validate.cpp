// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "scene/gltf_validate_parts.h"
#include "scene/load_gltf.h"

namespace umbrage {
namespace {

constexpr std::string_view kSupported[] = {
    "EXT_texture_webp",       "KHR_lights_punctual",   "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_materials_variants", "KHR_mesh_quantization", "KHR_texture_transform",
};

struct Version {
    int major = 0, minor = 0;
};

Version parseVersion(const JsonView& version) {
    const std::string& text = version.text();
    Version result;
    const char* end = text.data() + text.size();
    const auto [dot, majorError] = std::from_chars(text.data(), end, result.major);
    if (majorError != std::errc{} || dot == end || *dot != '.') {
        version.fail(fmt::format("{} is not a version like \"2.0\"", inQuotes(text)));
    }
    const auto [rest, minorError] = std::from_chars(dot + 1, end, result.minor);
    if (minorError != std::errc{} || rest != end) {
        version.fail(fmt::format("{} is not a version like \"2.0\"", inQuotes(text)));
    }
    return result;
}

void validateAsset(const JsonView& root) {
    const JsonView asset = root.at("asset");
    const JsonView version = asset.at("version");
    if (parseVersion(version).major != 2) {
        version.fail(fmt::format("glTF {} is not supported, only 2.x is", inQuotes(version.text())));
    }
    if (const auto least = asset.find("minVersion")) {
        const auto [major, minor] = parseVersion(*least);
        if (major != 2 || minor > 0) {
            least->fail(fmt::format("needs glTF {}, but only 2.0 is supported", inQuotes(least->text())));
        }
    }
}

std::vector<std::string> strings(const JsonView& root, const std::string& key) {
    std::vector<std::string> result;
    if (const auto array = root.find(key)) {
        for (const JsonView& element : array->items()) {
            result.push_back(element.text());
        }
    }
    return result;
}

bool isSupported(const std::string& extension) {
    return std::find(std::begin(kSupported), std::end(kSupported), extension) != std::end(kSupported);
}

void validateExtensions(Validation& validation) {
    std::vector<std::string> missing;
    for (const std::string& extension : strings(validation.root, "extensionsRequired")) {
        if (!isSupported(extension)) {
            missing.push_back(inQuotes(extension));
        }
    }
    if (!missing.empty()) {
        validation.root.at("extensionsRequired")
            .fail(fmt::format("the file needs {} {}, which this program does not support",
                              missing.size() == 1 ? "the extension" : "the extensions", fmt::join(missing, ", ")),
                  "export the scene without " + std::string(missing.size() == 1 ? "it" : "them"));
    }
    GltfFacts& facts = validation.facts;
    facts.extensionsUsed = strings(validation.root, "extensionsUsed");
    for (const std::string& extension : facts.extensionsUsed) {
        const bool isNew = validation.extensionsUsed.insert(extension).second;
        if (isNew && !isSupported(extension)) {
            facts.extensionsIgnored.push_back(extension);
            validation.notes.add(
                "/extensionsUsed",
                fmt::format("the optional extension {} is not supported and ignored", inQuotes(extension)));
        }
    }
}

void countEverything(Validation& validation) {
    const JsonView& root = validation.root;
    validation.sceneCount = root.objects("scenes").size();
    validation.nodeCount = root.objects("nodes").size();
    validation.skinCount = root.objects("skins").size();
    validation.cameraCount = root.objects("cameras").size();
    validation.imageCount = root.objects("images").size();
    validation.samplerCount = root.objects("samplers").size();
    validation.textureCount = root.objects("textures").size();
    validation.materialCount = root.objects("materials").size();
    if (const auto lights = root.extension("KHR_lights_punctual")) {
        validation.lightCount = lights->objects("lights").size();
    }
    validation.bufferViews = root.objects("bufferViews");
}

}  // namespace

std::span<const std::string_view> supportedExtensions() {
    return kSupported;
}

void requireEnum(const JsonView& value, std::initializer_list<std::uint64_t> allowed) {
    const std::uint64_t number = value.integer(0, ~std::uint64_t{0});
    if (std::find(allowed.begin(), allowed.end(), number) == allowed.end()) {
        value.fail(fmt::format("{} is none of {}", number, fmt::join(allowed, ", ")));
    }
}

void requireEnum(const JsonView& value, std::initializer_list<std::string_view> allowed) {
    const std::string& text = value.text();
    if (std::find(allowed.begin(), allowed.end(), text) == allowed.end()) {
        value.fail(fmt::format("{} is none of {}", inQuotes(text), fmt::join(allowed, ", ")));
    }
}

GltfFacts validateGltf(const GltfDocument& document, GltfFiles& files, GltfNotes& notes) {
    GltfFacts facts;
    Validation validation{.root = document.root(),
                          .document = document,
                          .files = files,
                          .notes = notes,
                          .facts = facts,
                          .extensionsUsed = {},
                          .bufferViews = {},
                          .accessors = {},
                          .meshTargetCounts = {},
                          .meshHasJoints = {}};
    validateAsset(validation.root);
    validateExtensions(validation);
    countEverything(validation);
    validateBuffers(validation);
    validateBufferViews(validation);
    validateAccessors(validation);
    validateImagesAndTextures(validation);
    validateMaterials(validation);
    validateMeshes(validation);
    validateCamerasAndLights(validation);
    validateNodesAndScenes(validation);
    validateSkins(validation);
    validateAnimations(validation);
    return facts;
}

}  // namespace umbrage
