// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_model.h"

#include <fmt/format.h>

#include <charconv>
#include <exception>

#include "error.h"

namespace umbrage {
namespace {

using nlohmann::json;

// A buffer without data still has to be something to tinygltf.
constexpr std::size_t kStandInBytes = 1;

// Copies all members but one, which may hold megabytes of base64.
json withoutMember(const json& object, const char* dropped) {
    json result = json::object();
    for (const auto& [key, value] : object.items()) {
        if (key != dropped) {
            result[key] = value;
        }
    }
    return result;
}

json virtualBuffers(const json& buffers, const GltfFacts& facts) {
    json result = json::array();
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        json buffer = withoutMember(buffers[i], "uri");
        buffer["uri"] = fmt::format("buffer{}", i);
        if (!facts.buffers[i]) {
            buffer["byteLength"] = kStandInBytes;
        }
        result.push_back(std::move(buffer));
    }
    return result;
}

json virtualImages(const json& images, const GltfFacts& facts) {
    json result = json::array();
    for (std::size_t i = 0; i < images.size(); ++i) {
        json image = withoutMember(images[i], "uri");
        if (facts.images[i]) {
            image["uri"] = fmt::format("image{}", i);
        }
        result.push_back(std::move(image));
    }
    return result;
}

// The channels that mean something without extensions: tinygltf reports all others as errors.
void keepCoreChannels(json& animation) {
    json kept = json::array();
    for (json& channel : animation["channels"]) {
        if (channel["target"]["path"] != "pointer" && channel["target"].contains("node")) {
            kept.push_back(std::move(channel));
        }
    }
    animation["channels"] = std::move(kept);
}

// tinygltf requires inverse bind matrices, though the specification does not; -1 is what it keeps for "none".
void completeSkin(json& skin) {
    skin.emplace("inverseBindMatrices", -1);
}

// tinygltf refuses index accessors without a buffer view, though sparse and all-zero ones are legal. They get a view
// that removeStandIns() takes away again.
void completeIndices(json& document) {
    if (!document.contains("meshes")) {
        return;
    }
    json& views =
        document["bufferViews"].is_array() ? document["bufferViews"] : document["bufferViews"] = json::array();
    const std::size_t standIn = views.size();
    for (const json& mesh : document["meshes"]) {
        for (const json& primitive : mesh["primitives"]) {
            if (primitive.contains("indices")) {
                json& accessor = document["accessors"][primitive["indices"].get<std::size_t>()];
                accessor.emplace("bufferView", standIn);
            }
        }
    }
    views.push_back({{"buffer", 0}, {"byteLength", kStandInBytes}});
}

json guardedCopy(const GltfDocument& document, const GltfFacts& facts) {
    json result = json::object();
    for (const auto& [key, value] : document.json.items()) {
        if (key == "buffers") {
            result[key] = virtualBuffers(value, facts);
        } else if (key == "images") {
            result[key] = virtualImages(value, facts);
        } else if (key != "extras") {
            result[key] = value;
        }
    }
    if (result.contains("animations")) {
        for (json& animation : result["animations"]) {
            keepCoreChannels(animation);
        }
    }
    if (result.contains("skins")) {
        for (json& skin : result["skins"]) {
            completeSkin(skin);
        }
    }
    completeIndices(result);
    return result;
}

void removeStandIns(tinygltf::Model& model, std::size_t viewCount) {
    for (tinygltf::Accessor& accessor : model.accessors) {
        if (accessor.bufferView >= static_cast<int>(viewCount)) {
            accessor.bufferView = -1;
        }
    }
    model.bufferViews.resize(viewCount);
}

// "buffer3" or "image0", as virtualBuffers() and virtualImages() named them.
std::optional<std::size_t> virtualIndex(std::string_view path, std::string_view kind) {
    if (!path.starts_with(kind)) {
        return std::nullopt;
    }
    std::size_t index = 0;
    const char* end = path.data() + path.size();
    const auto [rest, error] = std::from_chars(path.data() + kind.size(), end, index);
    return error == std::errc{} && rest == end ? std::optional(index) : std::nullopt;
}

std::vector<unsigned char> readVirtual(const std::string& path, const GltfFacts& facts) {
    if (const auto buffer = virtualIndex(path, "buffer"); buffer && *buffer < facts.buffers.size()) {
        const auto& source = facts.buffers[*buffer];
        return source ? readSource(*source, facts.bufferBytes[*buffer]) : std::vector<unsigned char>(kStandInBytes);
    }
    if (const auto image = virtualIndex(path, "image"); image && *image < facts.images.size() && facts.images[*image]) {
        return readSource(*facts.images[*image], facts.images[*image]->sizeBytes);
    }
    return {};
}

bool isVirtual(const std::string& path, void*) {
    return virtualIndex(path, "buffer") || virtualIndex(path, "image");
}

std::string samePath(const std::string& path, void*) {
    return path;
}

bool readFileCallback(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* facts) {
    try {
        *out = readVirtual(path, *static_cast<const GltfFacts*>(facts));
    } catch (const Error& e) {
        *error = e.what();
    }
    return !out->empty();
}

bool refuseToWrite(std::string* error, const std::string&, const std::vector<unsigned char>&, void*) {
    *error = "nothing is written while loading";
    return false;
}

bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
    image->image.assign(bytes, bytes + size);
    return true;
}

void chargeSources(const GltfDocument& document, const GltfFacts& facts, MemoryBudget& budget) {
    for (std::size_t i = 0; i < facts.buffers.size(); ++i) {
        if (facts.buffers[i]) {
            budget.spend(facts.bufferBytes[i], document.name, fmt::format("/buffers/{}", i));
        }
    }
    for (std::size_t i = 0; i < facts.images.size(); ++i) {
        const json& image = document.json["images"][i];
        const std::uint64_t bytes =
            facts.images[i] ? facts.images[i]->sizeBytes
                            : document.json["bufferViews"][image["bufferView"].get<std::size_t>()]["byteLength"]
                                  .get<std::uint64_t>();
        budget.spend(bytes, document.name, fmt::format("/images/{}", i));
    }
}

}  // namespace

tinygltf::Model buildModel(const GltfDocument& document, const GltfFacts& facts, MemoryBudget& budget) {
    chargeSources(document, facts, budget);
    const std::string text = guardedCopy(document, facts).dump();

    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({isVirtual, samePath, readFileCallback, refuseToWrite, const_cast<GltfFacts*>(&facts)});
    loader.SetImageLoader(keepEncoded, nullptr);
    tinygltf::Model model;
    std::string errors, warnings;
    bool loaded = false;
    try {
        loaded = loader.LoadASCIIFromString(&model, &errors, &warnings, text.data(), static_cast<unsigned>(text.size()),
                                            "", tinygltf::REQUIRE_VERSION);
    } catch (const std::exception& e) {
        errors += e.what();
    }
    if (!loaded || !errors.empty()) {
        failAt(document.name, "", "cannot be read: " + errors + warnings);
    }
    for (std::size_t i = 0; i < model.images.size(); ++i) {
        if (model.images[i].image.empty()) {
            failAt(document.name, fmt::format("/images/{}", i), "cannot be read: " + warnings);
        }
    }
    const json& root = document.json;
    removeStandIns(model, root.contains("bufferViews") ? root["bufferViews"].size() : 0);
    return model;
}

}  // namespace umbrage
