// SPDX-License-Identifier: Apache-2.0
#include "shading/again.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrage {
namespace {

gpu::RasterState nearest() {
    gpu::RasterState state;
    state.depth = gpu::Depth::Nearer;
    state.depthWrite = true;
    state.color = gpu::ColorOp::Replace;
    return state;
}

}  // namespace

SurfacesAgain::Programs::Programs(const char* what)
    : opaque("surface.vert", "again.frag", {fmt::format("{} 1", what)}),
      masked("surface.vert", "again.frag", {fmt::format("{} 1", what), "ALPHA_TEST 1"}) {}

SurfacesAgain::SurfacesAgain(const gpu::Texture& depthStencil)
    : depth_("depth, drawn again", GL_DEPTH32F_STENCIL8, depthStencil.size()) {}

void SurfacesAgain::begin(const gpu::ScreenTarget& target, float emptyDepth) const {
    target.clear();
    gpu::RasterState state;
    state.depthWrite = true;
    gpu::apply(state);
    glClearNamedFramebufferfi(target.framebuffer().name(), GL_DEPTH_STENCIL, 0, emptyDepth, 0);
    target.framebuffer().bind();
}

SceneFragments SurfacesAgain::countFragments(Surfaces& surfaces, const Geometry& geometry, const Materials& materials,
                                             float emptyDepth) {
    if (!tally_) tally_ = gpu::ScreenTarget("scene overdraw", GL_R32F, depth_.size(), &depth_);
    SceneFragments result;
    const gpu::SampleQuery query("scene fragments");
    const auto count = [&](bool depthWrite, std::uint64_t& samples) {
        begin(tally_, emptyDepth);
        Surfaces::OpaquePass pass{&tallyPrograms_.opaque, &tallyPrograms_.masked, nullptr, nearest()};
        pass.state.color = gpu::ColorOp::Add;
        pass.state.depthWrite = depthWrite;  // off: nothing but what is too far to be seen fails the test
        query.begin();
        surfaces.drawOpaque(geometry, materials, pass);
        query.end();
        samples = query.result();
        return tally_.readMean(1);
    };
    ofMaterials_.reserve("fragments of materials", materials.count() * sizeof(std::uint32_t));
    ofMaterials_.clearToZero();
    ofMaterials_.bindStorage(BIND_FILL);
    result.fragments = count(false, result.fragmentSamples);
    result.samplesOfMaterials.resize(materials.count());
    ofMaterials_.read(0, materials.count() * sizeof(std::uint32_t), result.samplesOfMaterials.data());
    result.shaded = count(true, result.shadedSamples);
    result.coveredPixels = std::uint64_t(
        std::count_if(result.fragments.begin(), result.fragments.end(), [](float n) { return n > 0.0f; }));
    return result;
}

std::vector<std::uint32_t> SurfacesAgain::readIds(Surfaces& surfaces, const Geometry& geometry,
                                                  const Materials& materials, float emptyDepth) {
    if (!ids_) ids_ = gpu::ScreenTarget("ids", GL_RGBA32UI, depth_.size(), &depth_);
    begin(ids_, emptyDepth);
    surfaces.drawOpaque(geometry, materials, {&idPrograms_.opaque, &idPrograms_.masked, nullptr, nearest()});
    return ids_.readFirstIntegers(3);
}

std::vector<float> SurfacesAgain::readMotion(Surfaces& surfaces, const Geometry& geometry, const Materials& materials,
                                             float emptyDepth, const PreviousFrame& previous) {
    if (!motion_) motion_ = gpu::ScreenTarget("motion", GL_RG32F, depth_.size(), &depth_);
    begin(motion_, emptyDepth);
    gpu::VertexArray vertices = surfaces.makeVertexArray(geometry);
    vertices.attribute(7, previous.positions.name() ? previous.positions : geometry.positions(), 3, sizeof(glm::vec3));
    previous.viewFromModel.bindStorage(BIND_PREVIOUS);
    for (const gpu::Program* program : {&motionPrograms_.opaque, &motionPrograms_.masked}) {
        glProgramUniform2f(program->name(), 1, previous.rayScale.x, previous.rayScale.y);
    }
    Surfaces::OpaquePass pass{&motionPrograms_.opaque, &motionPrograms_.masked, &vertices, nearest()};
    pass.state.everySample = depth_.size().samples > 1;  // positions of the sample, not of the pixel's middle
    surfaces.drawOpaque(geometry, materials, pass);
    return motion_.readFirst(2);
}

}  // namespace umbrage
