// SPDX-License-Identifier: Apache-2.0
// Meshes: the attributes of all primitives into shared arrays.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/gltf_convert.h"
#include "scene/gltf_convert_indices.h"

namespace umbrage {
namespace {

using Attributes = std::map<std::string, int>;

class MeshConverter {
public:
    MeshConverter(GltfConversion& conversion, std::size_t index)
        : conversion_(conversion),
          source_(conversion.model.meshes[index]),
          pointer_(fmt::format("/meshes/{}", index)) {}

    Mesh convert() {
        mesh_.name = source_.name;
        mesh_.morphTargets.resize(source_.primitives.empty() ? 0 : source_.primitives.front().targets.size());
        for (const auto& primitive : source_.primitives) {
            while (primitive.attributes.contains(fmt::format("JOINTS_{}", influenceSets_))) {
                ++influenceSets_;
            }
        }
        for (std::size_t i = 0; i < source_.primitives.size(); ++i) {
            if (source_.primitives[i].attributes.contains("POSITION")) {
                convertPrimitive(i);
            }
        }
        fillArrays();
        finishIndices();
        mesh_.defaultMorphWeights.assign(mesh_.morphTargets.size(), 0.0f);
        std::transform(source_.weights.begin(), source_.weights.end(), mesh_.defaultMorphWeights.begin(),
                       [](double weight) { return static_cast<float>(weight); });
        return std::move(mesh_);
    }

    GltfConversion::JointUse jointUse() const { return jointUse_; }

private:
    // Primitives that name the same accessors share their vertices, as the file does.
    using VertexKey = std::pair<Attributes, std::vector<Attributes>>;

    void convertPrimitive(std::size_t index) {
        const tinygltf::Primitive& source = source_.primitives[index];
        const std::string pointer = fmt::format("{}/primitives/{}", pointer_, index);
        const auto [range, isNew] = ranges_.try_emplace({source.attributes, source.targets}, mesh_.positions.size());
        if (isNew) {
            appendVertices(source, pointer);
        }
        Primitive primitive;
        primitive.firstVertex = static_cast<std::uint32_t>(range->second);
        primitive.vertexCount = static_cast<std::uint32_t>(conversion_.reader.count(source.attributes.at("POSITION")));
        primitive.material = source.material;
        primitive.hasNormals = source.attributes.contains("NORMAL");
        // Without normals the tangents have no meaning (glTF 2.0, 3.7.2.1).
        primitive.hasTangents = primitive.hasNormals && source.attributes.contains("TANGENT");
        primitive.hasColors = source.attributes.contains("COLOR_0");
        ElementList elements = listElements(conversion_, source, primitive.vertexCount, pointer);
        primitive.topology = elements.topology;
        primitive.indexCount = static_cast<std::uint32_t>(elements.indices.size());
        for (std::uint32_t& vertex : elements.indices) {
            vertex += primitive.firstVertex;
        }
        mesh_.primitives.push_back(primitive);
        indices_.push_back(std::move(elements.indices));
    }

    void appendVertices(const tinygltf::Primitive& source, const std::string& pointer) {
        const std::string attributes = pointer + "/attributes/";
        begin_ = mesh_.positions.size();
        const auto read = [&](const char* name) -> std::vector<float> {
            const auto found = source.attributes.find(name);
            return found == source.attributes.end() ? std::vector<float>{}
                                                    : conversion_.reader.floats(found->second, attributes + name);
        };
        constexpr std::size_t kMostVertices = 0x7FFFFFFF;
        const std::size_t count = conversion_.reader.count(source.attributes.at("POSITION"));
        if (count > kMostVertices - begin_) {
            failAt(conversion_.file, pointer, fmt::format("the mesh has more than {} vertices", kMostVertices));
        }
        append(mesh_.positions, read("POSITION"), attributes);
        for (std::size_t i = begin_; i < mesh_.positions.size(); ++i) {
            mesh_.positions[i] +=
                0.0f;  // -0 + 0 is +0: equal positions shall have equal bits, because they are welded by bits
        }
        append(mesh_.normals, read("NORMAL"), attributes);
        append(mesh_.tangents, read("TANGENT"), attributes);
        append(mesh_.texCoords[0], read("TEXCOORD_0"), attributes);
        append(mesh_.texCoords[1], read("TEXCOORD_1"), attributes);
        appendColors(source, read("COLOR_0"), attributes);
        appendInfluences(source, attributes);
        for (std::size_t t = 0; t < source.targets.size(); ++t) {
            appendTarget(source.targets[t], mesh_.morphTargets[t], fmt::format("{}/targets/{}/", pointer, t));
        }
        noteIgnored(source, attributes);
    }

    void appendTarget(const Attributes& source, MorphTarget& target, const std::string& pointer) {
        const auto read = [&](const char* name) -> std::vector<float> {
            const auto found = source.find(name);
            return found == source.end() ? std::vector<float>{}
                                         : conversion_.reader.floats(found->second, pointer + name);
        };
        append(target.positions, read("POSITION"), pointer);
        append(target.normals, read("NORMAL"), pointer);
        append(target.tangents, read("TANGENT"), pointer);
        for (const auto& [name, accessor] : source) {
            if (name.starts_with("TEXCOORD_") || name.starts_with("COLOR_")) {
                conversion_.notes.add(pointer + name,
                                      "morphing of texture coordinates and colours is not supported and ignored");
            }
        }
    }

    // An array that an earlier primitive lacked begins with default values there.
    template <int N>
    void append(std::vector<glm::vec<N, float>>& array, const std::vector<float>& values, const std::string& pointer,
                float otherwise = 0.0f) {
        if (values.empty()) {
            return;
        }
        grow(array, begin_, glm::vec<N, float>(otherwise), pointer);
        array.reserve(array.size() + values.size() / N);
        for (std::size_t i = 0; i < values.size(); i += N) {
            glm::vec<N, float> value;
            for (int c = 0; c < N; ++c) {
                value[c] = values[i + static_cast<std::size_t>(c)];
            }
            array.push_back(value);
        }
    }

    template <class T>
    void grow(std::vector<T>& array, std::size_t size, const T& value, const std::string& pointer) {
        conversion_.budget.spend((size - array.size()) * sizeof(T), conversion_.file, pointer);
        array.resize(size, value);
    }

    void appendColors(const tinygltf::Primitive& source, std::vector<float> values, const std::string& pointer) {
        if (values.empty()) {
            return;
        }
        const std::size_t count = conversion_.reader.count(source.attributes.at("COLOR_0"));
        if (values.size() == count * 3) {
            std::vector<float> withAlpha;
            withAlpha.reserve(count * 4);
            for (std::size_t i = 0; i < values.size(); i += 3) {
                withAlpha.insert(withAlpha.end(), {values[i], values[i + 1], values[i + 2], 1.0f});
            }
            values = std::move(withAlpha);
        }
        append(mesh_.colors, values, pointer, 1.0f);
    }

    void appendInfluences(const tinygltf::Primitive& source, const std::string& pointer) {
        if (influenceSets_ == 0) {
            return;
        }
        const std::size_t count = mesh_.positions.size() - begin_;
        grow(mesh_.joints, mesh_.positions.size() * influenceSets_, glm::u16vec4(0), pointer);
        grow(mesh_.weights, mesh_.positions.size() * influenceSets_, glm::vec4(0.0f), pointer);
        const std::size_t first = begin_ * influenceSets_;
        for (std::size_t set = 0; set < influenceSets_; ++set) {
            const std::string jointsName = fmt::format("JOINTS_{}", set), weightsName = fmt::format("WEIGHTS_{}", set);
            if (!source.attributes.contains(jointsName)) {
                break;
            }
            const auto joints = conversion_.reader.integers(source.attributes.at(jointsName), pointer + jointsName);
            const auto weights = conversion_.reader.floats(source.attributes.at(weightsName), pointer + weightsName);
            const std::uint32_t largest = *std::max_element(joints.begin(), joints.end());
            if (jointUse_.pointer.empty() || largest > jointUse_.largest) {
                jointUse_ = {largest, pointer + jointsName};
            }
            for (std::size_t i = 0; i < count * 4; ++i) {
                if (weights[i] < 0.0f) {
                    failAt(conversion_.file, pointer + weightsName,
                           fmt::format("vertex {} has the negative weight {}", i / 4, weights[i]));
                }
                const std::size_t entry = first + (i / 4) * influenceSets_ + set;
                mesh_.joints[entry][static_cast<int>(i % 4)] = static_cast<std::uint16_t>(joints[i]);
                mesh_.weights[entry][static_cast<int>(i % 4)] = weights[i];
            }
        }
        normalizeWeights(first, pointer, source.attributes.contains("WEIGHTS_0"));
    }

    // To sum 1 per vertex. A vertex without any weight follows its first joint wholly.
    void normalizeWeights(std::size_t first, const std::string& pointer, bool areGiven) {
        for (std::size_t i = first; i < mesh_.weights.size(); i += influenceSets_) {
            double sum = 0.0;
            for (std::size_t set = 0; set < influenceSets_; ++set) {
                const glm::dvec4 weights(mesh_.weights[i + set]);
                sum += weights.x + weights.y + weights.z + weights.w;
            }
            if (sum == 0.0) {
                mesh_.weights[i].x = 1.0f;
                if (areGiven) {
                    conversion_.notes.add(pointer + "WEIGHTS_0",
                                          "a vertex without weights was bound to its first joint");
                }
                continue;
            }
            constexpr double kRounding = 0.01;  // 8-bit weights are off by half a 255th each
            if (std::abs(sum - 1.0) > kRounding) {
                conversion_.notes.add(pointer + "WEIGHTS_0",
                                      "the weights of a vertex did not add up to 1 and were scaled");
            }
            for (std::size_t set = 0; set < influenceSets_; ++set) {
                mesh_.weights[i + set] = glm::vec4(glm::dvec4(mesh_.weights[i + set]) / sum);
            }
        }
    }

    void noteIgnored(const tinygltf::Primitive& source, const std::string& pointer) {
        for (const auto& [name, accessor] : source.attributes) {
            const bool isSet = name.starts_with("TEXCOORD_") || name.starts_with("COLOR_");
            if (isSet && name != "TEXCOORD_0" && name != "TEXCOORD_1" && name != "COLOR_0") {
                conversion_.notes.add(pointer + name, fmt::format("{} is not supported and ignored", name));
            }
        }
    }

    // Arrays that a later primitive lacked end with default values there.
    void fillArrays() {
        const std::size_t count = mesh_.positions.size();
        const auto fill = [&](auto& array, auto value) {
            if (!array.empty()) {
                grow(array, count, value, pointer_);
            }
        };
        fill(mesh_.normals, glm::vec3(0.0f));
        fill(mesh_.tangents, glm::vec4(0.0f));
        fill(mesh_.texCoords[0], glm::vec2(0.0f));
        fill(mesh_.texCoords[1], glm::vec2(0.0f));
        fill(mesh_.colors, glm::vec4(1.0f));
        for (MorphTarget& target : mesh_.morphTargets) {
            fill(target.positions, glm::vec3(0.0f));
            fill(target.normals, glm::vec3(0.0f));
            fill(target.tangents, glm::vec3(0.0f));
        }
    }

    // Triangles first, then lines, then points.
    void finishIndices() {
        std::vector<std::size_t> order(mesh_.primitives.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return mesh_.primitives[a].topology < mesh_.primitives[b].topology;
        });
        std::vector<Primitive> sorted;
        for (const std::size_t i : order) {
            Primitive primitive = mesh_.primitives[i];
            constexpr std::size_t kMostIndices = 0xFFFFFFFF;
            if (indices_[i].size() > kMostIndices - mesh_.indices.size()) {
                failAt(conversion_.file, pointer_, fmt::format("the mesh has more than {} indices", kMostIndices));
            }
            primitive.firstIndex = static_cast<std::uint32_t>(mesh_.indices.size());
            mesh_.indices.insert(mesh_.indices.end(), indices_[i].begin(), indices_[i].end());
            indices_[i] = {};
            sorted.push_back(primitive);
        }
        mesh_.primitives = std::move(sorted);
    }

    GltfConversion& conversion_;
    const tinygltf::Mesh& source_;
    std::string pointer_;
    Mesh mesh_;
    std::map<VertexKey, std::size_t> ranges_;          // first vertex of each
    std::vector<std::vector<std::uint32_t>> indices_;  // of each primitive
    std::size_t begin_ = 0;                            // first vertex of the primitive in work
    std::size_t influenceSets_ = 0;
    GltfConversion::JointUse jointUse_;
};

}  // namespace

void convertMeshes(GltfConversion& conversion) {
    for (std::size_t i = 0; i < conversion.model.meshes.size(); ++i) {
        MeshConverter converter(conversion, i);
        conversion.scene.meshes.push_back(converter.convert());
        conversion.meshJoints.push_back(converter.jointUse());
    }
}

}  // namespace umbrage
