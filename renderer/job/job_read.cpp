// SPDX-License-Identifier: Apache-2.0
// From text to a Job: tree, overrides, table, then what needs more than one value (paths and output names).
#include <map>

#include "error.h"
#include "job/job_fields.h"
#include "job/output_path.h"
#include "job/overrides.h"

namespace umbrage {
namespace {

constexpr const char* kName = "the sequence";

std::filesystem::path resolved(const std::filesystem::path& folder, const std::filesystem::path& path) {
    return (folder / path).lexically_normal();  // an absolute path replaces the folder
}

/// A tree as text, whatever its layout and order were.
Json plain(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::Mapping: {
            std::map<std::string, Json> sorted;
            for (std::size_t i = 0; i < node.keys.size(); ++i) sorted[node.keys[i].scalar] = plain(node.items[i]);
            return sorted;
        }
        case YamlNode::Kind::Sequence: {
            Json list = Json::array();
            for (const YamlNode& item : node.items) list.push_back(plain(item));
            return list;
        }
        default:
            if (const std::optional<double> number = numberOf(node)) return *number;
            return node.scalar;
    }
}

/// What shapes the pictures of the frames: not which frames, what else is written, and where.
std::string shapeOf(const YamlNode& root) {
    Json tree = plain(root);
    for (const char* key : {"statistics", "golden"}) tree.erase(key);
    if (tree.contains("time")) tree["time"].erase("frames");
    if (tree.contains("output")) {
        for (const char* key : {"path", "layers", "aovs"}) tree["output"].erase(key);
    }
    if (tree.contains("scene")) {  // what is in the files counts, not where they are
        for (Json& layer : tree["scene"]) {
            if (layer.contains("gltf"))
                layer["gltf"] = std::filesystem::path(layer["gltf"].get<std::string>()).filename();
        }
    }
    return tree.dump();
}

// Where a key of output: stands, or what is nearest to it.
std::string outputPlace(const YamlNode& root, const char* key) {
    const YamlNode* output = root.find("output");
    const YamlNode* path = output ? output->find(key) : nullptr;
    return (path ? path : output ? output : &root)->place.text();
}

Job jobFromTree(YamlNode root, const std::filesystem::path& file, const std::filesystem::path& folder,
                const JobOverrides& overrides) {
    if (root.kind == YamlNode::Kind::Null)
        refuse(root, "the file is empty", "a sequence begins with umbrage: 1 and scene:");
    for (const JobOverrides::Option& option : overrides.options) applyOverride(root, option.assignment, option.name);
    for (const std::string& assignment : overrides.set) applyOverride(root, assignment);
    applyBudgets(root, overrides.budgets);
    if (root.isMapping() && !root.find("umbrage"))
        refuse(root, "the version key is missing", "add the line umbrage: 1");

    Job job = sequenceType().read(root, kName);
    job.file = file;
    job.shape = shapeOf(root);
    job.time.wholeAnimation = overrides.wholeAnimation;
    for (GltfLayer& layer : job.gltfLayers) layer.file.value = resolved(folder, layer.file.value);
    checkOutputPath(job, outputPlace(root, "path"));
    checkLayersPath(job, outputPlace(root, "layers"));
    job.output.path = outputTemplateIn(folder, job.output.path);
    if (!job.output.layers.empty()) job.output.layers = outputTemplateIn(folder, job.output.layers);
    for (std::string* path : {&job.statistics.path, &job.statistics.page}) {
        if (!path->empty()) *path = resolved(folder, *path).string();
    }
    for (std::string* path : {&job.color.config, &job.golden.path}) {
        if (!path->empty()) *path = resolved(folder, *path).string();
    }
    return job;
}

YamlNode mappingNode(std::vector<std::pair<std::string, YamlNode>> entries, const Place& place) {
    YamlNode node{.kind = YamlNode::Kind::Mapping, .place = place};
    for (auto& [key, value] : entries) {
        node.keys.push_back({.kind = YamlNode::Kind::Scalar, .plain = true, .scalar = key, .place = place});
        node.items.push_back(std::move(value));
    }
    return node;
}

}  // namespace

Job readJob(const std::filesystem::path& sequenceFile, const JobOverrides& overrides) {
    return parseJob(contentsOf(sequenceFile), sequenceFile.string(), sequenceFile.parent_path(), overrides);
}

Job parseJob(const std::string& yaml, const std::string& name, const std::filesystem::path& folder,
             const JobOverrides& overrides) {
    if (overrides.wholeAnimation)
        throw Error(ErrorKind::Usage, "--frames all", "is for scenes without YAML; a sequence names its frames",
                    "leave --frames out for all of them");
    return jobFromTree(parseYaml(yaml, name), name, folder, overrides);
}

Job jobForScene(const std::filesystem::path& sceneFile, const JobOverrides& overrides) {
    const Place place{sceneFile.string(), 0, 0};
    const auto scalar = [&](const std::string& text, bool plain) {
        return YamlNode{.kind = YamlNode::Kind::Scalar, .plain = plain, .scalar = text, .place = place};
    };
    YamlNode layers{.kind = YamlNode::Kind::Sequence, .place = place};
    layers.items.push_back(mappingNode({{"gltf", scalar(sceneFile.string(), false)}}, place));
    YamlNode output = mappingNode({{"path", scalar("out/{scene}/{aov}.{frame:04}.{ext}", false)}}, place);
    YamlNode background{.kind = YamlNode::Kind::Sequence, .place = place};
    background.items.assign(3, scalar("0.05", true));  // dark things stand out against it, and so do bright ones
    return jobFromTree(mappingNode({{"umbrage", scalar("1", true)},
                                    {"scene", std::move(layers)},
                                    {"image", mappingNode({{"background", std::move(background)}}, place)},
                                    {"output", std::move(output)}},
                                   place),
                       sceneFile, {}, overrides);
}

}  // namespace umbrage
