// SPDX-License-Identifier: Apache-2.0
#include "shadow/geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "error.h"

namespace umbrage {
namespace {

constexpr std::uint64_t kMostPlaced = 500'000'000;  // triangles or edges: three vertices each must count in 31 bits

std::uint32_t roundUpToChunks(std::uint32_t count) {
    return (count + CHUNK_SIZE - 1) / CHUNK_SIZE;
}

float fromOrdered(std::uint32_t u) {
    return std::bit_cast<float>(u & 0x80000000u ? u & 0x7fffffffu : ~u);
}

gpu::Edge deviceEdge(const MeshEdge& edge, bool even) {
    gpu::Edge e{edge.a, edge.b, edge.left, edge.right};
    if (edge.leftReversed) e.left |= EDGE_REVERSED;
    if (even) e.left |= EDGE_EVEN;
    if (edge.right != MeshEdge::kNoTriangle && edge.rightReversed) e.right |= EDGE_REVERSED;
    return e;
}

/// Nodes whose scale, or an ancestor's, is animated: it may become 0, and a transform that cannot be inverted has no
/// model space to decide facing in.
std::vector<bool> nodesWhoseScaleMoves(const Scene& scene) {
    std::vector<bool> moves(scene.nodes.size());
    for (const std::vector<Animation>* animations : {&scene.animations, &scene.drivers}) {
        for (const Animation& animation : *animations) {
            for (const Channel& channel : animation.channels) {
                const Track& track = animation.tracks[std::size_t(channel.track)];
                if (channel.target == Target::Scale && !isConstant(track)) moves[std::size_t(channel.node)] = true;
            }
        }
    }
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Index parent = scene.nodes[i].parent;  // comes before its children
        if (parent != kNone && moves[std::size_t(parent)]) moves[i] = true;
    }
    return moves;
}

/// What is subtracted from a mesh's positions, exactly, where it lies farther from its own origin than it is large: the
/// floats that facing is decided in are relative to the mesh, whatever space it was modelled in (T7).
glm::vec3 originBetween(const glm::vec3& low, const glm::vec3& high) {
    glm::vec3 origin(0.0f);
    for (int k = 0; k < 3; ++k) {
        const float centre = 0.5f * low[k] + 0.5f * high[k], half = 0.5f * high[k] - 0.5f * low[k];
        if (std::abs(centre) > 2.0f * half) origin[k] = centre;  // p - centre is exact where p is within a factor of 2
    }
    return origin;
}

/// Rows of the upper 3x4, rounded once.
void storeRows(const glm::dmat4& m, gpu::vec4 (&rows)[3]) {
    for (int r = 0; r < 3; ++r) rows[r] = gpu::vec4(m[0][r], m[1][r], m[2][r], m[3][r]);
}

/// The matrix that takes normals along, pointing to the same side of the surface also when `m` mirrors; scaled to keep
/// floats in range. Made of cofactors, so that a flattening transform has one too.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
    glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    if (glm::determinant(m) < 0.0) cofactors = -cofactors;
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, glm::length(cofactors[c]));
    return largest > 0.0 ? cofactors / largest : cofactors;
}

}  // namespace

Geometry::Geometry(const Scene& scene, const Moment& first, bool worldFloats)
    : worldFloats_(worldFloats), deformProgram_("deform.comp") {
    topologies_.reserve(scene.meshes.size());
    displaced_.resize(scene.meshes.size());
    for (const Instance& placed : first.instances) {
        if (placed.displacement != kNone) displaced_[std::size_t(placed.mesh)] = true;
    }
    for (const Mesh& mesh : scene.meshes) {
        const bool displaced = displaced_[topologies_.size()];
        MeshTopology topology =
            buildTopology(mesh, scene.materials, displaced ? normalsOf(mesh) : std::vector<glm::vec3>());
        MeshRange range;
        range.firstVertex = vertexCount_;
        range.firstTriangle = std::uint32_t(triangleFlags_.size());
        range.triangleCount = mesh.triangleCount();
        range.firstEdge = std::uint32_t(edges_.size());
        range.edgeCount = std::uint32_t(topology.edges.size());
        range.vertexCount = std::uint32_t(mesh.positions.size());
        vertexCount_ += range.vertexCount;
        range.boundsMin = glm::vec3(std::numeric_limits<float>::max());
        range.boundsMax = -range.boundsMin;
        for (const glm::vec3& p : mesh.positions) {
            range.boundsMin = glm::min(range.boundsMin, p);
            range.boundsMax = glm::max(range.boundsMax, p);
        }
        if (!displaced && !mesh.positions.empty()) range.origin = originBetween(range.boundsMin, range.boundsMax);
        range.boundsMin -= range.origin;
        range.boundsMax -= range.origin;
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.topology != Topology::Triangles) continue;
            const Material material = primitive.material == kNone ? Material{} : scene.materials[primitive.material];
            std::uint32_t flags = 0;
            if (!material.doubleSided) flags |= TRIANGLE_SINGLE_SIDED;
            if (material.alphaMode == AlphaMode::Mask) flags |= TRIANGLE_HOLED;
            for (std::uint32_t t = primitive.firstIndex / 3; t < (primitive.firstIndex + primitive.indexCount) / 3;
                 ++t) {
                triangleFlags_.push_back(flags | (topology.casts[t] ? TRIANGLE_CASTS : 0u) |
                                         (topology.even[t] ? TRIANGLE_EVEN : 0u));
            }
        }
        indices_.insert(indices_.end(), mesh.indices.begin(), mesh.indices.begin() + 3 * range.triangleCount);
        for (std::uint32_t t = 0; t < range.triangleCount; ++t) {
            // Without area it has no effect at all; snapped to the rasteriser's grid it might cover something.
            std::uint32_t* v = &indices_[3 * (std::size_t(range.firstTriangle) + t)];
            if (!topology.hasArea[t]) v[1] = v[2] = v[0];
        }
        for (const MeshEdge& edge : topology.edges) edges_.push_back(deviceEdge(edge, topology.even[edge.left]));
        ranges_.push_back(range);
        topologies_.push_back(std::move(topology));
    }

    for (std::size_t m = 0; m < ranges_.size(); ++m) {
        const std::vector<std::uint32_t>& all = scene.meshes[m].indices;
        const std::uint32_t triangleIndices = 3 * ranges_[m].triangleCount;
        // Modulo 2^32: a primitive's firstIndex counts from the mesh's first triangle.
        ranges_[m].firstOtherIndex = std::uint32_t(indices_.size()) - triangleIndices;
        indices_.insert(indices_.end(), all.begin() + triangleIndices, all.end());
    }

    const std::vector<bool> scaleMoves = nodesWhoseScaleMoves(scene);
    for (const Instance& placed : first.instances) {
        const auto i = std::uint32_t(instances_.size());
        const MeshRange& range = ranges_[placed.mesh];
        const Mesh& mesh = scene.meshes[placed.mesh];
        gpu::InstanceData instance{};
        instance.vertexBase = range.firstVertex;
        instance.triangleBase = range.firstTriangle;
        instance.triangleCount = range.triangleCount;
        instance.placedTriangleBase = triangleChunkCount_ * CHUNK_SIZE;
        instance.edgeBase = range.firstEdge;
        instance.edgeCount = range.edgeCount;
        instance.placedEdgeBase = edgeChunkCount_ * CHUNK_SIZE;
        if ((std::uint64_t(triangleChunkCount_) + roundUpToChunks(range.triangleCount)) * CHUNK_SIZE > kMostPlaced ||
            (std::uint64_t(edgeChunkCount_) + roundUpToChunks(range.edgeCount)) * CHUNK_SIZE > kMostPlaced) {
            throw Error(ErrorKind::Input, "", "the scene places more triangles than can be numbered",
                        "fewer instances of its largest meshes");
        }
        triangleChunkCount_ += roundUpToChunks(range.triangleCount);
        edgeChunkCount_ += roundUpToChunks(range.edgeCount);
        triangleChunks_.resize(triangleChunkCount_, i);
        edgeChunks_.resize(edgeChunkCount_, i);
        const bool baked = worldFloats || placed.skinned() || scaleMoves[std::size_t(placed.node)] ||
                           !invertible(placed.worldFromModel);
        if (baked || !mesh.morphTargets.empty() || placed.displacement != kNone) {
            Deforming own;
            own.instance = i;
            own.firstVertex = instance.vertexBase = vertexCount_;
            own.vertexCount = std::uint32_t(mesh.positions.size());
            own.jointCount = baked ? std::max<std::uint32_t>(1, std::uint32_t(placed.worldFromBindPose.size())) : 0;
            own.influenceSets = placed.skinned() ? std::uint32_t(mesh.influenceSets()) : 0;
            own.morphCount = std::uint32_t(mesh.morphTargets.size());
            own.relativeToOrigin = baked;
            vertexCount_ += own.vertexCount;
            deforming_.push_back(own);
        }
        instances_.push_back(instance);
        instanceMesh_.push_back(std::uint32_t(placed.mesh));
    }
    worldFromModel_.resize(instances_.size());
    uploadVertices(scene);
}

bool Geometry::invertible(const glm::dmat4& m) const {
    const glm::dmat3 a(m);
    const double volume = std::abs(glm::determinant(a));
    const double size = glm::length(a[0]) * glm::length(a[1]) * glm::length(a[2]);
    return size > 0.0 && volume > 1e-9 * size;
}

gpu::VertexArray Geometry::makeVertexArray(const gpu::Buffer& drawIds) const {
    gpu::VertexArray array("surfaces");
    array.elements(indexBuffer_);
    array.attribute(0, positions_, 3, sizeof(glm::vec3));
    array.attribute(1, normals_, 3, sizeof(glm::vec3));
    if (tangents_.sizeBytes()) array.attribute(2, tangents_, 4, sizeof(glm::vec4));
    for (int s = 0; s < kTexCoordSetCount; ++s) {
        if (texCoords_[s].sizeBytes()) array.attribute(GLuint(3 + s), texCoords_[s], 2, sizeof(glm::vec2));
    }
    if (colors_.sizeBytes()) array.attribute(5, colors_, 4, sizeof(glm::vec4));
    array.integerAttribute(6, drawIds, sizeof(std::uint32_t), true);
    return array;
}

std::uint32_t Geometry::firstIndex(std::uint32_t mesh, const Primitive& primitive) const {
    const MeshRange& range = ranges_[mesh];
    return primitive.topology == Topology::Triangles ? 3 * range.firstTriangle + primitive.firstIndex
                                                     : range.firstOtherIndex + primitive.firstIndex;
}

void Geometry::update(const Scene& scene, const Moment& moment, const Eye& eye, const Eye* next) {
    deform(scene, moment, (next ? *next : eye).position());
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        worldFromModel_[i] = glm::translate(moment.instances[i].worldFromModel, originOf(i));
    }
    for (const Deforming& own : deforming_) {
        if (own.relativeToOrigin) worldFromModel_[own.instance] = glm::translate(glm::dmat4(1.0), origin_);
    }
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        gpu::InstanceData& instance = instances_[i];
        const glm::dmat4 viewFromModel = eye.viewFromWorld * worldFromModel_[i];
        storeRows(viewFromModel, instance.viewFromModel);
        storeRows(glm::dmat4(normalMatrix(glm::dmat3(viewFromModel))), instance.normalFromModel);
        instance.eyeInModel = gpu::vec4(glm::inverse(worldFromModel_[i]) * eye.point());
        const bool mirrored = glm::determinant(glm::dmat3(viewFromModel)) < 0.0;
        instance.flags = mirrored ? INSTANCE_MIRRORED : 0u;
    }
    for (const Deforming& own : deforming_) {
        const Instance& placed = moment.instances[own.instance];
        const glm::dmat4& m = placed.skinned() ? placed.worldFromBindPose[0] : placed.worldFromModel;
        const bool insideOut = own.relativeToOrigin && glm::determinant(glm::dmat3(m)) < 0.0;
        if (insideOut) instances_[own.instance].flags |= INSTANCE_INSIDE_OUT;
    }
    instanceBuffer_.write(std::span<const gpu::InstanceData>(instances_));
}

void Geometry::deform(const Scene& scene, const Moment& moment, const glm::dvec3& originNear) {
    if (deforming_.empty()) return;
    // T7: snapped to a grid as coarse as the eye is far from the world's origin is fine; 64 m keeps walks in a cell.
    const glm::dvec3 cell = glm::floor(originNear / 64.0 + 0.5) * 64.0;
    if (worldFloats_) {
        origin_ = glm::dvec3(0.0);
    } else if (!originKnown_ || glm::any(glm::greaterThan(glm::abs(originNear - origin_), glm::dvec3(48.0)))) {
        origin_ = cell;
        originKnown_ = true;
    }
    const glm::dmat4 originFromWorld = glm::translate(glm::dmat4(1.0), -origin_);
    std::vector<gpu::vec4> joints;
    std::vector<float> weights;
    for (const Deforming& own : deforming_) {
        const Instance& placed = moment.instances[own.instance];
        weights.insert(weights.end(), placed.morphWeights.begin(), placed.morphWeights.end());
        if (!own.relativeToOrigin) continue;
        for (std::uint32_t j = 0; j < own.jointCount; ++j) {
            gpu::vec4 rows[3];
            const glm::dmat4& placing = placed.skinned() ? placed.worldFromBindPose[j] : placed.worldFromModel;
            storeRows(originFromWorld * glm::translate(placing, originOf(own.instance)), rows);
            joints.insert(joints.end(), rows, rows + 3);
        }
    }
    jointMatrices_.write(std::span<const gpu::vec4>(joints));
    morphWeights_.write(std::span<const float>(weights));
    std::vector<std::uint32_t> noBounds;
    for (std::size_t i = 0; i < deforming_.size(); ++i) {
        noBounds.insert(noBounds.end(), {~0u, ~0u, ~0u, 0u, 0u, 0u});
    }
    bounds_.write(std::span<const std::uint32_t>(noBounds));

    positions_.bindStorage(BIND_POSITIONS);
    normals_.bindStorage(BIND_DEFORM_NORMALS);
    tangents_.bindStorage(BIND_DEFORM_TANGENTS);
    influences_.bindStorage(BIND_DEFORM_INFLUENCES);
    jointMatrices_.bindStorage(BIND_DEFORM_JOINTS);
    morphs_.bindStorage(BIND_DEFORM_MORPHS);
    bounds_.bindStorage(BIND_DEFORM_BOUNDS);
    morphWeights_.bindStorage(BIND_DEFORM_WEIGHTS);
    GLuint firstWeight = 0;
    for (std::size_t i = 0; i < deforming_.size(); ++i) {
        const Deforming& own = deforming_[i];
        const Instance& placed = moment.instances[own.instance];
        const std::uint32_t restVertex = ranges_[instanceMesh_[own.instance]].firstVertex;
        const GLuint values[] = {restVertex,
                                 own.firstVertex,
                                 own.vertexCount,
                                 own.firstJoint,
                                 own.jointCount,
                                 own.firstInfluence,
                                 own.influenceSets,
                                 own.firstMorph,
                                 own.morphCount,
                                 GLuint(i),
                                 tangents_.sizeBytes() > 0 ? 1u : 0u};
        for (std::size_t k = 0; k < std::size(values); ++k) deformProgram_.uniform(GLint(k), values[k]);
        float amplitude = 0.0f;
        if (placed.displacement != kNone) {
            const Displacement& procedure = scene.displacements[std::size_t(placed.displacement)];
            sample(procedure.amplitude, moment.timeSeconds, false, std::span(&amplitude, 1));
            deformProgram_.uniform(12, procedure.frequency);
            deformProgram_.uniform(13, float(double(procedure.speed) * moment.timeSeconds));
            deformProgram_.uniform(15, GLuint(procedure.kind));
            glProgramUniform3fv(deformProgram_.name(), 16, 1, &procedure.axis[0]);
        }
        deformProgram_.uniform(11, amplitude);
        deformProgram_.uniform(14, firstWeight);
        firstWeight += own.morphCount;
        deformProgram_.dispatchGroups(roundUpToChunks(own.vertexCount));
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void Geometry::setWhole(const std::vector<bool>& whole) {
    bool changed = false;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        const std::uint32_t flags = (instances_[i].flags & ~INSTANCE_WHOLE) | (whole[i] ? INSTANCE_WHOLE : 0u);
        changed = changed || flags != instances_[i].flags;
        instances_[i].flags = flags;
    }
    if (changed) instanceBuffer_.write(std::span<const gpu::InstanceData>(instances_));
}

void Geometry::bind() const {
    positions_.bindStorage(BIND_POSITIONS);
    indexBuffer_.bindStorage(BIND_INDICES);
    flagBuffer_.bindStorage(BIND_TRIANGLE_FLAGS);
    edgeBuffer_.bindStorage(BIND_EDGES);
    instanceBuffer_.bindStorage(BIND_INSTANCES);
    triangleChunkBuffer_.bindStorage(BIND_TRIANGLE_CHUNKS);
    edgeChunkBuffer_.bindStorage(BIND_EDGE_CHUNKS);
}

std::vector<Geometry::Bounds> Geometry::modelBounds() const {
    std::vector<Bounds> bounds(instances_.size());
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        const MeshRange& range = ranges_[instanceMesh_[i]];
        bounds[i] = {range.boundsMin, range.boundsMax};
    }
    if (deforming_.empty()) return bounds;
    const std::vector<std::uint32_t> words = bounds_.readAll<std::uint32_t>();
    for (std::size_t d = 0; d < deforming_.size(); ++d) {
        Bounds& own = bounds[deforming_[d].instance];
        for (int k = 0; k < 3; ++k) {
            own.low[k] = fromOrdered(words[BOUNDS_WORDS * d + std::size_t(k)]);
            own.high[k] = fromOrdered(words[BOUNDS_WORDS * d + 3 + std::size_t(k)]);
        }
    }
    return bounds;
}

std::vector<float> Geometry::readPositions() const {
    return positions_.readAll<float>();
}

}  // namespace umbrage
