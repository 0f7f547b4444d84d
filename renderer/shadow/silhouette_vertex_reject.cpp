// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003: positions and edge flags in textures, every edge a quad that is rejected in the vertex stage
// (reject.vert.glsl), wholly on the device.
#include "gpu/state.h"
#include "shadow/edge_texels.h"
#include "shadow/sides.h"

namespace umbrage {
namespace {

/// Section 4.1: the positions of all vertices of all instances.
class VertexTexels {
public:
    void draw(const Geometry& geometry);
    void bind() const {
        inView_.bind(UNIT_IN_VIEW);
        inModel_.bind(UNIT_IN_MODEL);
        firstTexels_.bindStorage(BIND_QUADS);
    }

private:
    void make(const Geometry& geometry);

    gpu::Program program_{"vertex_texels.vert", "vertex_texels.frag"};
    gpu::Texture inView_, inModel_;
    gpu::Framebuffer framebuffer_;
    gpu::VertexArray noVertices_{"texels of vertices"};
    std::vector<std::uint32_t> hostFirstTexels_;  // per instance
    gpu::Buffer firstTexels_;
};

void VertexTexels::make(const Geometry& geometry) {
    std::uint32_t texels = 0;
    for (std::size_t i = 0; i < geometry.instances().size(); ++i) {
        hostFirstTexels_.push_back(texels);
        texels += geometry.vertexCountOf(i);
    }
    firstTexels_ = gpu::Buffer::of("first texels of instances", std::span<const std::uint32_t>(hostFirstTexels_));
    inView_ = gpu::Texture("vertices relative to the camera", GL_RGBA32F, texelRows(texels));
    inModel_ = gpu::Texture("vertices of instances", GL_RGBA32F, texelRows(texels));
    const gpu::Framebuffer::Attachment colors[] = {{&inView_}, {&inModel_}};
    framebuffer_ = gpu::Framebuffer("texels of vertices", colors, nullptr);
}

void VertexTexels::draw(const Geometry& geometry) {
    if (geometry.instanceCount() == 0) return;
    if (!inView_.name()) make(geometry);
    framebuffer_.bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    glProgramUniform2ui(program_.name(), 2, GLuint(inView_.size().width), GLuint(inView_.size().height));
    program_.use();
    noVertices_.bind();
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        program_.uniform(0, i);
        program_.uniform(1, hostFirstTexels_[i]);
        ++gpu::activity().draws;
        glDrawArrays(GL_POINTS, 0, GLsizei(geometry.vertexCountOf(i)));
    }
}

class VertexReject : public DeviceSilhouettes {
public:
    explicit VertexReject(Fault fault) : DeviceSilhouettes(fault), edges_({planted(fault)}) {}

    std::string_view name() const override { return "vertex-reject"; }
    bool fillsLists() const override { return false; }
    SideShaders sideShaders() const override { return {"reject.vert"}; }
    void drawSides(const SideList& sides, const gpu::Program& program) override {
        vertices_.bind();
        edges_.bind();
        quads_.draw(sides, program, mostQuads(sides.list));
    }

private:
    void sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                    Silhouettes& out) override {
        vertices_.draw(geometry);
        setSweepUniforms(edges_.program(), geometry, group, options, out);
        edges_.draw(geometry);
    }

    VertexTexels vertices_;
    EdgeTexels edges_;
    EverySide quads_;
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeVertexReject(Fault fault) {
    return std::make_unique<VertexReject>(fault);
}

}  // namespace umbrage
