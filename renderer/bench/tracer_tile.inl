// SPDX-License-Identifier: Apache-2.0
// See tracer_tile.h. Included by one file for each instruction set. Nothing here may come from the standard library:
// the linker keeps one copy of what several files instantiate.
//
// The formulas are those of shaders/resolve.frag.glsl, lights.glsl and brdf.glsl (glTF 2.0, appendix B;
// KHR_lights_punctual), for sixteen pixels at once.

#include "shading/lit_lanes.inl"

namespace umbrage {
namespace {

constexpr int kPacketSide = 4;
constexpr Floats kColumn{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
constexpr Floats kRow{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
constexpr std::int32_t kFrontSeen = std::int32_t(kTracerFrontSeen), kBackSeen = std::int32_t(kTracerBackSeen);

/// Of a packet: where it is, and what is seen there.
struct Packet {
    Ints inside, hit;  // of the picture; of a triangle
    Floats3 direction, p;
    Floats distance;
    Floats3 facing;  // of the seen side's plane, towards the viewer; any length
    Ints front;
    Ints triangle, traits;
    Floats u, v;
};

/// Tells Embree's callback which triangles the viewer sees.
struct SeenFilter {
    RTCIntersectContext context;  // first: Embree hands back a pointer to it
    const std::uint32_t* traits;
};

inline bool isSeen(std::uint32_t traits, float towards) {
    return (traits & (towards < 0.0f ? kTracerFrontSeen : kTracerBackSeen)) != 0u;
}

/// Rejects culled faces. Only where one was met first, so that others pay nothing.
inline void rejectUnseen(const RTCFilterFunctionNArguments* a) {
    const std::uint32_t* traits = reinterpret_cast<const SeenFilter*>(a->context)->traits;
    for (unsigned i = 0; i < a->N; ++i) {
        if (!a->valid[i]) continue;
        const float towards = RTCHitN_Ng_x(a->hit, a->N, i) * RTCRayN_dir_x(a->ray, a->N, i) +
                              RTCHitN_Ng_y(a->hit, a->N, i) * RTCRayN_dir_y(a->ray, a->N, i) +
                              RTCHitN_Ng_z(a->hit, a->N, i) * RTCRayN_dir_z(a->ray, a->N, i);
        if (!isSeen(traits[RTCHitN_primID(a->hit, a->N, i)], towards)) a->valid[i] = 0;
    }
}

inline void setRays(RTCRay16& rays, const Floats3& origin, const Floats3& direction, const Floats& near,
                    const Floats& far) {
    store(rays.org_x, origin.x);
    store(rays.org_y, origin.y);
    store(rays.org_z, origin.z);
    store(rays.dir_x, direction.x);
    store(rays.dir_y, direction.y);
    store(rays.dir_z, direction.z);
    store(rays.tnear, near);
    store(rays.tfar, far);
    store(rays.time, Floats{});
    store(rays.mask, Ints{} - 1);
    store(rays.flags, Ints{});
}

/// The nearest seen triangle at each pixel.
inline void see(const TracerFrame& frame, int left, int top, Packet& packet) {
    const Floats x = kColumn + float(left), y = kRow + float(top);
    packet.inside = (x < float(frame.width)) & (y < float(frame.height));
    packet.direction = spread(frame.direction) + x * spread(frame.directionRight) + y * spread(frame.directionDown);
    const Floats3 origin = spread(frame.origin) + x * spread(frame.originRight) + y * spread(frame.originDown);
    RTCRayHit16 rays;
    SeenFilter filter;
    filter.traits = frame.traits;
    rtcInitIntersectContext(&filter.context);
    filter.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    Ints wanted = packet.inside;
    Floats3 normal;
    for (bool again = false;; again = true) {
        const Ints before = again ? load<Ints>(rays.hit.primID) : Ints{};
        const Floats farBefore = again ? load<Floats>(rays.ray.tfar) : Floats{};
        setRays(rays.ray, origin, packet.direction, Floats{} + frame.near,
                again ? (wanted ? Floats{} + frame.far : farBefore) : Floats{} + frame.far);
        store(rays.hit.geomID, again ? (wanted ? Ints{} - 1 : load<Ints>(rays.hit.geomID)) : Ints{} - 1);
        store(rays.hit.instID[0], Ints{} - 1);
        store(rays.hit.primID, before);
        rtcIntersect16(reinterpret_cast<const int*>(&wanted), frame.scene, &filter.context, &rays);
        packet.hit = packet.inside & (load<Ints>(rays.hit.geomID) != -1);
        normal = {load<Floats>(rays.hit.Ng_x), load<Floats>(rays.hit.Ng_y), load<Floats>(rays.hit.Ng_z)};
        const Ints triangle = packet.hit ? load<Ints>(rays.hit.primID) : Ints{};
        packet.triangle = triangle;
        packet.front = dot(normal, packet.direction) < 0.0f;
        packet.traits = gather<Ints>(frame.traits, triangle);
        if (again) break;
        wanted = packet.hit & ((packet.traits & (packet.front ? Ints{} + kFrontSeen : Ints{} + kBackSeen)) == 0);
        if (!any(wanted)) break;
        filter.context.filter = rejectUnseen;
    }
    packet.distance = packet.hit ? load<Floats>(rays.ray.tfar) : Floats{};
    packet.p = origin + packet.distance * packet.direction;
    packet.facing = (packet.front ? Floats{} + 1.0f : Floats{} - 1.0f) * normal;
    packet.u = load<Floats>(rays.hit.u);
    packet.v = load<Floats>(rays.hit.v);
}

/// The normal that is shaded: of the seen side, interpolated or of the plane.
inline Floats3 shadingNormal(const TracerFrame& frame, const Packet& packet, const Ints& flat) {
    const Floats3 plane = unit(packet.facing);
    if (!any(~flat)) return plane;
    const auto normalOf = [&](int corner) {
        const Ints vertex = gather<Ints>(frame.vertices + corner, 3 * packet.triangle);
        return gather3(frame.normals, 3 * vertex);
    };
    const Floats side = packet.front ? Floats{} + 1.0f : Floats{} - 1.0f;
    const Floats3 n = (side * (1.0f - packet.u - packet.v)) * normalOf(0) + (side * packet.u) * normalOf(1) +
                      (side * packet.v) * normalOf(2);
    const Floats size = dot(n, n);
    const Ints flatHere = flat | (size == 0.0f);
    const Floats scale = 1.0f / root(size);
    return {flatHere ? plane.x : scale * n.x, flatHere ? plane.y : scale * n.y, flatHere ? plane.z : scale * n.z};
}

/// Lanes of `wanted` whose way to the light is free.
inline Ints unoccluded(const TracerFrame& frame, const Packet& packet, const Ints& wanted, const Floats3& way,
                       const Floats& inverseLength, bool endless) {
    RTCRay16 rays;
    const Floats size =
        larger(larger(magnitude(packet.p.x), magnitude(packet.p.y)), larger(magnitude(packet.p.z), packet.distance));
    setRays(rays, packet.p, way, frame.offset * size * inverseLength, Floats{} + (endless ? kInfinity : 1.0f));
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(reinterpret_cast<const int*>(&wanted), frame.scene, &context, &rays);
    return wanted & (load<Floats>(rays.tfar) >= 0.0f);
}

/// Adds what a light does to the packet.
inline void addLight(const TracerFrame& frame, int number, const Packet& packet, const Ints& lit, const Shading& s,
                     int left, int top, Floats3& radiance) {
    const TracerLight& light = frame.lights[number];
    const Floats3 place = spread(light.position);
    Floats3 way = place, l = place;
    Floats strength = Floats{} + light.intensity, inverseLength = Floats{} + 1.0f;
    if (light.w != 0.0f) {
        way = {place.x - packet.p.x, place.y - packet.p.y, place.z - packet.p.z};
        const Floats d2 = larger(dot(way, way), Floats{} + 1e-12f);
        inverseLength = 1.0f / root(d2);
        l = inverseLength * way;
        const Floats ratio = d2 * light.inverseRange2;
        const Floats window = larger(1.0f - ratio * ratio, Floats{});
        const Floats cone = within01(light.coneOffset - light.coneScale * dot(spread(light.direction), l));
        strength *= window * cone * cone * inverseLength * inverseLength;
    }
    const Floats nl = dot(s.n, l);
    // A light that the shading normal turns away from adds nothing: only a mask wants to know its shadow there.
    Ints reaching = lit & (dot(packet.facing, way) > 0.0f) & (strength > 0.0f);
    if (!frame.reaches) reaching &= nl > 0.0f;
    if (!any(reaching)) return;
    if (frame.shadows) {
        reaching = unoccluded(frame, packet, reaching, way, inverseLength, light.w == 0.0f);
        if (!any(reaching)) return;
    }
    if (frame.reaches) {
        std::uint8_t* plane =
            frame.reaches + std::size_t(number) * std::size_t(frame.width) * std::size_t(frame.height);
        for (int i = 0; i < kLanes; ++i) {
            if (reaching[i]) plane[(top + i / kPacketSide) * frame.width + left + i % kPacketSide] = 1;
        }
    }
    const Floats3 reflected = reflectance(s, l, nl);
    const Floats weight = reaching & (nl > 0.0f) ? strength : Floats{};
    const auto add = [&](Floats& sum, const Floats& value, float color) {
        sum += weight > 0.0f ? weight * color * value : Floats{};
    };
    add(radiance.x, reflected.x, light.color[0]);
    add(radiance.y, reflected.y, light.color[1]);
    add(radiance.z, reflected.z, light.color[2]);
}

inline Floats3 shade(const TracerFrame& frame, const Packet& packet, int left, int top) {
    const Ints flat = (packet.traits & std::int32_t(kTracerFlat)) != 0;
    constexpr int kStride = sizeof(TracerMaterial) / sizeof(float);
    const Ints material = (packet.traits & std::int32_t(kTracerMaterial)) * kStride;
    const TracerMaterial& first = frame.materials[0];
    Shading s;
    s.n = shadingNormal(frame, packet, flat);
    s.v = unit(packet.direction);
    s.v = {-s.v.x, -s.v.y, -s.v.z};
    s.baseColor = gather3(first.baseColor, material);
    s.metallic = gather<Floats>(&first.metallic, material);
    s.roughness = gather<Floats>(&first.roughness, material);
    const Ints lit = packet.hit & (gather<Floats>(&first.lit, material) > 0.0f);
    const Floats up = 0.5f + 0.5f * s.n.y;
    const Floats3 emissive = gather3(first.emissive, material);
    const auto unshadowed = [&](const Floats& own, const Floats& base, int k) {
        const float ground = frame.ambientGround[k], sky = frame.ambientSky[k];
        return own + (lit ? base * (ground + (sky - ground) * up) : Floats{});
    };
    Floats3 radiance{unshadowed(emissive.x, s.baseColor.x, 0), unshadowed(emissive.y, s.baseColor.y, 1),
                     unshadowed(emissive.z, s.baseColor.z, 2)};
    if (!any(lit)) return radiance;
    float low[3], high[3];
    boundsOf(packet.p, packet.hit, low, high);
    for (int group = 0; group * kLanes < frame.lightCount; ++group) {
        for (std::uint32_t bits = lightsNear(frame.reach[group], low, high); bits != 0u; bits &= bits - 1u) {
            addLight(frame, group * kLanes + __builtin_ctz(bits), packet, lit, s, left, top, radiance);
        }
    }
    return radiance;
}

inline void tracePacket(const TracerFrame& frame, int left, int top) {
    Packet packet;
    see(frame, left, top, packet);
    Floats3 radiance = spread(frame.background);
    if (any(packet.hit)) {
        const Floats3 shaded = shade(frame, packet, left, top);
        radiance = {packet.hit ? shaded.x : radiance.x, packet.hit ? shaded.y : radiance.y,
                    packet.hit ? shaded.z : radiance.z};
    }
    for (int i = 0; i < kLanes; ++i) {
        if (!packet.inside[i]) continue;
        const std::size_t pixel =
            std::size_t(top + i / kPacketSide) * std::size_t(frame.width) + std::size_t(left + i % kPacketSide);
        float* out = frame.radiance + 4 * pixel;
        out[0] = radiance.x[i];
        out[1] = radiance.y[i];
        out[2] = radiance.z[i];
        out[3] = 1.0f;
        if (frame.seen) frame.seen[pixel] = packet.hit[i] ? std::uint32_t(packet.triangle[i]) : ~0u;
    }
}

inline void traceTileOf(const TracerFrame& frame, int left, int top) {
    for (int y = top; y < top + kTracerTile && y < frame.height; y += kPacketSide) {
        for (int x = left; x < left + kTracerTile && x < frame.width; x += kPacketSide) tracePacket(frame, x, y);
    }
}

}  // namespace
}  // namespace umbrage
