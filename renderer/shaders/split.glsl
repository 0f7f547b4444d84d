// SPDX-License-Identifier: Apache-2.0
// The split test of a pixel (Laine 2005): whether a part is counted there by z-pass, else by z-fail. All polygons of a
// part must agree, so what is tested depends on nothing but the pixel, the depth seen there, and the part.
#include "view.glsl"

layout(std430, binding = BIND_PARTS) readonly buffer Parts { SplitPart parts[]; };

bool countsByPass(uint part, float depth) {
    // No plane where an end of the view rays lies on the part's volumes: the count starts from the other one.
    uint hazards = parts[part].hazards;
    if (hazards != 0u) return (hazards & 1u << SPLIT_PASS) == 0u;
    vec2 ndc = (vec2(ivec2(gl_FragCoord.xy)) + 0.5) * view.pixelSize - 1.0 + vec2(view.shift.x, -view.shift.y);
    vec4 plane = parts[part].plane;
    precise float side = plane.x * ndc.x - plane.y * ndc.y + plane.z * depth + plane.w;  // rows from the top
    return side > 0.0;
}
