// SPDX-License-Identifier: Apache-2.0
// What lights do to sixteen places at once: the formulas of shaders/brdf.glsl. Nothing here may come from the standard
// library: the linker keeps one copy of what several files instantiate.

#include "lanes.inl"

namespace umbrage {
namespace {

static_assert(kLanes == kShadeLanes);
constexpr float kPi = 3.14159265358979f;

struct Shading {
    Floats3 baseColor;
    Floats metallic, roughness;
    Floats3 n, v;
};

/// The BRDF times N.L; `nl` is above 0.
inline Floats3 reflectance(const Shading& s, const Floats3& l, const Floats& nl) {
    const Floats nv = larger(magnitude(dot(s.n, s.v)), Floats{} + 1e-4f);
    const Floats3 between = l + s.v;
    const Floats3 h = (1.0f / root(larger(dot(between, between), Floats{} + 1e-20f))) * between;
    const Floats nh = within01(dot(s.n, h)), vh = within01(dot(s.v, h));
    const Floats alpha = larger(s.roughness * s.roughness, Floats{} + 1e-3f), a2 = alpha * alpha;
    const Floats d = nh * nh * (a2 - 1.0f) + 1.0f;
    const Floats shadowing = nl * root(nv * nv * (1.0f - a2) + a2) + nv * root(nl * nl * (1.0f - a2) + a2);
    const Floats specular = 0.5f * a2 / (kPi * d * d * shadowing);
    const Floats away = 1.0f - vh, away2 = away * away, schlick = away2 * away2 * away;
    const Floats share = 0.04f + 0.96f * schlick;
    const auto channel = [&](const Floats& base) {
        const Floats metal = specular * (base + (1.0f - base) * schlick);
        const Floats dielectric = base * ((1.0f - share) * (1.0f / kPi)) + specular * share;
        return (dielectric + s.metallic * (metal - dielectric)) * nl;
    };
    return {channel(s.baseColor.x), channel(s.baseColor.y), channel(s.baseColor.z)};
}

/// Bits of sixteen lights that may reach some of the pixels.
inline std::uint32_t lightsNear(const LightsReach& reach, const float (&low)[3], const float (&high)[3]) {
    const auto beyond = [](const Floats& at, float from, float to) {
        return larger(larger(from - at, at - to), Floats{});
    };
    const Floats x = beyond(load<Floats>(reach.x), low[0], high[0]), y = beyond(load<Floats>(reach.y), low[1], high[1]),
                 z = beyond(load<Floats>(reach.z), low[2], high[2]);
    const Ints near = x * x + y * y + z * z <= load<Floats>(reach.range2);
    std::uint32_t bits = 0;
    for (int i = 0; i < kLanes; ++i) bits |= std::uint32_t(near[i] != 0) << i;
    return bits;
}

inline void boundsOf(const Floats3& p, const Ints& of, float (&low)[3], float (&high)[3]) {
    const Floats* values[] = {&p.x, &p.y, &p.z};
    for (int k = 0; k < 3; ++k) {
        const Floats least = of ? *values[k] : Floats{} + kInfinity, most = of ? *values[k] : Floats{} - kInfinity;
        low[k] = kInfinity;
        high[k] = -kInfinity;
        for (int i = 0; i < kLanes; ++i) {
            low[k] = least[i] < low[k] ? least[i] : low[k];
            high[k] = most[i] > high[k] ? most[i] : high[k];
        }
    }
}

}  // namespace
}  // namespace umbrage
