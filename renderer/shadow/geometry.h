// SPDX-License-Identifier: Apache-2.0
// The scene's geometry on the device: one set of positions that depth, shading, volumes and the oracle all read
// (Brabec & Seidel 2003, section 4.1; docs/rules.md, G3). What deforms is computed into it once a frame.
//
// Every vertex v of instance i lies at instances[i].vertexBase + v in all vertex arrays. Rigid instances share their
// mesh's vertices and keep them in model space; skinned ones, and those whose transform cannot be inverted or may
// become so, have their own, relative to an origin near the eye.
#pragma once

#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "scene/moment.h"
#include "scene/topology.h"
#include "shaders/shared.h"
#include "shadow/eye.h"

namespace umbrage {

class Geometry {
public:
    /// @param first  the scene at any time; later moments have the same instances in the same order
    /// @param worldFloats  Fault::WorldFloats
    Geometry(const Scene& scene, const Moment& first, bool worldFloats = false);

    /// Deforms what deforms and uploads the instances' matrices for this eye.
    /// @param next  the eye that the update after this one will be for, if what deforms must have the same origin then
    void update(const Scene& scene, const Moment& moment, const Eye& eye, const Eye* next = nullptr);

    /// Chooses which instances are counted with all surfaces (INSTANCE_WHOLE); uploads when that changed.
    void setWhole(const std::vector<bool>& whole);

    void bind() const;  // positions, indices, instances, triangle flags, edges, chunks

    std::uint32_t instanceCount() const { return std::uint32_t(instances_.size()); }
    std::uint32_t triangleChunkCount() const { return triangleChunkCount_; }
    std::uint32_t edgeChunkCount() const { return edgeChunkCount_; }
    std::uint32_t placedTriangleCount() const { return triangleChunkCount_ * CHUNK_SIZE; }
    std::uint32_t placedEdgeCount() const { return edgeChunkCount_ * CHUNK_SIZE; }
    const std::vector<gpu::InstanceData>& instances() const { return instances_; }
    const std::vector<MeshTopology>& topologies() const { return topologies_; }  // one a mesh
    const glm::dmat4& worldFromModel(std::size_t instance) const { return worldFromModel_[instance]; }
    /// Where the origin of an instance's model space here is in that of the file: a mesh far from its origin is moved
    /// to it.
    glm::dvec3 originOf(std::size_t instance) const { return ranges_[instanceMesh_[instance]].origin; }

    /// Vertex attributes 0 to 5 (position, normal, tangent, two texture coordinates, colour) and the indices of all
    /// primitives; attribute 6 is `drawIds`, advancing with the base instance. Draw with baseVertex = vertexBase.
    gpu::VertexArray makeVertexArray(const gpu::Buffer& drawIds) const;
    /// Where the indices of a primitive of a mesh begin in that array's element buffer.
    std::uint32_t firstIndex(std::uint32_t mesh, const Primitive& primitive) const;
    std::uint32_t meshOf(std::size_t instance) const { return instanceMesh_[instance]; }
    std::uint32_t vertexCountOf(std::size_t instance) const { return ranges_[instanceMesh_[instance]].vertexCount; }

    struct Bounds {
        glm::dvec3 low{0.0}, high{0.0};
    };
    /// Per instance, in its model space, as it is now. Reads back those of what deforms.
    std::vector<Bounds> modelBounds() const;

    const gpu::Buffer& positions() const { return positions_; }
    /// All positions as the device has them now, for techniques that run on the host and for the oracle.
    std::vector<float> readPositions() const;
    bool deforms() const { return !deforming_.empty(); }
    bool hasOwnVertices(std::uint32_t instance) const {
        return instances_[instance].vertexBase != ranges_[instanceMesh_[instance]].firstVertex;
    }

    // The same arrays on the host; positions of deforming instances are stale there.
    const std::vector<std::uint32_t>& indices() const { return indices_; }
    const std::vector<gpu::Edge>& edges() const { return edges_; }
    const std::vector<std::uint32_t>& triangleFlags() const { return triangleFlags_; }
    const std::vector<std::uint32_t>& triangleChunks() const { return triangleChunks_; }
    const std::vector<std::uint32_t>& edgeChunks() const { return edgeChunks_; }

private:
    struct MeshRange {
        std::uint32_t firstVertex = 0, vertexCount = 0, firstTriangle = 0, triangleCount = 0, firstEdge = 0,
                      edgeCount = 0;
        std::uint32_t firstOtherIndex = 0;  // lines and points: after the triangles of all meshes
        glm::vec3 origin{0.0f};             // of the positions here, in the mesh's own space
        glm::vec3 boundsMin{0.0f}, boundsMax{0.0f};
    };
    /// An instance with vertices of its own.
    struct Deforming {
        std::uint32_t instance = 0, firstVertex = 0, vertexCount = 0;
        std::uint32_t firstJoint = 0, jointCount = 0;  // in the joint matrix buffer
        std::uint32_t firstInfluence = 0, influenceSets = 0;
        std::uint32_t firstMorph = 0, morphCount = 0;  // in the morph buffer, in float triples
        bool relativeToOrigin = false;                 // baked into world space; else in model space
    };

    void uploadVertices(const Scene& scene);
    void deform(const Scene& scene, const Moment& moment, const glm::dvec3& originNear);
    bool invertible(const glm::dmat4& worldFromModel) const;

    std::vector<MeshRange> ranges_;  // one a mesh
    std::vector<bool> displaced_;    // one a mesh: some instance of it is moved along its normals
    std::vector<MeshTopology> topologies_;
    std::vector<std::uint32_t> instanceMesh_;
    std::vector<gpu::InstanceData> instances_;
    std::vector<glm::dmat4> worldFromModel_;
    std::vector<Deforming> deforming_;
    std::vector<std::uint32_t> indices_, triangleFlags_, triangleChunks_, edgeChunks_;
    std::vector<gpu::Edge> edges_;
    std::uint32_t vertexCount_ = 0, triangleChunkCount_ = 0, edgeChunkCount_ = 0;
    glm::dvec3 origin_{0.0};  // of baked positions: snapped, so that it seldom moves (T7)
    bool originKnown_ = false, worldFloats_ = false;

    gpu::Buffer positions_, normals_, tangents_, texCoords_[kTexCoordSetCount], colors_;
    gpu::Buffer influences_, jointMatrices_, morphs_, morphWeights_, bounds_;
    gpu::Buffer indexBuffer_, flagBuffer_, edgeBuffer_, triangleChunkBuffer_, edgeChunkBuffer_, instanceBuffer_;
    gpu::Program deformProgram_;
};

}  // namespace umbrage
