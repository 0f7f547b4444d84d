// SPDX-License-Identifier: Apache-2.0
#include "shadow/volumes.h"

#include <algorithm>
#include <string>

namespace umbrage {
namespace {

using Rule = VolumePart::Rule;
using Kind = VolumePart::Kind;

gpu::RasterState rasterState(const VolumePart& part, VolumeRenderer::Into into) {
    using Into = VolumeRenderer::Into;
    gpu::RasterState state;
    state.depthClamp = true;  // every view ray starts at the eye itself (G5)
    state.depth = gpu::Depth::Nearer;
    switch (into) {
        case Into::Stencil:
            state.stencil.enabled = true;
            if (part.rule == Rule::Fail) {
                state.stencil.frontDepthFail = GL_DECR_WRAP;
                state.stencil.backDepthFail = GL_INCR_WRAP;
            } else {
                state.stencil.frontPass = GL_INCR_WRAP;
                state.stencil.backPass = GL_DECR_WRAP;
            }
            break;
        case Into::Counter:
            if (part.rule == Rule::Fail) state.depth = gpu::Depth::NotNearer;
            state.color = gpu::ColorOp::Add;
            break;
        case Into::Fill:
        case Into::Tally:
        case Into::Casters:
            state.depth = gpu::Depth::Off;
            state.color = gpu::ColorOp::Add;
            break;
        case Into::Faces:
        case Into::Lines:
            state.color = gpu::ColorOp::Add;
            state.lines = into == Into::Lines;
            break;
    }
    return state;
}

std::uint32_t fillKindOf(const VolumePart& part) {
    if (part.kind == Kind::Cap) return part.what == CAP_DARK ? FILL_DARK_CAPS : FILL_LIGHT_CAPS;
    return part.what % LIST_KINDS == LIST_HALVED ? FILL_HALVED_SIDES : FILL_SIDES;
}

}  // namespace

const gpu::Program& VolumeRenderer::Programs::of(Into into) const {
    switch (into) {
        case Into::Stencil:
            return stencil;
        case Into::Counter:
            return counter;
        case Into::Fill:
            return fill;
        case Into::Tally:
            return tally;
        case Into::Casters:
            return casters;
        default:
            return hull;
    }
}

VolumeRenderer::Programs VolumeRenderer::programs(const SideShaders& shaders, bool edgeOn, int samples) {
    const auto variant = [&](const char* fragment, gpu::Program::Defines defines) {
        defines.insert(defines.end(), shaders.defines.begin(), shaders.defines.end());
        return gpu::Program(shaders.vertex, fragment, std::move(defines), shaders.geometry);
    };
    const auto held = [&](const char* fragment, gpu::Program::Defines defines) {
        if (edgeOn) defines.push_back("EDGE_ON 1");
        if (edgeOn && std::string_view(shaders.vertex) == "cap.vert") defines.push_back("PUSHED_BACK 1");
        return variant(fragment, std::move(defines));
    };
    return {edgeOn ? held("count.frag", {"STENCIL_ONLY 1"}) : variant("", {}),
            held("count.frag", {"SIGNED 1"}),
            held("tally.frag", {"SAMPLES " + std::to_string(samples)}),
            held("tally.frag", {"TALLY 1", "SAMPLES " + std::to_string(samples)}),
            variant("attribution.frag", {"TALLY 1"}),
            variant("hull.frag", {})};
}

VolumeRenderer::VolumeRenderer(int samples, SilhouetteTechnique& technique)
    : technique_(technique),
      sides_(programs(technique.sideShaders(), false, samples)),
      edgeOnSides_(programs(technique.sideShaders(), true, samples)),
      caps_(programs({"cap.vert"}, false, samples)),
      edgeOnCaps_(programs({"cap.vert"}, true, samples)) {}

void VolumeRenderer::draw(const VolumePart& part, Into into, const Geometry& geometry, const Silhouettes& silhouettes,
                          const LightGroup& group, std::uint32_t l) {
    gpu::RasterState state = rasterState(part, into);
    const bool cap = part.kind == Kind::Cap, edgeOn = cap ? part.what == CAP_EDGE_ON : part.what >= LIST_EDGE_ON;
    state.everySample = edgeOn;  // a depth of its own for each sample
    const Programs& programs = cap ? (edgeOn ? edgeOnCaps_ : caps_) : (edgeOn ? edgeOnSides_ : sides_);
    const gpu::Program& program = programs.of(into);
    program.uniform(0, group.first + l);
    program.uniform(1, silhouettes.totalLights);
    if (into == Into::Counter) program.uniform(COUNT_FRONT_VALUE, part.rule == Rule::Fail ? -1.0f : 1.0f);
    if (into == Into::Faces || into == Into::Lines) {
        glProgramUniform4fv(program.name(), HULL_COLOR, 1, &hullColor_[0]);
    }
    if (into == Into::Fill || into == Into::Tally) {
        program.uniform(TALLY_KIND, fillKindOf(part));
        program.uniform(TALLY_FAILED, GLuint(part.rule == Rule::Fail));
    }
    geometry.bind();
    silhouettes.bind();
    program.use();
    if (cap) {
        drawCap(part, program, state, geometry, silhouettes, group, l);
    } else {
        glProgramUniform4fv(program.name(), EXTENT_FACES, 6, &silhouettes.extents[l][0][0]);
        gpu::apply(state);
        ++gpu::activity().draws;
        technique_.drawSides({geometry, silhouettes, group, l, part.what}, program);
    }
}

void VolumeRenderer::drawCap(const VolumePart& part, const gpu::Program& program, gpu::RasterState state,
                             const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                             std::uint32_t l) {
    program.uniform(2, silhouettes.facingBase(group));
    program.uniform(3, 1u << l);
    program.uniform(4, part.what);
    program.uniform(5, GLuint(part.rule == Rule::Fail));
    // What lies in the plane of what is seen (the surface itself, a coincident face that is culled) hides nothing, so a
    // cap at its own depth must not be nearer by rounding. Before the near plane its depth is clamped: nearer than all.
    state.pushedBack = part.what == CAP_TRUE;
    // Neighbouring instances make one range: the vertex shader drops the padding between them.
    std::vector<GLint> firsts;
    std::vector<GLsizei> counts;
    std::uint32_t last = 0;
    for (const std::uint32_t i : part.instances) {
        const gpu::InstanceData& instance = geometry.instances()[i];
        if (firsts.empty() || i != last + 1) {
            firsts.push_back(GLint(3 * instance.placedTriangleBase));
            counts.push_back(0);
        }
        counts.back() = GLsizei(3 * (instance.placedTriangleBase + instance.triangleCount)) - firsts.back();
        last = i;
    }
    gpu::apply(state);
    noVertices_.bind();
    ++gpu::activity().draws;
    glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), GLsizei(firsts.size()));
}

}  // namespace umbrage
