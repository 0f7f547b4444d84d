// SPDX-License-Identifier: Apache-2.0
// Cameras, lights, the nodes of one scene, and skins.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <unordered_map>

#include "scene/gltf_convert.h"

namespace umbrage {
namespace {

Camera convertCamera(const tinygltf::Camera& camera) {
    Camera result;
    result.name = camera.name;
    result.perspective = camera.type == "perspective";
    if (result.perspective) {
        result.yfov = camera.perspective.yfov;
        result.znear = camera.perspective.znear;
        result.zfar = camera.perspective.zfar;
    } else {
        result.xmag = std::abs(camera.orthographic.xmag);
        result.ymag = std::abs(camera.orthographic.ymag);
        result.znear = camera.orthographic.znear;
        result.zfar = camera.orthographic.zfar;
    }
    return result;
}

Light convertLight(const tinygltf::Light& light) {
    Light result;
    result.name = light.name;
    result.type = light.type == "spot"          ? LightType::Spot
                  : light.type == "directional" ? LightType::Directional
                                                : LightType::Point;
    if (!light.color.empty()) {
        result.color = glm::dvec3(light.color[0], light.color[1], light.color[2]);
    }
    result.intensity = static_cast<float>(light.intensity);
    // Exporters write the largest float for "unlimited"; squared it would overflow.
    constexpr double kUnlimited = 1e18;
    result.rangeMetres = light.range < kUnlimited ? static_cast<float>(light.range) : 0.0f;
    result.innerConeAngle = static_cast<float>(light.spot.innerConeAngle);
    result.outerConeAngle = static_cast<float>(light.spot.outerConeAngle);
    return result;
}

class NodeConverter {
public:
    explicit NodeConverter(GltfConversion& conversion)
        : conversion_(conversion), model_(conversion.model), parents_(model_.nodes.size(), kNone) {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            for (const int child : model_.nodes[i].children) {
                parents_[static_cast<std::size_t>(child)] = static_cast<Index>(i);
            }
        }
    }

    void convert(const std::string& sceneName) {
        const std::vector<Index> roots = rootsOf(sceneName);
        keep(roots);
        const std::vector<Index> extraRoots = keepOutsideJoints();
        conversion_.sceneNodes.assign(model_.nodes.size(), kNone);
        place(roots);
        place(extraRoots);
    }

private:
    enum class Keep : std::uint8_t { No, TransformOnly, Yes };

    std::vector<Index> rootsOf(const std::string& sceneName) const {
        std::vector<Index> roots;
        if (model_.scenes.empty() && sceneName.empty()) {
            for (std::size_t i = 0; i < parents_.size(); ++i) {
                if (parents_[i] == kNone) {
                    roots.push_back(static_cast<Index>(i));
                }
            }
            return roots;
        }
        const auto& nodes = model_.scenes[chooseScene(sceneName)].nodes;
        return {nodes.begin(), nodes.end()};
    }

    // By name first, because a name may look like a number.
    std::size_t chooseScene(const std::string& wanted) const {
        if (wanted.empty()) {
            return static_cast<std::size_t>(std::max(model_.defaultScene, 0));
        }
        std::string names;
        for (std::size_t i = 0; i < model_.scenes.size(); ++i) {
            if (model_.scenes[i].name == wanted) {
                return i;
            }
            names += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, inQuotes(model_.scenes[i].name));
        }
        std::size_t index = 0;
        const auto [rest, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
        if (error == std::errc{} && rest == wanted.data() + wanted.size() && index < model_.scenes.size()) {
            return index;
        }
        failAt(conversion_.file, "/scenes", fmt::format("there is no scene {}", inQuotes(wanted)),
               names.empty() ? "the file has no scenes" : "there are: " + names);
    }

    void keep(const std::vector<Index>& roots) {
        kept_.assign(model_.nodes.size(), Keep::No);
        std::vector<Index> open(roots);
        while (!open.empty()) {
            const auto node = static_cast<std::size_t>(open.back());
            open.pop_back();
            kept_[node] = Keep::Yes;
            open.insert(open.end(), model_.nodes[node].children.begin(), model_.nodes[node].children.end());
        }
    }

    // A skin's joints need not be in the scene, but they move its meshes all the same. Returns their roots.
    std::vector<Index> keepOutsideJoints() {
        std::vector<Index> roots;
        std::vector<bool> seen(model_.skins.size(), false);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            const tinygltf::Node& node = model_.nodes[i];
            if (kept_[i] != Keep::Yes || node.mesh < 0 || node.skin < 0 || seen[static_cast<std::size_t>(node.skin)]) {
                continue;
            }
            seen[static_cast<std::size_t>(node.skin)] = true;
            for (Index joint : model_.skins[static_cast<std::size_t>(node.skin)].joints) {
                for (; joint != kNone && kept_[static_cast<std::size_t>(joint)] == Keep::No;
                     joint = parents_[static_cast<std::size_t>(joint)]) {
                    kept_[static_cast<std::size_t>(joint)] = Keep::TransformOnly;
                    if (parents_[static_cast<std::size_t>(joint)] == kNone) {
                        roots.push_back(joint);
                    }
                }
            }
        }
        return roots;
    }

    // Parents before children, children in the file's order.
    void place(const std::vector<Index>& roots) {
        std::vector<std::pair<Index, Index>> open;  // glTF node, our parent
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
            open.emplace_back(*root, kNone);
        }
        std::vector<Node>& nodes = conversion_.scene.nodes;
        while (!open.empty()) {
            const auto [source, parent] = open.back();
            open.pop_back();
            if (kept_[static_cast<std::size_t>(source)] == Keep::No) {
                continue;
            }
            const auto index = static_cast<Index>(nodes.size());
            conversion_.sceneNodes[static_cast<std::size_t>(source)] = index;
            nodes.push_back(convertNode(source, parent));
            childNames_.emplace_back();
            if (parent != kNone) {
                nodes[static_cast<std::size_t>(parent)].children.push_back(index);
            }
            const auto& children = model_.nodes[static_cast<std::size_t>(source)].children;
            for (auto child = children.rbegin(); child != children.rend(); ++child) {
                open.emplace_back(*child, index);
            }
        }
    }

    Node convertNode(Index index, Index parent) {
        const tinygltf::Node& source = model_.nodes[static_cast<std::size_t>(index)];
        const std::string pointer = fmt::format("/nodes/{}", index);
        Node node;
        node.name = source.name;
        node.parent = parent;
        node.path = (parent == kNone ? "" : conversion_.scene.nodes[static_cast<std::size_t>(parent)].path) + "/" +
                    uniqueName(source.name, index, parent);
        // Paths of a deep chain grow with the square of its length.
        conversion_.budget.spend(node.path.size(), conversion_.file, pointer);
        convertTransform(source, node, pointer);
        if (kept_[static_cast<std::size_t>(index)] != Keep::Yes) {
            return node;
        }
        node.mesh = source.mesh;
        node.skin = source.mesh < 0 ? kNone : source.skin;  // still the file's number: convertSkins() translates it
        node.camera = source.camera;
        if (const auto light = source.extensions.find("KHR_lights_punctual"); light != source.extensions.end()) {
            node.light = light->second.Get("light").GetNumberAsInt();
        }
        node.morphWeights.assign(source.weights.begin(), source.weights.end());
        return node;
    }

    void convertTransform(const tinygltf::Node& source, Node& node, const std::string& pointer) {
        if (!source.matrix.empty()) {
            glm::dmat4 matrix = glm::make_mat4(source.matrix.data());
            matrix[0].w = matrix[1].w = matrix[2].w = 0.0;  // the validator allows for rounding here
            matrix[3].w = 1.0;
            node.matrix = matrix;
        }
        if (!source.translation.empty()) {
            node.translation = glm::make_vec3(source.translation.data());
        }
        if (!source.scale.empty()) {
            node.scale = glm::make_vec3(source.scale.data());
        }
        if (!source.rotation.empty()) {
            const auto& q = source.rotation;
            const glm::dquat rotation(q[3], q[0], q[1], q[2]);
            const double length = glm::length(rotation);
            constexpr double kRounding = 1e-3;
            if (std::abs(length - 1.0) > kRounding) {
                conversion_.notes.add(pointer + "/rotation", "a rotation was not a unit quaternion and was normalised");
            }
            node.rotation = rotation / length;
        }
    }

    // Unique among its siblings. A '/' would look like another level of the path.
    std::string uniqueName(const std::string& name, Index index, Index parent) {
        std::string base = name.empty() ? fmt::format("node{}", index) : name;
        std::replace(base.begin(), base.end(), '/', '_');
        Names& taken = parent == kNone ? rootNames_ : childNames_[static_cast<std::size_t>(parent)];
        // Each name keeps the last suffix tried with it, so that a thousand equal names take a thousand steps.
        auto [lastSuffix, isFree] = taken.try_emplace(base, 0);
        std::string candidate = base;
        while (!isFree) {
            candidate = fmt::format("{}_{}", base, ++lastSuffix->second);
            isFree = !taken.contains(candidate);
        }
        taken.try_emplace(candidate, 0);
        return candidate;
    }

    using Names = std::unordered_map<std::string, std::size_t>;

    GltfConversion& conversion_;
    const tinygltf::Model& model_;
    std::vector<Index> parents_;
    std::vector<Keep> kept_;
    Names rootNames_;
    std::vector<Names> childNames_;
};

}  // namespace

void convertCamerasAndLights(GltfConversion& conversion) {
    std::transform(conversion.model.cameras.begin(), conversion.model.cameras.end(),
                   std::back_inserter(conversion.scene.cameras), convertCamera);
    std::transform(conversion.model.lights.begin(), conversion.model.lights.end(),
                   std::back_inserter(conversion.scene.lights), convertLight);
}

void convertNodes(GltfConversion& conversion, const std::string& sceneName) {
    NodeConverter(conversion).convert(sceneName);
}

}  // namespace umbrage
