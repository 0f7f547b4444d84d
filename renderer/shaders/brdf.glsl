// SPDX-License-Identifier: Apache-2.0
// The metallic-roughness BRDF of the glTF 2.0 specification, appendix B (GGX, height-correlated Smith, Schlick).
const float kPi = 3.14159265358979;

struct Shading {
    vec3 baseColor;
    float metallic, roughness;
    vec3 n, v;  // unit, view space
};

/// BRDF times max(N.L, 0), for unit l.
vec3 reflectance(Shading s, vec3 l) {
    float nl = dot(s.n, l), nv = max(abs(dot(s.n, s.v)), 1e-4);
    if (nl <= 0.0) return vec3(0.0);
    vec3 between = l + s.v;
    vec3 h = between * inversesqrt(max(dot(between, between), 1e-20));  // 0 where they are opposite
    float nh = clamp(dot(s.n, h), 0.0, 1.0), vh = clamp(dot(s.v, h), 0.0, 1.0);
    float alpha = max(s.roughness * s.roughness, 1e-3);  // a mirror would turn a point light into nothing
    float a2 = alpha * alpha;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float distribution = a2 / (kPi * d * d);
    float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    float specular = distribution * visibility;
    float grazing = 1.0 - vh, squared = grazing * grazing;
    float schlick = squared * squared * grazing;
    vec3 metal = specular * (s.baseColor + (1.0 - s.baseColor) * schlick);
    vec3 dielectric = mix(s.baseColor / kPi, vec3(specular), 0.04 + 0.96 * schlick);
    return mix(dielectric, metal, s.metallic) * nl;
}
