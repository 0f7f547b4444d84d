// SPDX-License-Identifier: Apache-2.0
#include "scene/load_gltf.h"

#include "scene/gltf_convert.h"
#include "scene/gltf_document.h"
#include "scene/gltf_model.h"
#include "scene/gltf_validate.h"

namespace umbrage {
namespace {

Scene load(std::vector<std::byte> bytes, std::string_view name, GltfFiles& files, const GltfOptions& options) {
    GltfNotes notes;
    const GltfDocument document = parseGltfDocument(std::move(bytes), name);
    const GltfFacts facts = validateGltf(document, files, notes);

    MemoryBudget budget(document.sizeBytes + files.fileBytes());
    tinygltf::Model model = buildModel(document, facts, budget);
    const AccessorReader reader(model, document.name, budget);
    Scene scene;
    GltfConversion conversion{document.name, model, reader, budget, notes, scene};
    convertTextures(conversion);
    convertMaterials(conversion);
    convertMeshes(conversion);
    convertCamerasAndLights(conversion);
    convertNodes(conversion, options.scene);
    convertSkins(conversion);
    convertAnimations(conversion);

    scene.extensionsUsed = facts.extensionsUsed;
    scene.extensionsIgnored = facts.extensionsIgnored;
    scene.notes = notes.lines(document.name);
    return scene;
}

}  // namespace

Scene loadGltf(const std::filesystem::path& file, const GltfOptions& options) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    auto bytes = readRegularFile(file);
    GltfFiles files(folder, options.allowExternalFiles);
    Scene scene = load(std::move(bytes), file.string(), files, options);
    scene.sources.push_back(file);
    scene.sources.insert(scene.sources.end(), files.files().begin(), files.files().end());
    return scene;
}

Scene loadGltf(std::span<const std::byte> bytes, std::string_view name, const GltfOptions& options) {
    GltfFiles files({}, options.allowExternalFiles);
    return load({bytes.begin(), bytes.end()}, name, files, options);
}

}  // namespace umbrage
