// SPDX-License-Identifier: Apache-2.0
#include "gpu/state.h"

#include "gpu/activity.h"

namespace umbrage::gpu {
namespace {

void enable(GLenum capability, bool on) {
    on ? glEnable(capability) : glDisable(capability);
}

GLenum depthFunction(Depth depth) {
    switch (depth) {
        case Depth::Nearer:
            return GL_GREATER;
        case Depth::NearerOrEqual:
            return GL_GEQUAL;
        case Depth::NotNearer:
            return GL_LEQUAL;
        default:
            return GL_ALWAYS;
    }
}

void applyStencil(const Stencil& stencil) {
    enable(GL_STENCIL_TEST, stencil.enabled);
    if (!stencil.enabled) return;
    glStencilFunc(stencil.function, stencil.reference, stencil.compared);
    glStencilMask(0xff);
    glStencilOpSeparate(GL_FRONT, stencil.frontFail, stencil.frontDepthFail, stencil.frontPass);
    glStencilOpSeparate(GL_BACK, stencil.backFail, stencil.backDepthFail, stencil.backPass);
}

void applyColor(ColorOp color) {
    const GLboolean write = color != ColorOp::Off;
    glColorMask(write, write, write, write);
    enable(GL_COLOR_LOGIC_OP, color == ColorOp::OrBits);
    if (color == ColorOp::OrBits) glLogicOp(GL_OR);
    enable(GL_BLEND, color == ColorOp::Add || color == ColorOp::Over);
    if (color == ColorOp::Add) glBlendFunc(GL_ONE, GL_ONE);
    if (color == ColorOp::Over) glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied
}

}  // namespace

void apply(const RasterState& state) {
    ++activity().stateChanges;
    enable(GL_DEPTH_TEST, state.depth != Depth::Off);
    glDepthFunc(depthFunction(state.depth));
    glDepthMask(state.depthWrite);
    enable(GL_DEPTH_CLAMP, state.depthClamp);
    enable(GL_POLYGON_OFFSET_FILL, state.pushedBack);
    if (state.pushedBack) glPolygonOffset(-1.0f / 256.0f, -4.0f);
    enable(GL_SAMPLE_SHADING, state.everySample);
    glMinSampleShading(1.0f);
    enable(GL_CULL_FACE, state.cull != Cull::None);
    glCullFace(state.cull == Cull::Front ? GL_FRONT : GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, state.lines ? GL_LINE : GL_FILL);
    glFrontFace(state.frontIsClockwise ? GL_CW : GL_CCW);
    applyStencil(state.stencil);
    applyColor(state.color);
}

void applyDefaults() {
    // Row 0 is the top row, as in image files: no picture is ever flipped.
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glClearDepth(0.0);
    // llvmpipe turns clockwise triangles around so that their first vertex stays first: then two coincident ones that
    // run in opposite directions interpolate the same depths.
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glDisable(GL_DITHER);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

}  // namespace umbrage::gpu
