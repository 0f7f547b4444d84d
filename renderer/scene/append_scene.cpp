// SPDX-License-Identifier: Apache-2.0
#include "scene/append_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <unordered_set>

namespace umbrage {
namespace {

template <class T>
Index sizeOf(const std::vector<T>& items) {
    return static_cast<Index>(items.size());
}

void shift(Index& index, Index by) {
    if (index != kNone) index += by;
}

template <class T>
void moveInto(std::vector<T>& items, std::vector<T>& from) {
    items.insert(items.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void mergeSorted(std::vector<std::string>& names, const std::vector<std::string>& more) {
    std::set<std::string> all(names.begin(), names.end());
    all.insert(more.begin(), more.end());
    names.assign(all.begin(), all.end());
}

void shiftMaterials(Scene& layer, Index textures, Index materials) {
    for (Material& material : layer.materials)
        for (TextureUse* use : {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
                                &material.occlusionTexture, &material.emissiveTexture})
            shift(use->texture, textures);
    for (Mesh& mesh : layer.meshes)
        for (Primitive& primitive : mesh.primitives) shift(primitive.material, materials);
}

std::string freePath(const std::unordered_set<std::string>& taken, const std::string& path) {
    std::string candidate = path;
    for (int i = 1; taken.contains(candidate); ++i) candidate = fmt::format("{}_{}", path, i);
    return candidate;
}

// The last part of a path, with its '/'.
std::string ownPart(const std::string& path) {
    return path.substr(path.rfind('/'));
}

}  // namespace

void appendScene(Scene& scene, Scene layer, Index parent) {
    const Index nodes = sizeOf(scene.nodes);
    for (Texture& texture : layer.textures) shift(texture.image, sizeOf(scene.images));
    shiftMaterials(layer, sizeOf(scene.textures), sizeOf(scene.materials));
    for (Skin& skin : layer.skins)
        for (Index& joint : skin.joints) shift(joint, nodes);
    for (Animation& animation : layer.animations)
        for (Channel& channel : animation.channels) shift(channel.node, nodes);

    const std::string parentPath = parent == kNone ? "" : scene.nodes[static_cast<std::size_t>(parent)].path;
    std::unordered_set<std::string> taken;
    for (const Node& node : scene.nodes)
        if (node.parent == parent) taken.insert(node.path);
    for (Node& node : layer.nodes) {
        shift(node.mesh, sizeOf(scene.meshes));
        shift(node.skin, sizeOf(scene.skins));
        shift(node.camera, sizeOf(scene.cameras));
        shift(node.light, sizeOf(scene.lights));
        for (Index& child : node.children) shift(child, nodes);
        if (node.parent == kNone) {
            node.parent = parent;
            node.path = freePath(taken, parentPath + ownPart(node.path));
            taken.insert(node.path);
            if (parent != kNone) scene.nodes[static_cast<std::size_t>(parent)].children.push_back(sizeOf(scene.nodes));
        } else {
            node.parent += nodes;
            node.path = scene.nodes[static_cast<std::size_t>(node.parent)].path + ownPart(node.path);
        }
        scene.nodes.push_back(std::move(node));
    }
    moveInto(scene.images, layer.images);
    moveInto(scene.textures, layer.textures);
    moveInto(scene.materials, layer.materials);
    moveInto(scene.meshes, layer.meshes);
    moveInto(scene.skins, layer.skins);
    moveInto(scene.lights, layer.lights);
    moveInto(scene.cameras, layer.cameras);
    moveInto(scene.animations, layer.animations);
    moveInto(scene.notes, layer.notes);
    moveInto(scene.sources, layer.sources);
    mergeSorted(scene.extensionsUsed, layer.extensionsUsed);
    mergeSorted(scene.extensionsIgnored, layer.extensionsIgnored);
}

}  // namespace umbrage
