// SPDX-License-Identifier: Apache-2.0
// See shade_row.h. Included by one file for each instruction set. Nothing here may come from the standard library: the
// linker keeps one copy of what several files instantiate.
//
// The formulas are those of shaders/resolve.frag.glsl, gbuffer.glsl, lights.glsl and brdf.glsl, for sixteen pixels at
// once.

#include "shading/lit_lanes.inl"

namespace umbrage {
namespace {

constexpr Floats kCount{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// What is lit of sixteen pixels.
struct Surface {
    Ints lit, triangle;
    Floats3 p;   // view space
    Ints front;  // its front is seen
    Shading shading;
};

inline Floats toFloats(const Ints& v) {
    return __builtin_convertvector(v, Floats);
}
/// Of unsigned 16 bits in the low or high half.
inline Floats lowHalf(const Ints& v) {
    return toFloats(v & 0xffff) * (1.0f / 65535.0f);
}
inline Floats highHalf(const Ints& v) {
    return toFloats(v >> 16 & 0xffff) * (1.0f / 65535.0f);
}
inline Floats byteOf(const Ints& v, int byte) {
    return toFloats(v >> (8 * byte) & 0xff) * (1.0f / 255.0f);
}
/// Of a half that is finite and not negative.
inline Floats fromHalf(const Ints& half) {
    const Ints bits = (half & 0x7fff) << 13;
    return load<Floats>(&bits) * 0x1p112f;
}
inline Floats3 of(const glm::vec4& v) {
    return {Floats{} + v.x, Floats{} + v.y, Floats{} + v.z};
}
/// The first and the second of pairs.
inline void pairsAt(const std::uint32_t* pairs, const Ints& index, Ints& first, Ints& second) {
    first = gather<Ints>(pairs, 2 * index);
    second = gather<Ints>(pairs + 1, 2 * index);
}

inline Floats3 unitFromOctahedron(const Ints& packed) {
    Floats x = lowHalf(packed) * 2.0f - 1.0f, y = highHalf(packed) * 2.0f - 1.0f;
    const Floats z = 1.0f - magnitude(x) - magnitude(y), fold = larger(-z, Floats{});
    x -= x >= 0.0f ? fold : -fold;
    y -= y >= 0.0f ? fold : -fold;
    return unit({x, y, z});
}

/// What arrives at p, as arriving() in lights.glsl. @param l  becomes the unit direction to the light
inline Floats arriving(const gpu::LightData& light, const Floats3& p, Floats3& l) {
    const Floats3 place = of(light.position);
    if (light.position.w == 0.0f) {
        l = place;
        return Floats{} + light.color.w;
    }
    const Floats3 way{place.x - p.x, place.y - p.y, place.z - p.z};
    const Floats d2 = larger(dot(way, way), Floats{} + 1e-12f);
    l = (1.0f / root(d2)) * way;
    const Floats ratio = d2 * light.direction.w;
    const Floats window = within01(1.0f - ratio * ratio);
    const Floats cone = within01(light.cone.y - light.cone.x * dot(of(light.direction), l));
    return light.color.w * window * cone * cone / d2;
}

/// Distance along the view axis, as eyeDistance() in gbuffer.glsl.
inline Floats eyeDistance(const ShadeRow& row, const Ints& triangle, const Ints& isTriangle, const Floats& depth,
                          const Floats3& ray, Ints& front) {
    const gpu::ViewData& view = *row.view;
    const bool perspective = view.perspective != 0u;
    const Floats scaled = depth / view.sceneDepths;
    const Floats stored = perspective ? view.znear / scaled : view.zfar - scaled * (view.zfar - view.znear);
    const auto value = [&](int k) { return gather<Floats>(row.planes + k, 4 * triangle); };
    const Floats nx = value(0), ny = value(1), nz = value(2), w = value(3);
    const Floats across = nx * ray.x + ny * ray.y;
    const Floats exact = perspective ? -w / (across - nz) : (across + w) / nz;
    front = (perspective ? w : nz) > 0.0f;
    const Ints holds = isTriangle & (magnitude(exact - stored) < magnitude(stored) * 0.00390625f);
    return holds ? exact : stored;
}

inline void addLights(const ShadeRow& row, int x, const Surface& s, Floats3& radiance) {
    float low[3], high[3];
    boundsOf(s.p, s.lit, low, high);
    Ints reaching{};  // bits of the group's lights
    for (std::uint32_t first = 0; first < row.view->lightCount; first += kLanes) {
        const std::uint32_t group = first / LIGHTS_PER_GROUP;
        if (first % LIGHTS_PER_GROUP == 0) {
            Ints sideFront, sideBack;
            pairsAt(row.facing[group], s.triangle, sideFront, sideBack);
            reaching = (s.front ? sideFront : sideBack) & ~load<Ints>(row.dark[group] + x);
        }
        for (std::uint32_t near = lightsNear(row.reach[first / kLanes], low, high); near != 0u; near &= near - 1u) {
            const std::uint32_t l = first + std::uint32_t(__builtin_ctz(near));
            const Ints reached = s.lit & ((reaching >> int(l % LIGHTS_PER_GROUP) & 1) != 0);
            if (!any(reached)) continue;
            const gpu::LightData& light = row.lights[l];
            Floats3 way;
            const Floats strength = arriving(light, s.p, way), nl = dot(s.shading.n, way);
            const Ints adds = reached & (strength > 0.0f) & (nl > 0.0f);
            if (!any(adds)) continue;
            const Floats3 reflected = reflectance(s.shading, way, nl);
            radiance.x += adds ? strength * light.color.x * reflected.x : Floats{};
            radiance.y += adds ? strength * light.color.y * reflected.y : Floats{};
            radiance.z += adds ? strength * light.color.z * reflected.z : Floats{};
        }
    }
}

inline Floats3 shadePixels(const ShadeRow& row, int x, const Ints& seen) {
    const gpu::ViewData& view = *row.view;
    const Ints index = __builtin_convertvector(kCount, Ints) + x;
    Floats3 radiance{};
    if (row.emissive != nullptr) {
        Ints rg, ba;
        pairsAt(row.emissive, index, rg, ba);
        radiance = {fromHalf(rg), fromHalf(rg >> 16), fromHalf(ba)};
    }
    const Ints properties = load<Ints>(row.properties + x);
    Surface s;
    s.lit = seen & (byteOf(properties, 3) > 0.5f);
    if (!any(s.lit)) return radiance;
    const Ints stored = load<Ints>(row.triangles + x), isTriangle = stored != std::int32_t(NO_TRIANGLE);
    s.triangle = s.lit & isTriangle ? stored : Ints{};
    const Floats ndcX = (kCount + (float(x) + 0.5f)) * view.pixelSize.x - 1.0f + view.shift.x;
    const float ndcY = 1.0f - (float(row.y) + 0.5f) * view.pixelSize.y + view.shift.y;
    const Floats3 ray{ndcX * view.rayScale.x, Floats{} + ndcY * view.rayScale.y, Floats{} - 1.0f};
    const Floats e = eyeDistance(row, s.triangle, isTriangle, load<Floats>(row.depths + x), ray, s.front);
    const bool perspective = view.perspective != 0u;
    s.p = perspective ? e * ray : Floats3{ray.x, ray.y, -e};
    s.lit &= isTriangle;
    Shading& shading = s.shading;
    Ints rg, ba;
    pairsAt(row.baseColor, index, rg, ba);
    shading.baseColor = {lowHalf(rg), highHalf(rg), lowHalf(ba)};
    shading.metallic = byteOf(properties, 0);
    shading.roughness = byteOf(properties, 1);
    shading.n = unitFromOctahedron(load<Ints>(row.normal + x));
    const Floats3 towards{-s.p.x, -s.p.y, -s.p.z};
    shading.v = perspective ? unit(towards) : Floats3{Floats{}, Floats{}, Floats{} + 1.0f};
    const Floats up = 0.5f + 0.5f * dot(shading.n, of(view.upInView)), occlusion = byteOf(properties, 2);
    const auto ambient = [&](Floats& sum, const Floats& base, float ground, float sky) {
        sum += s.lit ? base * occlusion * (ground + (sky - ground) * up) : Floats{};
    };
    ambient(radiance.x, shading.baseColor.x, view.ambientGround.x, view.ambientSky.x);
    ambient(radiance.y, shading.baseColor.y, view.ambientGround.y, view.ambientSky.y);
    ambient(radiance.z, shading.baseColor.z, view.ambientGround.z, view.ambientSky.z);
    addLights(row, x, s, radiance);
    return radiance;
}

inline void shadeRowOf(const ShadeRow& row) {
    const Floats3 background = of(row.view->background);
    for (int x = 0; x < row.width; x += kLanes) {
        const Ints seen =
            (load<Floats>(row.depths + x) != row.view->emptyDepth) & (kCount + float(x) < float(row.width));
        Floats3 radiance = background;
        Floats alpha = Floats{} + row.view->background.w;
        if (any(seen)) {
            const Floats3 shaded = shadePixels(row, x, seen);
            radiance = {seen ? shaded.x : radiance.x, seen ? shaded.y : radiance.y, seen ? shaded.z : radiance.z};
            alpha = seen ? Floats{} + 1.0f : alpha;
        }
        const int count = row.width - x < kLanes ? row.width - x : kLanes;
        for (int i = 0; i < count; ++i) {
            float* out = row.radiance + 4 * (x + i);
            out[0] = radiance.x[i];
            out[1] = radiance.y[i];
            out[2] = radiance.z[i];
            out[3] = alpha[i];
        }
    }
}

}  // namespace
}  // namespace umbrage
