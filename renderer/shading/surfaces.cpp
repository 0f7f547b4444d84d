// SPDX-License-Identifier: Apache-2.0
#include "shading/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace umbrage {
namespace {

GLenum modeOf(Topology topology) {
    switch (topology) {
        case Topology::Lines:
            return GL_LINES;
        case Topology::Points:
            return GL_POINTS;
        default:
            return GL_TRIANGLES;
    }
}

glm::dvec3 centerOf(const Mesh& mesh, const Primitive& primitive) {
    glm::dvec3 low(1e300), high(-1e300);
    for (std::uint32_t i = 0; i < primitive.indexCount; ++i) {
        const glm::dvec3 p = mesh.positions[mesh.indices[primitive.firstIndex + i]];
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return 0.5 * (low + high);
}

}  // namespace

Surfaces::Surfaces(const Scene& scene, const Geometry& geometry)
    : holed_(geometry.instanceCount()), vertexArray_("surfaces") {
    std::vector<gpu::DrawData> data;
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const Mesh& mesh = scene.meshes[geometry.meshOf(i)];
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.indexCount == 0) continue;
            const bool isTriangles = primitive.topology == Topology::Triangles;
            Draw draw;
            draw.id = std::uint32_t(data.size());
            draw.instance = i;
            draw.material =
                primitive.material == kNone ? std::uint32_t(scene.materials.size()) : std::uint32_t(primitive.material);
            draw.firstIndex = geometry.firstIndex(geometry.meshOf(i), primitive);
            draw.indexCount = primitive.indexCount;
            draw.mode = modeOf(primitive.topology);
            gpu::DrawData entry{};
            entry.instance = i;
            entry.material = draw.material;
            entry.firstPlacedTriangle =
                isTriangles ? geometry.instances()[i].placedTriangleBase + primitive.firstIndex / 3 : NO_TRIANGLE;
            if (primitive.hasNormals) entry.flags |= DRAW_HAS_NORMALS;
            if (primitive.hasTangents) entry.flags |= DRAW_HAS_TANGENTS;
            if (primitive.hasColors) entry.flags |= DRAW_HAS_COLORS;
            data.push_back(entry);
            const Material material = primitive.material == kNone ? Material{} : scene.materials[primitive.material];
            const AlphaMode alpha = material.alphaMode;
            anyEmissive_ = anyEmissive_ || !isTriangles || material.unlit || material.emissive != glm::vec3(0.0f);
            if (alpha == AlphaMode::Blend) {
                draw.center = centerOf(mesh, primitive) - geometry.originOf(i);
                blended_.push_back(draw);
            } else {
                opaque_.push_back(draw);
                if (alpha == AlphaMode::Mask && isTriangles) holed_[i] = true;
            }
        }
    }
    std::stable_sort(opaque_.begin(), opaque_.end(),
                     [](const Draw& a, const Draw& b) { return a.material < b.material; });
    std::vector<std::uint32_t> ids(data.size());
    std::iota(ids.begin(), ids.end(), 0u);
    drawBuffer_ = gpu::Buffer::of("draws", std::span<const gpu::DrawData>(data));
    drawIds_ = gpu::Buffer::of("draw ids", std::span<const std::uint32_t>(ids));
    vertexArray_ = geometry.makeVertexArray(drawIds_);
}

bool Surfaces::frontIsClockwise(const Draw& draw, const Geometry& geometry) const {
    return geometry.instances()[draw.instance].flags & (INSTANCE_MIRRORED | INSTANCE_INSIDE_OUT);
}

void Surfaces::submit(const Draw& draw, const Geometry& geometry) const {
    ++gpu::activity().draws;
    glDrawElementsInstancedBaseVertexBaseInstance(
        draw.mode, GLsizei(draw.indexCount), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(draw.firstIndex * sizeof(std::uint32_t)), 1,
        GLint(geometry.instances()[draw.instance].vertexBase), draw.id);
}

const gpu::Program& Surfaces::gbufferProgram(std::uint32_t textures, bool masked) {
    const auto [found, isNew] = gbufferPrograms_.try_emplace({textures, masked});
    if (isNew) {
        gpu::Program::Defines defines{fmt::format("TEXTURES {}u", textures)};
        if (masked) defines.emplace_back("ALPHA_TEST 1");
        found->second = gpu::Program("surface.vert", "gbuffer.frag", std::move(defines));
    }
    return found->second;
}

void Surfaces::drawOpaque(const Geometry& geometry, const Materials& materials, const std::vector<bool>& unseen) {
    OpaquePass pass;
    pass.unseen = &unseen;
    pass.state.depth = gpu::Depth::Nearer;
    pass.state.depthWrite = true;
    pass.state.color = gpu::ColorOp::Replace;
    drawOpaque(geometry, materials, pass);
}

void Surfaces::drawOpaque(const Geometry& geometry, const Materials& materials, const OpaquePass& pass) {
    geometry.bind();
    drawBuffer_.bindStorage(BIND_DRAWS);
    (pass.vertices ? *pass.vertices : vertexArray_).bind();
    gpu::RasterState state = pass.state;
    std::uint32_t bound = ~0u;
    bool boundClockwise = false;
    for (const Draw& draw : opaque_) {
        // Lines and points are a pixel wide.
        if (pass.unseen && draw.mode == GL_TRIANGLES && (*pass.unseen)[draw.instance]) continue;
        const bool isClockwise = frontIsClockwise(draw, geometry);
        if (draw.material != bound || isClockwise != boundClockwise) {
            const Material& material = materials.material(draw.material);
            if (draw.material != bound) materials.bind(draw.material);
            state.cull = material.doubleSided ? gpu::Cull::None : gpu::Cull::Back;
            state.frontIsClockwise = isClockwise;
            gpu::apply(state);
            const bool masked = material.alphaMode == AlphaMode::Mask;
            const gpu::Program* given = masked ? pass.masked : pass.opaque;
            (given ? *given : gbufferProgram(materials.texturesOf(draw.material), masked)).use();
            bound = draw.material;
            boundClockwise = isClockwise;
        }
        submit(draw, geometry);
    }
}

void Surfaces::drawCasters(const Geometry& geometry, const std::vector<bool>& leftOut) const {
    geometry.bind();
    drawBuffer_.bindStorage(BIND_DRAWS);
    vertexArray_.bind();
    for (const Draw& draw : opaque_) {
        if (draw.mode == GL_TRIANGLES && !leftOut[draw.instance]) submit(draw, geometry);
    }
}

void Surfaces::findExposed(const Geometry& geometry, const Materials& materials, const std::vector<bool>& unseen,
                           const gpu::Buffer& casters) {
    geometry.bind();
    drawBuffer_.bindStorage(BIND_DRAWS);
    casters.bindStorage(BIND_CASTERS);
    vertexArray_.bind();
    exposureProgram_.use();
    gpu::RasterState state;
    state.depth = gpu::Depth::Nearer;
    state.cull = gpu::Cull::Front;
    for (const bool clockwise : {false, true}) {
        state.frontIsClockwise = clockwise;
        gpu::apply(state);
        for (const Draw& draw : opaque_) {
            if (unseen[draw.instance]) continue;
            const bool culled = draw.mode == GL_TRIANGLES && !materials.material(draw.material).doubleSided;
            if (culled && frontIsClockwise(draw, geometry) == clockwise) submit(draw, geometry);
        }
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void Surfaces::drawBlended(const Geometry& geometry, const Materials& materials, const Eye& eye,
                           std::span<const Geometry::Bounds> worldBoxes) {
    std::vector<std::pair<double, const Draw*>> order;
    for (const Draw& draw : blended_) {
        const Geometry::Bounds& box = worldBoxes[draw.instance];
        const glm::dvec4 inWorld = geometry.hasOwnVertices(draw.instance)
                                       ? glm::dvec4(0.5 * (box.low + box.high), 1.0)
                                       : geometry.worldFromModel(draw.instance) * glm::dvec4(draw.center, 1.0);
        const glm::dvec4 center = eye.viewFromWorld * inWorld;
        order.emplace_back(center.z, &draw);
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    geometry.bind();
    drawBuffer_.bindStorage(BIND_DRAWS);
    vertexArray_.bind();
    blendedProgram_.use();
    gpu::RasterState state;
    state.depth = gpu::Depth::NearerOrEqual;
    state.color = gpu::ColorOp::Over;
    for (const auto& [z, draw] : order) {
        materials.bind(draw->material);
        state.frontIsClockwise = frontIsClockwise(*draw, geometry);
        for (const gpu::Cull cull : {gpu::Cull::Front, gpu::Cull::Back}) {
            if (cull == gpu::Cull::Front && !materials.material(draw->material).doubleSided) continue;
            state.cull = draw->mode == GL_TRIANGLES ? cull : gpu::Cull::None;
            gpu::apply(state);
            submit(*draw, geometry);
        }
    }
}

}  // namespace umbrage
