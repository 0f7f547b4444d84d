// SPDX-License-Identifier: Apache-2.0
// Fixed-function state of a draw, stated in full: nothing leaks from one pass into the next.
#pragma once

#include <epoxy/gl.h>

namespace umbrage::gpu {

enum class Depth { Off, Nearer, NearerOrEqual, NotNearer };
enum class Cull { None, Back, Front };
enum class ColorOp { Off, Replace, OrBits, Add, Over };

/// One rule for both faces, or two.
struct Stencil {
    bool enabled = false;
    GLenum function = GL_ALWAYS;
    GLint reference = 0;
    GLuint compared = 0xff;  // bits
    GLenum frontFail = GL_KEEP, frontDepthFail = GL_KEEP, frontPass = GL_KEEP;
    GLenum backFail = GL_KEEP, backDepthFail = GL_KEEP, backPass = GL_KEEP;
};

struct RasterState {
    Depth depth = Depth::Off;
    bool depthWrite = false;
    bool depthClamp = false;  // off: clipped at the near plane
    bool pushedBack = false;  // by what interpolation rounds: 1/256 pixel along the slope and four quanta
    Cull cull = Cull::None;
    bool frontIsClockwise = false;
    bool everySample = false;  // run the fragment shader for each sample
    bool lines = false;        // only the borders of triangles
    ColorOp color = ColorOp::Off;
    Stencil stencil;
};

/// Depth is reversed: nearer is greater (docs/rules.md, G4).
void apply(const RasterState& state);

/// Once per context: [0, 1] depth, rows from the top, no dithering, packed rows.
void applyDefaults();

}  // namespace umbrage::gpu
