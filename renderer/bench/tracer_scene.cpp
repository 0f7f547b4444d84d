// SPDX-License-Identifier: Apache-2.0
#include "bench/tracer_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "error.h"

namespace umbrage {
namespace {

/// As a normalised integer of the G-buffer gives it back.
float rounded(float value, float steps) {
    return std::round(std::clamp(value, 0.0f, 1.0f) * steps) / steps;
}

TracerMaterial constantsOf(const Material& material) {
    TracerMaterial made;
    made.metallic = rounded(material.metallic, 255.0f);
    made.roughness = rounded(material.roughness, 255.0f);
    made.lit = material.unlit ? 0.0f : 1.0f;
    for (int k = 0; k < 3; ++k) {
        const float emissive = material.unlit ? material.baseColor[k] : material.emissive[k];
        made.baseColor[k] = rounded(material.baseColor[k], 65535.0f);
        made.emissive[k] = glm::unpackHalf1x16(glm::packHalf1x16(std::min(emissive, 65504.0f)));
    }
    return made;
}

std::uint32_t traitsOf(const Material& material) {
    if (material.alphaMode == AlphaMode::Mask && material.baseColor.a < material.alphaCutoff) return 0u;
    return kTracerFrontSeen | (material.doubleSided ? kTracerBackSeen : 0u);
}

/// The normals of what deforms, as the vertex stage gets them.
std::vector<float> readNormals(const Geometry& geometry) {
    const gpu::Buffer noDraws("no draws", sizeof(std::uint32_t));
    const gpu::VertexArray vertices = geometry.makeVertexArray(noDraws);
    vertices.bind();
    GLint buffer = 0, bytes = 0;
    glGetVertexAttribiv(1, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    glGetNamedBufferParameteriv(GLuint(buffer), GL_BUFFER_SIZE, &bytes);
    std::vector<float> normals(std::size_t(bytes) / sizeof(float));
    glGetNamedBufferSubData(GLuint(buffer), 0, bytes, normals.data());
    return normals;
}

/// Takes model-space normals into the world, by the matrices that the renderer uses.
glm::mat3 normalMatrix(const gpu::InstanceData& instance, const Eye& eye) {
    glm::mat3 rows;
    for (int r = 0; r < 3; ++r) rows[r] = glm::vec3(instance.normalFromModel[r]);
    return glm::mat3(eye.worldFromView) * glm::transpose(rows);
}

}  // namespace

struct TracerScene::Hierarchies {
    struct One {
        RTCScene scene = nullptr;
        RTCGeometry triangles = nullptr;
    };

    RTCDevice device = rtcNewDevice(nullptr);
    One built, fitted;

    Hierarchies() {
        if (!device) throw Error(ErrorKind::Device, "", "Embree cannot be started", "the tracer needs libembree3");
    }
    ~Hierarchies() {
        release(built);
        release(fitted);
        rtcReleaseDevice(device);
    }

    static void release(One& one) {
        if (one.triangles) rtcReleaseGeometry(one.triangles);
        if (one.scene) rtcReleaseScene(one.scene);
        one = {};
    }

    /// @param refits  when committed again it is fitted to where the vertices are then
    One make(const std::vector<float>& positions, const std::vector<std::int32_t>& vertices, bool refits) const {
        One one{rtcNewScene(device), rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)};
        rtcSetSceneFlags(one.scene,
                         RTCSceneFlags(RTC_SCENE_FLAG_ROBUST |
                                       (refits ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION)));
        // Only scenes of low quality look at what their geometries want.
        rtcSetSceneBuildQuality(one.scene, refits ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
        rtcSetGeometryBuildQuality(one.triangles, refits ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_MEDIUM);
        rtcSetSharedGeometryBuffer(one.triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                                   3 * sizeof(float), positions.size() / 3 - 1);
        rtcSetSharedGeometryBuffer(one.triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, vertices.data(), 0,
                                   3 * sizeof(std::int32_t), vertices.size() / 3);
        rtcCommitGeometry(one.triangles);
        rtcAttachGeometry(one.scene, one.triangles);
        return one;
    }

    double commit(const One& one) const {
        const auto start = std::chrono::steady_clock::now();
        rtcCommitScene(one.scene);
        const double milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        if (rtcGetDeviceError(device) == RTC_ERROR_NONE) return milliseconds;
        throw Error(ErrorKind::Device, "", "Embree cannot build its hierarchy", "the scene may need too much memory");
    }
};

TracerScene::TracerScene(const Scene& scene) : scene_(scene), hierarchies_(std::make_unique<Hierarchies>()) {
    for (const Material& material : scene.materials) materials_.push_back(constantsOf(material));
    materials_.push_back(constantsOf({}));
}

TracerScene::~TracerScene() = default;

/// What stays the same from moment to moment.
void TracerScene::number(const Moment& moment, const Geometry& geometry) {
    const auto middle = boundsOf(scene_, moment);
    origin_ = 0.5 * (middle[0] + middle[1]);
    std::size_t vertexCount = 0;
    for (std::uint32_t i = 0; i < moment.instances.size(); ++i) {
        const Instance& instance = moment.instances[i];
        const Mesh& mesh = scene_.meshes[std::size_t(instance.mesh)];
        const glm::dmat4& placing = instance.skinned() ? instance.worldFromBindPose[0] : instance.worldFromModel;
        const bool mirrored = glm::determinant(glm::dmat3(placing)) < 0.0;
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.topology != Topology::Triangles) continue;
            const bool isDefault = primitive.material == kNone;
            const Material& material = isDefault ? Material{} : scene_.materials[std::size_t(primitive.material)];
            if (material.alphaMode == AlphaMode::Blend) continue;
            const std::uint32_t traits =
                traitsOf(material) | (primitive.hasNormals ? 0u : kTracerFlat) |
                std::uint32_t(isDefault ? materials_.size() - 1 : std::size_t(primitive.material));
            for (std::uint32_t k = 0; k < primitive.indexCount; k += 3) {
                const std::uint32_t first = primitive.firstIndex + k;
                for (const std::uint32_t corner : {0u, mirrored ? 2u : 1u, mirrored ? 1u : 2u}) {
                    vertices_.push_back(std::int32_t(vertexCount + mesh.indices[first + corner]));
                }
                traits_.push_back(traits);
                placedTriangles_.push_back(geometry.instances()[i].placedTriangleBase + first / 3);
            }
        }
        firstVertex_.push_back(vertexCount);
        vertexCount += mesh.positions.size();
    }
    positions_.resize(3 * (vertexCount + 1));  // Embree reads sixteen bytes at a time
    normals_.resize(3 * vertexCount);
    placings_.resize(moment.instances.size(), glm::dmat4(0.0));
}

bool TracerScene::place(const Moment& moment, const Geometry& geometry, const Eye& eye) {
    if (firstVertex_.empty()) number(moment, geometry);
    std::vector<float> deformed = geometry.deforms() ? geometry.readPositions() : std::vector<float>();
    const bool deforms = deformed != deformed_;
    const std::vector<float> deformedNormals = deforms ? readNormals(geometry) : std::vector<float>();
    deformed_ = std::move(deformed);
    bool moved = false;
    for (std::uint32_t i = 0; i < moment.instances.size(); ++i) {
        const glm::dmat4& placing = geometry.worldFromModel(i);
        const bool own = geometry.hasOwnVertices(i);
        if (placing == placings_[i] && !(own && deforms)) continue;
        placings_[i] = placing;
        moved = true;
        const Mesh& mesh = scene_.meshes[std::size_t(moment.instances[i].mesh)];
        const glm::dmat4 hereFromModel = glm::translate(glm::dmat4(1.0), -origin_) * placing;
        const glm::mat3 normalsHere = normalMatrix(geometry.instances()[i], eye);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const std::size_t device = 3 * (geometry.instances()[i].vertexBase + v);
            const auto at = [&](const std::vector<float>& values) {
                return glm::vec3(values[device], values[device + 1], values[device + 2]);
            };
            const glm::dvec3 position =
                own ? glm::dvec3(at(deformed_)) : glm::dvec3(mesh.positions[v]) - geometry.originOf(i);
            const glm::vec3 normal = own                    ? at(deformedNormals)
                                     : mesh.normals.empty() ? glm::vec3(0.0f)
                                                            : mesh.normals[v];
            const glm::vec3 p(hereFromModel * glm::dvec4(position, 1.0)), n = normalsHere * normal;
            const std::size_t here = 3 * (firstVertex_[i] + v);
            for (int k = 0; k < 3; ++k) {
                positions_[here + std::size_t(k)] = p[k];
                normals_[here + std::size_t(k)] = n[k];
            }
        }
    }
    return moved;
}

double TracerScene::build() {
    Hierarchies& h = *hierarchies_;
    h.release(h.built);
    h.built = h.make(positions_, vertices_, false);
    return h.commit(h.built);
}

double TracerScene::refit() {
    Hierarchies& h = *hierarchies_;
    if (!h.fitted.scene) {
        h.fitted = h.make(positions_, vertices_, true);
        h.commit(h.fitted);
    }
    rtcUpdateGeometryBuffer(h.fitted.triangles, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(h.fitted.triangles);
    return h.commit(h.fitted);
}

void TracerScene::describe(TracerFrame& frame) const {
    frame.scene = hierarchies_->built.scene;
    frame.vertices = vertices_.data();
    frame.normals = normals_.data();
    frame.traits = traits_.data();
    frame.materials = materials_.data();
}

}  // namespace umbrage
