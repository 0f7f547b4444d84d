// SPDX-License-Identifier: Apache-2.0
#include "shadow/volumes.h"

#include <algorithm>
#include <string>

namespace umbrage {
namespace {

using Rule = VolumePart::Rule;
using Kind = VolumePart::Kind;

constexpr GLsizei kCutVertices = 9;  // of a side or cap that is cut: up to five corners

/// @param rule  of this draw: one of both for a part that is split
gpu::RasterState rasterState(Rule rule, const VolumePart& part, VolumeRenderer::Into into) {
    using Into = VolumeRenderer::Into;
    gpu::RasterState state;
    state.depthClamp = part.start != VolumePart::Start::NearPlane;  // every view ray starts at the eye itself (G5)
    state.depth = gpu::Depth::Nearer;
    const bool lightView = part.what == CAP_LIGHT_VIEW && part.kind == Kind::Cap;
    if (lightView) state.depth = gpu::Depth::Off;
    switch (into) {
        case Into::Stencil:
            state.stencil.enabled = true;
            if (part.inverts) {
                const bool fails = rule == Rule::Fail;
                (fails ? state.stencil.frontDepthFail : state.stencil.frontPass) = GL_INVERT;
                (fails ? state.stencil.backDepthFail : state.stencil.backPass) = GL_INVERT;
            } else if (rule == Rule::Fail) {
                state.stencil.frontDepthFail = GL_DECR_WRAP;
                state.stencil.backDepthFail = GL_INCR_WRAP;
            } else {
                state.stencil.frontPass = GL_INCR_WRAP;
                state.stencil.backPass = GL_DECR_WRAP;
            }
            break;
        case Into::Counter:
            if (rule == Rule::Fail) state.depth = gpu::Depth::NotNearer;
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

const gpu::Program& VolumeRenderer::Programs::of(Into into, Rule rule) const {
    const bool split = rule == Rule::Split;
    switch (into) {
        case Into::Stencil:
            return stencil;
        case Into::Counter:
            return split ? splitCounter : counter;
        case Into::Fill:
            return split ? splitFill : fill;
        case Into::Tally:
            return split ? splitTally : tally;
        case Into::Casters:
            return casters;
        default:
            return hull;
    }
}

VolumeRenderer::Programs VolumeRenderer::programs(const SideShaders& shaders, bool edgeOn, int samples) {
    const bool caps = std::string_view(shaders.vertex).find("cap") != std::string_view::npos;
    const auto variant = [&](const char* fragment, gpu::Program::Defines defines) {
        defines.insert(defines.end(), shaders.defines.begin(), shaders.defines.end());
        return gpu::Program(shaders.vertex, fragment, std::move(defines), shaders.geometry);
    };
    const auto held = [&](const char* fragment, gpu::Program::Defines defines) {
        if (edgeOn) defines.push_back("EDGE_ON 1");
        if (std::string_view(shaders.vertex) == "light_view.vert") defines.push_back("LIGHT_VIEW 1");
        if (edgeOn && caps) defines.push_back("PUSHED_BACK 1");
        return variant(fragment, std::move(defines));
    };
    const std::string sampled = "SAMPLES " + std::to_string(samples);
    return {edgeOn ? held("count.frag", {"STENCIL_ONLY 1"}) : variant("", {}),
            held("count.frag", {}),
            held("tally.frag", {sampled}),
            held("tally.frag", {"TALLY 1", "CASES 1", sampled}),
            variant("attribution.frag", {"TALLY 1"}),
            variant("hull.frag", {}),
            held("count.frag", {"PARTS 1", sampled}),
            held("tally.frag", {"PARTS 1", sampled}),
            held("tally.frag", {"PARTS 1", "TALLY 1", sampled})};
}

VolumeRenderer::VolumeRenderer(int samples, SilhouetteTechnique& technique)
    : technique_(technique),
      sides_(programs(technique.sideShaders(), false, samples)),
      edgeOnSides_(programs(technique.sideShaders(), true, samples)),
      caps_(programs({"cap.vert"}, false, samples)),
      edgeOnCaps_(programs({"cap.vert"}, true, samples)),
      cutSides_(programs({"near_side.vert"}, false, samples)),
      edgeOnCutSides_(programs({"near_side.vert"}, true, samples)),
      cutCaps_(programs({"near_cap.vert"}, false, samples)),
      edgeOnCutCaps_(programs({"near_cap.vert"}, true, samples)),
      lightViews_(programs({"light_view.vert"}, false, samples)) {}

namespace {

bool isEdgeOn(const VolumePart& part) {
    return part.kind == Kind::Cap ? part.what == CAP_EDGE_ON : part.what >= LIST_EDGE_ON;
}

void endVolumes(const VolumePart& part, const gpu::Program& program, const Silhouettes& silhouettes, std::uint32_t l) {
    program.uniform(VOLUME_END, part.endMetres);
    glProgramUniform4fv(program.name(), EXTENT_FACES, 6, &silhouettes.extents[l][0][0]);
}

/// While it lives, what is drawn may also be on the ledge.
class OnLedge {
public:
    explicit OnLedge(bool on) : on_(on) {
        if (on_) glDepthRangef(0.0f, 1.0f);
    }
    ~OnLedge() {
        if (on_) glDepthRangef(0.0f, 1.0f - float(LEDGE));
    }
    OnLedge(const OnLedge&) = delete;
    OnLedge& operator=(const OnLedge&) = delete;

private:
    bool on_;
};

}  // namespace

const VolumeRenderer::Programs& VolumeRenderer::programsOf(const VolumePart& part) const {
    const bool edgeOn = isEdgeOn(part), cut = part.start == VolumePart::Start::CapPlane;
    if (part.kind == Kind::Cap) {
        if (cut) return edgeOn ? edgeOnCutCaps_ : cutCaps_;
        if (part.what == CAP_LIGHT_VIEW) return lightViews_;
        return edgeOn ? edgeOnCaps_ : caps_;
    }
    if (cut) return edgeOn ? edgeOnCutSides_ : cutSides_;
    return edgeOn ? edgeOnSides_ : sides_;
}

void VolumeRenderer::draw(const VolumePart& part, Into into, const Geometry& geometry, const Silhouettes& silhouettes,
                          const LightGroup& group, std::uint32_t l) {
    if (part.rule == Rule::Split && into == Into::Counter) {
        // Once by each rule, so that the same depth test decides as for all other counts; what is infinitely far never
        // passes it.
        const bool farAway = part.kind == Kind::Cap && (part.what == CAP_FAR || part.what == CAP_DARK);
        if (!farAway) drawBy(Rule::Pass, part, into, geometry, silhouettes, group, l);
        drawBy(Rule::Fail, part, into, geometry, silhouettes, group, l);
    } else {
        drawBy(part.rule, part, into, geometry, silhouettes, group, l);
    }
}

void VolumeRenderer::drawBy(Rule rule, const VolumePart& part, Into into, const Geometry& geometry,
                            const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    gpu::RasterState state = rasterState(rule, part, into);
    state.everySample = isEdgeOn(part);  // a depth of its own for each sample
    const gpu::Program& program = programsOf(part).of(into, part.rule);
    program.uniform(0, group.first + l);
    program.uniform(1, silhouettes.totalLights);
    if (into == Into::Counter) {
        program.uniform(COUNT_FRONT_VALUE, float(rule == Rule::Fail ? -part.crossings : part.crossings));
    }
    const bool counts = into == Into::Counter || into == Into::Fill || into == Into::Tally;
    if (part.rule == Rule::Split && counts) program.uniform(FIRST_CLUSTER, silhouettes.parts->firstCluster(l));
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
    const bool cut = part.start == VolumePart::Start::CapPlane;
    const OnLedge onLedge(cut);
    if (part.kind == Kind::Cap) {
        drawCap(part, program, state, geometry, silhouettes, group, l);
        return;
    }
    gpu::apply(state);
    if (cut) {
        drawCutSides(part, program, silhouettes, l);
    } else {
        endVolumes(part, program, silhouettes, l);
        ++gpu::activity().draws;
        technique_.drawSides({geometry, silhouettes, group, l, part.what}, program);
    }
}

void VolumeRenderer::drawCutSides(const VolumePart& part, const gpu::Program& program, const Silhouettes& silhouettes,
                                  std::uint32_t l) {
    const gpu::DrawCommand& list = silhouettes.hostSummaries[l].lists[part.what];
    program.uniform(2, GLuint(list.baseVertex) / 4);
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(list.count / 6 * kCutVertices));
}

void VolumeRenderer::drawCap(const VolumePart& part, const gpu::Program& program, gpu::RasterState state,
                             const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                             std::uint32_t l) {
    program.uniform(2, silhouettes.facingBase(group));
    program.uniform(3, 1u << l);
    program.uniform(4, part.what);
    program.uniform(5, GLuint(part.rule == Rule::Fail));
    if (part.what == CAP_DARK) endVolumes(part, program, silhouettes, l);
    // What lies in the plane of what is seen (the surface itself, a coincident face that is culled) hides nothing, so a
    // cap at its own depth must not be nearer by rounding. Before the near plane its depth is clamped: nearer than all.
    state.pushedBack = part.what == CAP_TRUE;
    // Neighbouring instances make one range: the vertex shader drops the padding between them.
    const GLsizei vertices = part.start == VolumePart::Start::CapPlane ? kCutVertices : 3;  // of a triangle's caps
    std::vector<GLint> firsts;
    std::vector<GLsizei> counts;
    std::uint32_t last = 0;
    for (const std::uint32_t i : part.instances) {
        const gpu::InstanceData& instance = geometry.instances()[i];
        if (firsts.empty() || i != last + 1) {
            firsts.push_back(vertices * GLint(instance.placedTriangleBase));
            counts.push_back(0);
        }
        counts.back() = vertices * GLsizei(instance.placedTriangleBase + instance.triangleCount) - firsts.back();
        last = i;
    }
    gpu::apply(state);
    noVertices_.bind();
    ++gpu::activity().draws;
    glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), GLsizei(firsts.size()));
}

}  // namespace umbrage
