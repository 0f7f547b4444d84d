// SPDX-License-Identifier: Apache-2.0
#include "document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace generator {
namespace {

constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr int kVertices = 34962, kIndices = 34963, kNoTarget = 0;

template <class V>
std::span<const float> flat(const std::vector<V>& values) {
    return {reinterpret_cast<const float*>(values.data()), values.size() * sizeof(V) / sizeof(float)};
}

std::string littleEndian(std::size_t value) {
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xffu);
    return bytes;
}

}  // namespace

// Where the JSON need not be exact, only the same each time, its numbers are short.
Json Document::number(double value) const {
    return digits_ == Digits::Exact ? value : std::round(value * 1e6) / 1e6 + 0.0;
}

Json Document::numbers(const dvec3& v) const {
    return {number(v.x), number(v.y), number(v.z)};
}

Json& Document::list(const char* name) {
    Json& array = json_[name];
    if (array.is_null()) array = Json::array();
    return array;
}

int Document::append(const char* name, Json value) {
    Json& array = list(name);
    array.push_back(std::move(value));
    return static_cast<int>(array.size()) - 1;
}

int Document::accessor(const void* data, std::size_t bytes, int component, const char* type, std::size_t count,
                       int target) {
    Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes}};
    if (target != kNoTarget) view["target"] = target;
    binary_.append(static_cast<const char*>(data), bytes);
    binary_.resize((binary_.size() + 3) / 4 * 4);
    return append("accessors", {{"bufferView", append("bufferViews", std::move(view))},
                                {"componentType", component},
                                {"type", type},
                                {"count", count}});
}

int Document::floats(std::span<const float> values, int width) {
    static constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    return accessor(values.data(), values.size_bytes(), kFloat, kTypes[width], values.size() / width, kVertices);
}

int Document::texture(const std::string& name, const Picture& picture) {
    const std::string png = pngOf(picture);
    const int view = append("bufferViews", {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", png.size()}});
    binary_ += png;
    binary_.resize((binary_.size() + 3) / 4 * 4);
    if (!json_.contains("samplers"))
        append("samplers", {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}});
    const int image = append("images", {{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
    return append("textures", {{"source", image}, {"sampler", 0}});
}

int Document::material(const MaterialSpec& spec) {
    Json pbr{{"metallicFactor", number(spec.metallic)}, {"roughnessFactor", number(spec.roughness)}};
    pbr["baseColorFactor"] = {number(spec.color.x), number(spec.color.y), number(spec.color.z), number(spec.alpha)};
    if (spec.colorTexture != kNone) pbr["baseColorTexture"] = {{"index", spec.colorTexture}};
    if (spec.roughnessTexture != kNone) pbr["metallicRoughnessTexture"] = {{"index", spec.roughnessTexture}};
    Json material{{"name", spec.name}, {"pbrMetallicRoughness", std::move(pbr)}};
    if (spec.normalTexture != kNone) material["normalTexture"] = {{"index", spec.normalTexture}};
    const double strength = std::max({spec.emissive.x, spec.emissive.y, spec.emissive.z, 1.0});
    if (spec.emissive != dvec3(0)) material["emissiveFactor"] = numbers(spec.emissive / strength);
    if (strength > 1) {
        material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = number(strength);
        Json& used = list("extensionsUsed");
        if (std::find(used.begin(), used.end(), "KHR_materials_emissive_strength") == used.end())
            used.push_back("KHR_materials_emissive_strength");
    }
    if (spec.alpha < 1) material["alphaMode"] = "BLEND";
    if (spec.alphaCutoff > 0) material["alphaMode"] = "MASK", material["alphaCutoff"] = number(spec.alphaCutoff);
    if (spec.doubleSided) material["doubleSided"] = true;
    return append("materials", std::move(material));
}

Json Document::primitiveOf(const Part& part) {
    const Geometry& g = part.geometry;
    const auto bounded = [&](const std::vector<glm::vec3>& positions) {
        glm::vec3 low = positions.front(), high = low;
        for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
        const int index = floats(flat(positions), 3);
        json_["accessors"][index]["min"] = {low.x, low.y, low.z};
        json_["accessors"][index]["max"] = {high.x, high.y, high.z};
        return index;
    };
    Json attributes{{"POSITION", bounded(g.positions)}};
    if (!g.normals.empty()) attributes["NORMAL"] = floats(flat(g.normals), 3);
    if (!g.tangents.empty()) attributes["TANGENT"] = floats(flat(g.tangents), 4);
    if (!g.texCoords.empty()) attributes["TEXCOORD_0"] = floats(flat(g.texCoords), 2);
    if (!g.joints.empty()) {
        attributes["JOINTS_0"] =
            accessor(g.joints.data(), g.joints.size() * 4, kByte, "VEC4", g.joints.size(), kVertices);
        attributes["WEIGHTS_0"] = floats(flat(g.weights), 4);
    }
    Json primitive{{"attributes", std::move(attributes)}};
    for (const MorphDelta& target : g.targets)
        primitive["targets"].push_back(
            {{"POSITION", bounded(target.positions)}, {"NORMAL", floats(flat(target.normals), 3)}});
    if (part.indexed && g.positions.size() < 65535) {
        const std::vector<std::uint16_t> indices(g.indices.begin(), g.indices.end());
        primitive["indices"] = accessor(indices.data(), indices.size() * 2, kShort, "SCALAR", indices.size(), kIndices);
    } else if (part.indexed) {
        primitive["indices"] =
            accessor(g.indices.data(), g.indices.size() * 4, kInt, "SCALAR", g.indices.size(), kIndices);
    }
    if (part.mode != Mode::Triangles) primitive["mode"] = static_cast<int>(part.mode);
    if (part.material != kNone) primitive["material"] = part.material;
    return primitive;
}

int Document::mesh(const std::string& name, const std::vector<Part>& parts, Kind kind) {
    Json primitives = Json::array();
    std::vector<glm::vec3> corners;
    for (const Part& part : parts) {
        const Geometry& g = part.geometry;
        if (part.mode == Mode::Triangles && part.indexed)
            for (const std::uint32_t index : g.indices) corners.push_back(g.positions[index]);
        if (part.mode == Mode::Triangles && !part.indexed)
            corners.insert(corners.end(), g.positions.begin(), g.positions.end());
        primitives.push_back(primitiveOf(part));
    }
    meshes_.push_back({kind, topologyOf(corners)});
    const Topology& t = meshes_.back().topology;
    if (kind == Kind::Closed && !t.closed())
        broken_.push_back(
            fmt::format("mesh {} is not closed: {} open and {} non-manifold edges, {} triangles without area, "
                        "{} pieces inside out",
                        name, t.openEdges, t.nonManifoldEdges, t.degenerate, t.inwardPieces));
    Json mesh{{"name", name}, {"primitives", std::move(primitives)}};
    if (const std::size_t targetCount = parts.back().geometry.targets.size(); targetCount > 0)
        mesh["weights"] = std::vector<double>(targetCount, 0.0);
    return append("meshes", std::move(mesh));
}

int Document::recoloured(const std::string& name, int mesh, std::span<const int> materials) {
    Json copy = json_["meshes"][mesh];
    copy["name"] = name;
    for (std::size_t i = 0; i < materials.size(); ++i) copy["primitives"][i]["material"] = materials[i];
    meshes_.push_back(meshes_[mesh]);
    return append("meshes", std::move(copy));
}

int Document::light(const LightSpec& spec) {
    Json light{{"name", spec.name}, {"type", spec.type}, {"color", numbers(spec.color)}, {"intensity", spec.intensity}};
    if (spec.rangeMetres > 0) light["range"] = spec.rangeMetres;
    if (spec.type == "spot")
        light["spot"] = {{"innerConeAngle", number(spec.innerConeDegrees * kPi / 180)},
                         {"outerConeAngle", number(spec.outerConeDegrees * kPi / 180)}};
    Json& lights = json_["extensions"]["KHR_lights_punctual"]["lights"];
    if (lights.is_null()) list("extensionsUsed").push_back("KHR_lights_punctual");
    lights.push_back(std::move(light));
    return static_cast<int>(lights.size()) - 1;
}

int Document::camera(const std::string& name, double yfovDegrees, double znear) {
    return append("cameras",
                  {{"name", name},
                   {"type", "perspective"},
                   {"perspective",
                    {{"yfov", number(yfovDegrees * kPi / 180)}, {"znear", znear}, {"aspectRatio", number(4.0 / 3)}}}});
}

int Document::orthographicCamera(const std::string& name, const dvec2& halfExtents, double znear, double zfar) {
    return append("cameras", {{"name", name},
                              {"type", "orthographic"},
                              {"orthographic",
                               {{"xmag", halfExtents.x}, {"ymag", halfExtents.y}, {"znear", znear}, {"zfar", zfar}}}});
}

int Document::node(const NodeSpec& spec) {
    Json node{{"name", spec.name}};
    if (spec.matrix)
        for (int i = 0; i < 16; ++i) node["matrix"].push_back((*spec.matrix)[i / 4][i % 4]);
    if (spec.translation != dvec3(0)) node["translation"] = numbers(spec.translation);
    if (spec.rotation != dquat(1, 0, 0, 0))
        node["rotation"] = {number(spec.rotation.x), number(spec.rotation.y), number(spec.rotation.z),
                            number(spec.rotation.w)};
    if (spec.scale != dvec3(1)) node["scale"] = numbers(spec.scale);
    if (spec.mesh != kNone) node["mesh"] = spec.mesh;
    if (spec.skin != kNone) node["skin"] = spec.skin;
    if (spec.camera != kNone) node["camera"] = spec.camera;
    if (spec.light != kNone) node["extensions"]["KHR_lights_punctual"]["light"] = spec.light;
    const int index = append("nodes", std::move(node));
    parents_.push_back(spec.parent);
    if (spec.parent != kNone) json_["nodes"][spec.parent]["children"].push_back(index);
    return index;
}

int Document::skin(const std::string& name, const std::vector<int>& joints, const std::vector<dvec3>& positions) {
    std::vector<float> matrices;
    for (const dvec3& p : positions) {
        const float column[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        matrices.insert(matrices.end(), std::begin(column), std::end(column));
        for (const double value : {-p.x, -p.y, -p.z, 1.0}) matrices.push_back(static_cast<float>(value));
    }
    const int inverse = accessor(matrices.data(), matrices.size() * 4, kFloat, "MAT4", positions.size(), kNoTarget);
    return append("skins",
                  {{"name", name}, {"joints", joints}, {"skeleton", joints.front()}, {"inverseBindMatrices", inverse}});
}

int Document::times(const std::vector<double>& values) {
    const auto [place, isNew] = timeAccessors_.try_emplace(values, 0);
    if (isNew) {
        const std::vector<float> seconds(values.begin(), values.end());
        place->second = accessor(seconds.data(), seconds.size() * 4, kFloat, "SCALAR", seconds.size(), kNoTarget);
        json_["accessors"][place->second]["min"] = {seconds.front()};
        json_["accessors"][place->second]["max"] = {seconds.back()};
    }
    return place->second;
}

void Document::channel(int node, const char* path, const std::vector<double>& keyTimes, std::span<const float> values,
                       int width, const char* interpolation) {
    static constexpr const char* kTypes[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    Json& animation = list("animations")[0];
    if (animation.is_null()) animation = {{"name", "Motion"}, {"channels", Json::array()}, {"samplers", Json::array()}};
    const int output =
        accessor(values.data(), values.size_bytes(), kFloat, kTypes[width], values.size() / width, kNoTarget);
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", times(keyTimes)}, {"output", output}, {"interpolation", interpolation}});
}

void Document::translate(int node, const std::vector<double>& keyTimes, const std::vector<dvec3>& values) {
    const std::vector<glm::vec3> keys(values.begin(), values.end());
    channel(node, "translation", keyTimes, flat(keys), 3, "LINEAR");
}

void Document::translateSmoothly(int node, const std::vector<double>& keyTimes, const std::vector<dvec3>& values) {
    std::vector<glm::vec3> keys;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, values.size() - 1);
        const dvec3 slope = (values[after] - values[before]) / (keyTimes[after] - keyTimes[before]);
        for (const dvec3& key : {slope, values[i], slope}) keys.emplace_back(key);
    }
    channel(node, "translation", keyTimes, flat(keys), 3, "CUBICSPLINE");
}

void Document::rotate(int node, const std::vector<double>& keyTimes, std::vector<dquat> values) {
    std::vector<glm::vec4> keys;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0 && glm::dot(values[i], values[i - 1]) < 0) values[i] = -values[i];
        const dquat q = glm::normalize(values[i]);
        keys.emplace_back(q.x, q.y, q.z, q.w);
    }
    channel(node, "rotation", keyTimes, flat(keys), 4, "LINEAR");
}

void Document::weigh(int node, const std::vector<double>& keyTimes, const std::vector<double>& values) {
    const std::vector<float> keys(values.begin(), values.end());
    channel(node, "weights", keyTimes, keys, 1, "LINEAR");
}

Topology Document::casters() const {
    Topology sum;
    for (std::size_t i = 0; i < parents_.size(); ++i)
        if (const int mesh = json_["nodes"][i].value("mesh", kNone);
            mesh != kNone && meshes_[mesh].kind != Kind::Receiver)
            sum += meshes_[mesh].topology;
    return sum;
}

Topology Document::everything() const {
    Topology sum;
    for (std::size_t i = 0; i < parents_.size(); ++i)
        if (const int mesh = json_["nodes"][i].value("mesh", kNone); mesh != kNone) sum += meshes_[mesh].topology;
    return sum;
}

Topology Document::castersUnder(int ancestor) const {
    Topology sum;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
        int node = static_cast<int>(i);
        while (node != kNone && node != ancestor) node = parents_[node];
        const int mesh = json_["nodes"][i].value("mesh", kNone);
        if (node == ancestor && mesh != kNone && meshes_[mesh].kind != Kind::Receiver) sum += meshes_[mesh].topology;
    }
    return sum;
}

void Document::promise(const std::string& what, std::size_t value, std::size_t wanted, double tolerance) {
    const double expected = static_cast<double>(wanted);
    if (std::abs(static_cast<double>(value) - expected) > tolerance * expected)
        broken_.push_back(fmt::format("{}: {} instead of {}", what, value, wanted));
}

std::string Document::glb() const {
    Json json = json_;
    Json roots = Json::array();
    for (std::size_t i = 0; i < parents_.size(); ++i)
        if (parents_[i] == kNone) roots.push_back(i);
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", std::move(roots)}}};
    json["buffers"] = {{{"byteLength", binary_.size()}}};
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return "glTF" + littleEndian(2) + littleEndian(28 + text.size() + binary_.size()) + littleEndian(text.size()) +
           "JSON" + text + littleEndian(binary_.size()) + std::string("BIN\0", 4) + binary_;
}

std::vector<double> evenly(double end, int count) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(end * i / (count - 1));
    return result;
}

dquat lookAt(const dvec3& from, const dvec3& to) {
    const dvec3 back = glm::normalize(from - to);
    const dvec3 up = std::abs(back.y) > 0.999 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
    const dvec3 right = glm::normalize(glm::cross(up, back));
    return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

}  // namespace generator
