// SPDX-License-Identifier: Apache-2.0
// What is there: meshes, materials, nodes, lights, cameras and animations, as plain data. Made by loadGltf() and
// compose(), never changed by rendering; evaluate() (moment.h) says where everything is at a time. No GL, no pixels:
// images stay encoded here.
//
// Units and spaces are glTF's: metres, seconds, radians, right-handed, +Y up, cameras and lights look down -Z.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace umbrage {

using Index = std::int32_t;
inline constexpr Index kNone = -1;

struct Image {
    std::string name;      // for messages: file name or "image 3 of scene.glb"
    std::string mimeType;  // image/png, image/jpeg, image/webp; guessed from the bytes where the file is silent
    std::vector<std::byte> encoded;
};

enum class Wrap : std::uint8_t { Repeat, MirroredRepeat, ClampToEdge };
enum class Filter : std::uint8_t { Nearest, Linear };

struct Sampler {
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    Filter magnify = Filter::Linear, minify = Filter::Linear;
    std::optional<Filter> betweenMipmaps = Filter::Linear;  // none: no mipmaps are used

    bool operator==(const Sampler&) const = default;
};

struct Texture {
    Index image = kNone;
    Sampler sampler;
};

/// A material's use of a texture. `uvFromTexCoord` holds KHR_texture_transform: uv = M * (u, v, 1).
struct TextureUse {
    Index texture = kNone;
    int texCoordSet = 0;
    glm::mat3x2 uvFromTexCoord{1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

struct Material {
    std::string name;
    glm::vec4 baseColor{1.0f};  // linear Rec.709, alpha
    float metallic = 1.0f, roughness = 1.0f;
    float normalScale = 1.0f, occlusionStrength = 1.0f;
    glm::vec3 emissive{0.0f};  // linear, KHR_materials_emissive_strength multiplied in
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;
    TextureUse baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
};

enum class Topology : std::uint8_t { Triangles, Lines, Points };

/// A run of a mesh's indices drawn with one material. Strips, fans and loops are lists by now.
struct Primitive {
    Topology topology = Topology::Triangles;
    std::uint32_t firstIndex = 0, indexCount = 0;    // in Mesh::indices; 3, 2 or 1 per element
    std::uint32_t firstVertex = 0, vertexCount = 0;  // the vertices its indices may name
    Index material = kNone;                          // kNone: glTF's default material
    bool hasNormals = false;                         // false: flat shading from the triangle's plane
    bool hasTangents = false;
    bool hasColors = false;
};

/// One morph target: displacements per vertex, each array either empty or as long as the mesh's positions.
struct MorphTarget {
    std::vector<glm::vec3> positions, normals, tangents;
};

inline constexpr int kTexCoordSetCount = 2;
inline constexpr int kJointsPerVertexSet = 4;

/// All primitives of a glTF mesh in shared arrays. Every attribute array is empty or as long as `positions`.
/// Triangles come first in `indices`, then lines, then points, so that triangle t has indices 3t, 3t+1, 3t+2.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  // finite; -0 stored as +0
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::array<std::vector<glm::vec2>, kTexCoordSetCount> texCoords;
    std::vector<glm::vec4> colors;     // linear
    std::vector<glm::u16vec4> joints;  // influenceSets() entries per vertex, vertex-major
    std::vector<glm::vec4> weights;    // the same, normalised to sum 1 per vertex
    std::vector<MorphTarget> morphTargets;
    std::vector<float> defaultMorphWeights;  // as many as morphTargets
    std::vector<std::uint32_t> indices;      // absolute, into the arrays above
    std::vector<Primitive> primitives;       // sorted as the indices are

    std::size_t influenceSets() const { return positions.empty() ? 0 : joints.size() / positions.size(); }
    std::uint32_t triangleCount() const;
};

struct Skin {
    std::string name;
    std::vector<Index> joints;             // nodes
    std::vector<glm::mat4> jointFromMesh;  // inverse bind matrices, as many as joints
};

enum class LightType : std::uint8_t { Point, Spot, Directional };

/// KHR_lights_punctual: candela for point and spot, lux for directional; colour is linear Rec.709.
struct Light {
    std::string name;
    LightType type = LightType::Point;
    glm::vec3 color{1.0f};
    float intensity = 1.0f;
    float rangeMetres = 0.0f;  // 0: unlimited
    float innerConeAngle = 0.0f, outerConeAngle = 0.7853981634f;
};

/// A glTF camera. The image's aspect ratio wins over the file's (T12).
struct Camera {
    std::string name;
    bool perspective = true;
    double yfov = 0.8;              // perspective: vertical field of view
    double xmag = 1.0, ymag = 1.0;  // orthographic: half extents
    double znear = 0.01;
    double zfar = 0.0;  // 0: infinite (perspective only)
};

struct Node {
    std::string name;
    std::string path;  // unique: "/Courtyard/Lamp", layers' `at` in front; a clash or empty name gets an index
    Index parent = kNone;
    std::vector<Index> children;
    // Either a matrix or TRS; animation replaces TRS parts, so an animated node never has a matrix (glTF 3.6.2).
    std::optional<glm::dmat4> matrix;
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    Index mesh = kNone, skin = kNone, camera = kNone, light = kNone;
    std::vector<float> morphWeights;  // empty: the mesh's defaults
};

enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };

/// A sampled function of time, held at both ends. CubicSpline keeps glTF's triples (in-tangent, value, out-tangent).
/// `values` holds `width` floats per value: key k begins at k*width (Step, Linear) or 3*k*width (CubicSpline).
struct Track {
    std::vector<float> timesSeconds;  // strictly increasing, not empty
    std::vector<float> values;
    int width = 1;
    Interpolation interpolation = Interpolation::Linear;
};

enum class Target : std::uint8_t { Translation, Rotation, Scale, Weights };

struct Channel {
    Index node = kNone;
    Target target = Target::Translation;
    Index track = kNone;
};

struct Animation {
    std::string name;
    std::vector<Track> tracks;
    std::vector<Channel> channels;

    double durationSeconds() const;  // from time 0 to the last key
};

/// Time samples from the sequence file on a light of the composed scene.
enum class LightProperty : std::uint8_t { Intensity, Color, Range, InnerConeAngle, OuterConeAngle };

struct LightTrack {
    Index node = kNone;  // the light's node
    LightProperty property = LightProperty::Intensity;
    Track track;
};

/// A procedure that moves a mesh's vertices in its model space, evaluated on the device.
struct Displacement {
    enum class Kind { Noise, Wave, Twist };

    Index node = kNone;
    Kind kind = Kind::Noise;
    Track amplitude{};  // metres; of a twist radians a metre
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    float frequency = 3.0f, speed = 1.0f;  // a metre, a second
};

/// A scene, or several composed into one. Indices refer to the vectors of the same object.
struct Scene {
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Skin> skins;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<Node> nodes;  // parents come before children
    std::vector<Animation> animations;
    // What the sequence adds:
    std::vector<Animation> drivers;  // tracks of described lights and cameras; always playing
    std::vector<LightTrack> lightTracks;
    std::vector<Displacement> displacements;
    // For people:
    std::vector<std::string> extensionsUsed, extensionsIgnored;
    std::vector<std::string> notes;              // what was odd or ignored, one line each
    std::vector<std::filesystem::path> sources;  // the files it was read from
};

}  // namespace umbrage
