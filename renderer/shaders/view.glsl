// SPDX-License-Identifier: Apache-2.0
#ifndef VIEW_GLSL
#define VIEW_GLSL
#include "shared.h"

layout(std140, binding = BIND_VIEW) uniform View { ViewData view; };

/// Reversed depth: perspective z_clip = znear exactly, so a direction (w = 0) has z_clip = 0: infinitely far.
vec4 clipFromView(vec3 p, float w) {
    precise vec4 c;
    c.x = view.clipFromView[0][0] * p.x + (view.clipFromView[2][0] * p.z + view.clipFromView[3][0] * w);
    c.y = view.clipFromView[1][1] * p.y + (view.clipFromView[2][1] * p.z + view.clipFromView[3][1] * w);
    c.z = view.clipFromView[2][2] * p.z + view.clipFromView[3][2] * w;
    c.w = view.clipFromView[2][3] * p.z + view.clipFromView[3][3] * w;
    return c;
}
#endif
