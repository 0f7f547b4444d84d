// SPDX-License-Identifier: Apache-2.0
#include "gpu/sample_ties.h"

#include "gpu/program.h"
#include "gpu/screen_target.h"
#include "gpu/state.h"

namespace umbrage::gpu {
namespace {

constexpr int kSize = 4;

/// Whether the pixel on the edge is covered.
bool covers(const ScreenTarget& target, const Program& program, bool below) {
    target.framebuffer().bind();
    RasterState state;
    state.color = ColorOp::Replace;
    apply(state);
    const GLuint zero[4] = {};
    glClearBufferuiv(GL_COLOR, 0, zero);
    program.uniform(0, GLuint(below));
    program.use();
    const VertexArray noVertices("sample ties");
    noVertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    GLuint pixels[kSize * kSize];
    readPixels(target.framebuffer().name(), kSize, kSize, GL_RED_INTEGER, GL_UNSIGNED_INT, sizeof pixels, pixels);
    return pixels[below ? kSize + 2 : 2 * kSize + 1] != 0;
}

}  // namespace

SampleTies findSampleTies() {
    const ScreenTarget target("sample ties", GL_R32UI, {kSize, kSize}, nullptr);
    const Program program("sample_ties.vert", "sample_ties.frag");
    return {covers(target, program, false) ? 1 : -1, covers(target, program, true) ? 1 : -1};
}

}  // namespace umbrage::gpu
