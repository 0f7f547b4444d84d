// SPDX-License-Identifier: Apache-2.0
// The lit surface at a sample of the G-buffer, as the BRDF needs it.
Shading shadingAt(ivec2 at, vec4 properties, vec3 p) {
    Shading s;
    s.baseColor = texelFetch(baseColorTexture, at, gbufferSample).rgb;
    s.metallic = properties.x;
    s.roughness = properties.y;
    s.n = unitFromOctahedron(texelFetch(normalTexture, at, gbufferSample).rg);
    s.v = view.perspective != 0u ? normalize(-p) : vec3(0.0, 0.0, 1.0);
    return s;
}
