// SPDX-License-Identifier: Apache-2.0
// scene: the layers.
#include "job/job_types.h"

namespace umbrage {
namespace {

Type<Triple> layerScale() {
    const Type<Triple> uniform = converted<Triple>(
        number(),
        [](double value, const YamlNode&) {
            return Triple{value, value, value};
        },
        [](const Triple& value) { return value[0]; });
    const Type<Triple> perAxis = triple("a list [x, y, z]");
    Type<Triple> type = either(uniform, perAxis, [](const YamlNode& node) { return node.isScalar(); });
    type.read = [uniform, perAxis](const YamlNode& node, const std::string& name) {
        const Triple scale = node.isScalar() ? uniform.read(node, name) : perAxis.read(node, name);
        for (const double value : scale)
            if (value == 0) refuse(node, name + " must not be 0");
        return scale;
    };
    return type;
}

Type<Located<std::string>> nodePath(const std::string& what) {
    return converted<Located<std::string>>(located(text(what)), [](Located<std::string> path, const YamlNode& node) {
        if (!path.value.starts_with('/'))
            refuse(node, describe(node) + " is not the path of a node",
                   "paths begin with '/', such as /Courtyard/Lamp");
        while (path.value.ends_with('/')) path.value.pop_back();
        return path;
    });
}

Type<GltfLayer> gltfLayer() {
    const auto file =
        converted<Located<std::filesystem::path>>(text("a path"), [](const std::string& path, const YamlNode& node) {
            return Located<std::filesystem::path>{path, node.place};
        });
    const auto transform = [](auto pointer) {
        return [=](GltfLayer & l) -> auto& {
            return l.transform.*pointer;
        };
    };
    return mapping<GltfLayer>(
        "glTF layer", "A .gltf or .glb file put into the scene.",
        {
            field<GltfLayer>("gltf", file, &GltfLayer::file, "The file, from this file's folder").required(),
            field<GltfLayer>("scene", located(nameOrIndex()), &GltfLayer::scene, "Which of the file's scenes")
                .unset("the file's own"),
            field<GltfLayer>("at", nodePath("a node path"), &GltfLayer::at,
                             "The node that becomes the parent of the file's roots: one of an earlier layer, or new")
                .unset("none"),
            field<GltfLayer>("translate", point(), transform(&LayerTransform::translate), "Moves the layer")
                .in("metres"),
            field<GltfLayer>("rotate", triple("angles [x, y, z]"), transform(&LayerTransform::rotateDegrees),
                             "Turns it about x, then y, then z, before it is moved")
                .in("degrees"),
            field<GltfLayer>("scale", layerScale(), transform(&LayerTransform::scale),
                             "Scales it, before it is turned"),
        });
}

Type<Overs> overLayer() {
    const auto node = mapping<LightOpinion>(
        "over",
        "Opinions on the nodes whose path a glob matches: `*` and `?` stay within one part of a path, `**` does "
        "not. They are laid over all glTF layers, later ones over earlier ones.",
        {field<LightOpinion>(
             "light", lightOpinion(), [](LightOpinion & l) -> auto& { return l; }, "Changes to the light on the node")
             .required()});
    struct OverOnly {
        Overs overs;
    };
    const auto globs =
        converted<Overs>(dictionary(node, "a mapping {glob: opinions, ...}"), [](const auto& entries, const YamlNode&) {
            Overs made;
            for (const auto& [glob, light] : entries) made.push_back({glob, light});
            return made;
        });
    return converted<Overs>(
        mapping<OverOnly>(
            "over layer", "Changes to nodes of the layers.",
            {field<OverOnly>("over", globs, &OverOnly::overs, "By glob over node paths, see over").required()}),
        [](const OverOnly& layer, const YamlNode&) { return layer.overs; });
}

Type<Layer> layer() {
    const auto asLayer = [](const auto& value, const YamlNode&) { return Layer(value); };
    const Type<Layer> others =
        either(converted<Layer>(generatedLayer(), asLayer), converted<Layer>(overLayer(), asLayer),
               [](const YamlNode& node) { return node.find("generated") != nullptr; });
    Type<Layer> type = either(converted<Layer>(gltfLayer(), asLayer), others,
                              [](const YamlNode& node) { return !node.find("generated") && !node.find("over"); });
    type.read = [read = type.read](const YamlNode& node, const std::string& name) {
        const std::vector<std::string> known{"gltf", "generated", "over"};
        const auto has = [&](const std::string& key) { return node.find(key) != nullptr; };
        if (node.isMapping() && std::none_of(known.begin(), known.end(), has)) {
            const std::string written = node.keys.empty() ? "" : node.keys.front().scalar;
            refuse(node, "a layer needs the key \"gltf\", \"generated\" or \"over\"", hintForName(written, known));
        }
        return read(node, name);
    };
    return type;
}

}  // namespace

Type<std::vector<Layer>> layers() {
    return listOf(layer(), "a list of layers");
}

}  // namespace umbrage
