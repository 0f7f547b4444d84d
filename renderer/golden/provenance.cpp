// SPDX-License-Identifier: Apache-2.0
#include "golden/provenance.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "error.h"
#include "image/image.h"
#include "job/yaml_tree.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int kFormat = 1;

std::string textOf(const Manifest& manifest) {
    const Provenance& from = manifest.from;
    Json images = Json::object();
    for (const auto& [name, image] : manifest.images) images[name] = {{"aov", image.aov}, {"frame", image.frame}};
    const Json device = {{"renderer", from.renderer}, {"version", from.version}, {"processor", from.processor}};
    return Json{{"manifest", kFormat}, {"tool", from.tool}, {"device", device}, {"job", from.job}, {"images", images}}
               .dump(1) +
           "\n";
}

std::optional<std::string> contentsIfThere(const fs::path& file) {
    return fs::exists(file) ? std::optional(contentsOf(file)) : std::nullopt;
}

}  // namespace

std::optional<Manifest> readManifest(const fs::path& folder) {
    const fs::path file = folder / kManifestName;
    const std::optional<std::string> text = contentsIfThere(file);
    if (!text) return std::nullopt;
    try {
        const Json json = Json::parse(*text);
        if (json.at("manifest") != kFormat) {
            throw Error(ErrorKind::Input, file.string(), "is a manifest of another version",
                        "accept or render again with this umbrage");
        }
        Manifest manifest;
        const Json& device = json.at("device");
        manifest.from = {device.at("renderer"), device.at("version"), device.at("processor"), json.at("tool"),
                         json.at("job")};
        for (const auto& [name, image] : json.at("images").items()) {
            manifest.images[name] = {image.at("aov"), image.at("frame")};
        }
        return manifest;
    } catch (const Json::exception& error) {
        throw Error(ErrorKind::Input, file.string(), fmt::format("is no manifest: {}", error.what()),
                    "remove it to compare without knowing what made the pictures");
    }
}

void writeManifest(const fs::path& folder, const Manifest& manifest) {
    const std::string text = textOf(manifest);
    if (contentsIfThere(folder / kManifestName) != text) writeWhole(folder / kManifestName, text);
}

void updateManifest(const fs::path& folder, Manifest manifest) {
    try {
        const std::optional<Manifest> before = readManifest(folder);
        if (before && before->from.sameDevice(manifest.from) && before->from.job == manifest.from.job &&
            before->from.tool == manifest.from.tool) {
            manifest.images.insert(before->images.begin(), before->images.end());
        }
    } catch (const Error&) {
        // What is no manifest is replaced.
    }
    writeManifest(folder, manifest);
}

std::string processorFlags() {
    std::string flags;
#if defined(__x86_64__)
    const auto add = [&](bool has, const char* name) {
        if (has) flags += flags.empty() ? name : fmt::format(" {}", name);
    };
    add(__builtin_cpu_supports("sse4.1"), "sse4.1");
    add(__builtin_cpu_supports("avx"), "avx");
    add(__builtin_cpu_supports("avx2"), "avx2");
    add(__builtin_cpu_supports("fma"), "fma");
    add(__builtin_cpu_supports("avx512f"), "avx512f");
#endif
    return flags;
}

std::string fingerprintOf(const std::string& shape, std::span<const fs::path> sources, const std::string& color) {
    std::string all = shape + "\n" + color;
    for (const fs::path& source : sources) {
        const std::string bytes = contentsOf(source);
        all += fmt::format("\n{} {:016x}", source.filename().string(), XXH3_64bits(bytes.data(), bytes.size()));
    }
    return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

std::string deviceOf(const Provenance& from) {
    return fmt::format("{}, {}{}{}", from.renderer, from.version, from.processor.empty() ? "" : ", ", from.processor);
}

}  // namespace umbrage
