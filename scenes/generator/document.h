// SPDX-License-Identifier: Apache-2.0
// A glTF document being built: meshes, nodes, lights, cameras, skins and one animation, written as one .glb. It
// measures every mesh it is given, so that a scene can promise figures and the program can keep it to them.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry.h"
#include "png.h"
#include "topology.h"

namespace generator {

using Json = nlohmann::json;  // sorts its keys: the same bytes each time

inline constexpr int kNone = -1;

/// Closed meshes are checked; receivers (ground, room) are left out of the counts that scenes promise.
enum class Kind { Closed, Open, Receiver };

/// How a primitive's vertices make triangles; the numbers are glTF's.
enum class Mode { Points = 0, Lines = 1, Triangles = 4, Strip = 5, Fan = 6 };

struct Part {
    Geometry geometry;  // without normals: none are written, and viewers shade flat
    int material = kNone;
    Mode mode = Mode::Triangles;
    bool indexed = true;  // false: the positions in order, and no indices are written
};

struct NodeSpec {
    std::string name;
    int parent = kNone;
    dvec3 translation{0};
    dquat rotation{1, 0, 0, 0};
    dvec3 scale{1};
    int mesh = kNone, skin = kNone, camera = kNone, light = kNone;
    std::optional<dmat4> matrix{};  // in place of translation, rotation and scale
};

struct LightSpec {
    std::string name;
    std::string type = "point";  // spot, directional
    dvec3 color{1};
    double intensity = 1;    // candela; lux for directional
    double rangeMetres = 0;  // 0: unlimited
    double innerConeDegrees = 0, outerConeDegrees = 45;
};

struct MaterialSpec {
    std::string name;
    dvec3 color{0.8};
    double roughness = 0.8, metallic = 0;
    dvec3 emissive{0};
    double alpha = 1;        // below 1: BLEND
    double alphaCutoff = 0;  // above 0: MASK
    bool doubleSided = false;
    int colorTexture = kNone, normalTexture = kNone, roughnessTexture = kNone;
};

/// Digits of the numbers in the JSON part: six decimals, or as many as give the same number back.
enum class Digits { Brief, Exact };

class Document {
public:
    explicit Document(Digits digits = Digits::Brief) : digits_(digits) {}

    int texture(const std::string& name, const Picture& picture);
    int material(const MaterialSpec& spec);
    int mesh(const std::string& name, const std::vector<Part>& parts, Kind kind = Kind::Closed);
    /// The same geometry as `mesh` under another name, part by part with other materials: shares all its bytes.
    int recoloured(const std::string& name, int mesh, std::span<const int> materials);
    int light(const LightSpec& spec);
    int camera(const std::string& name, double yfovDegrees, double znear);
    int orthographicCamera(const std::string& name, const dvec2& halfExtents, double znear, double zfar);
    int node(const NodeSpec& spec);
    /// Joints in their bind pose stand unrotated at `positions` in the space of the mesh.
    int skin(const std::string& name, const std::vector<int>& joints, const std::vector<dvec3>& positions);

    /// Keys of the one animation; rotations may be any quaternions, successive keys are made to take the short way.
    void translate(int node, const std::vector<double>& times, const std::vector<dvec3>& values);
    void rotate(int node, const std::vector<double>& times, std::vector<dquat> values);
    void weigh(int node, const std::vector<double>& times, const std::vector<double>& values);
    /// The same through a spline whose tangents are finite differences (glTF's CUBICSPLINE).
    void translateSmoothly(int node, const std::vector<double>& times, const std::vector<dvec3>& values);

    /// All casters as placed by nodes.
    Topology casters() const;
    Topology everything() const;
    const Topology& topologyOfMesh(int mesh) const { return meshes_[mesh].topology; }
    /// Of casters under (and at) a node.
    Topology castersUnder(int node) const;

    /// `tolerance` is a share of `wanted`. A broken promise makes the program fail.
    void promise(const std::string& what, std::size_t value, std::size_t wanted, double tolerance = 0);
    const std::vector<std::string>& broken() const { return broken_; }

    std::string glb() const;

private:
    struct MeshRecord {
        Kind kind = Kind::Closed;
        Topology topology;
    };

    int accessor(const void* data, std::size_t bytes, int component, const char* type, std::size_t count, int target);
    int floats(std::span<const float> values, int width);
    int times(const std::vector<double>& values);
    void channel(int node, const char* path, const std::vector<double>& times, std::span<const float> values, int width,
                 const char* interpolation);
    Json number(double value) const;
    Json numbers(const dvec3& value) const;
    Json primitiveOf(const Part& part);
    Json& list(const char* name);
    int append(const char* list, Json value);

    Digits digits_;
    Json json_ = {{"asset", {{"version", "2.0"}, {"generator", "umbrage generate_scenes"}}}};
    std::string binary_;
    std::vector<MeshRecord> meshes_;
    std::vector<int> parents_;
    std::map<std::vector<double>, int> timeAccessors_;
    std::vector<std::string> broken_;
};

/// `count` times from 0 to `end`, seconds.
std::vector<double> evenly(double end, int count);

/// The rotation of a camera or light at `from` that looks at `to`, +Y up.
dquat lookAt(const dvec3& from, const dvec3& to);

}  // namespace generator
