// SPDX-License-Identifier: Apache-2.0
// Silhouettes on the host, as engines did before programmable hardware (and Doom 3 and OGRE after it): the reference
// for the device's techniques and the baseline they are measured against. Positions of what deforms are read back,
// because they are computed on the device only. Same expressions in the same order as facing.comp and edges.comp.
#include <algorithm>
#include <array>
#include <cmath>

#include "shadow/sides.h"

namespace umbrage {
namespace {

/// As in shaders/caster_lists.glsl.
bool mayHoldFarEnds(const gpu::InstanceData& instance, const gpu::CasterState& caster, std::uint32_t l) {
    return instance.eyeInModel.w == 0.0f && endOfVolume(caster, l) == 0;
}

/// d.(a x b); see determinant3() in facing.comp.glsl.
double determinant3(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b, glm::dvec3& n) {
    n = glm::cross(a, b);
    return d.x * n.x + d.y * n.y + d.z * n.z;
}

bool isRounding(double det, const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 sizes(std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
                           std::abs(a.x * b.y) + std::abs(a.y * b.x));
    return std::abs(det) < 1e-14 * glm::dot(glm::abs(d), sizes);
}

/// Sign of det[d, a, b]; see exactSign() in facing.comp.glsl.
int exactSign(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b, bool& undecided) {
    glm::dvec3 n;
    const double det = determinant3(d, a, b, n);
    if (det != 0.0) {
        undecided = undecided || isRounding(det, d, a, b);
        return det > 0.0 ? 1 : -1;
    }
    for (int i = 0; i < 3; ++i) {
        if (n[i] != 0.0) return n[i] > 0.0 ? 1 : -1;
    }
    return -1;
}

bool crosses(const glm::dvec3& origin, const glm::dvec3& d, const std::array<glm::vec3, 3>& v, bool& undecided) {
    int sign[3];
    for (int i = 0; i < 3; ++i) {
        sign[i] = exactSign(d, glm::dvec3(v[i]) - origin, glm::dvec3(v[(i + 1) % 3]) - origin, undecided);
    }
    return sign[0] == sign[1] && sign[1] == sign[2];
}

float sideOf(const glm::vec3& n, const glm::vec3& a, const glm::vec4& p) {
    const glm::vec3 d = glm::vec3(p) - p.w * a;
    return n.x * d.x + n.y * d.y + n.z * d.z;
}

/// See facing.comp.glsl.
float sideOfNearLight(const std::array<glm::vec3, 3>& t, const glm::dvec3& light) {
    const glm::dvec3 a(t[0]), u = glm::dvec3(t[1]) - a, v = glm::dvec3(t[2]) - a, d = light - a;
    glm::dvec3 n;
    const double side = determinant3(d, u, v, n);
    return isRounding(side, d, u, v) ? 0.0f : float(glm::sign(side));
}

bool inBoxOf(const std::array<glm::vec3, 3>& t, const glm::vec4& light) {
    const glm::vec3 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2])), l(light);
    return light.w != 0.0f && glm::all(glm::greaterThanEqual(l, low)) && glm::all(glm::lessThanEqual(l, high));
}

/// See edges.comp.glsl.
bool inWedge(const glm::vec4& eye, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 l(light), p(eye);
    const glm::vec3 e = eye.w == 0.0f ? p : light.w == 0.0f ? p - a : p - l;
    const glm::vec3 u = light.w == 0.0f ? b - a : a - l, v = light.w == 0.0f ? -l : b - l;
    const glm::vec3 n = glm::cross(u, v);
    const float squared = glm::dot(n, n);
    constexpr float kMargin = 0x1p-6f;
    const float alongU = glm::dot(glm::cross(e, v), n) / squared;
    const float alongV = glm::dot(glm::cross(u, e), n) / squared;
    if (eye.w == 0.0f) {
        return alongU * glm::length(u) > -kMargin * glm::length(e) &&
               alongV * glm::length(v) > -kMargin * glm::length(e);
    }
    if (light.w == 0.0f) {
        return alongU > -kMargin && alongU < 1.0f + kMargin &&
               alongV * glm::length(v) > -kMargin * (glm::length(u) + glm::length(e));
    }
    return alongU > -kMargin && alongV > -kMargin && alongU + alongV > 1.0f - kMargin;
}

/// T4; see edges.comp.glsl.
bool hazardous(const glm::vec4& start, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    if (start.w == 0.0f && light.w == 0.0f) return false;
    const glm::vec3 l(light), p(start);
    const glm::vec3 e = start.w == 0.0f ? p : light.w == 0.0f ? p - a : p - l;
    const glm::vec3 n = light.w == 0.0f ? glm::cross(b - a, -l) : glm::cross(a - l, b - l);
    const float scale =
        start.w == 0.0f ? glm::length(e) : std::max({glm::length(e), glm::distance(p, a), glm::distance(p, b)});
    return std::abs(glm::dot(n, e)) < float(HAZARD) * scale * glm::length(n) && inWedge(start, light, a, b);
}

/// T4 for caps; see facing.comp.glsl.
bool eyeIsOn(const glm::vec4& homogeneousEye, const glm::vec3& n, const std::array<glm::vec3, 3>& t) {
    if (homogeneousEye.w == 0.0f) return false;
    const glm::vec3 eye(homogeneousEye);
    const float near =
        float(HAZARD) * std::max({glm::distance(eye, t[0]), glm::distance(eye, t[1]), glm::distance(eye, t[2])});
    const glm::vec3 low = glm::min(t[0], glm::min(t[1], t[2])) - near;
    const glm::vec3 high = glm::max(t[0], glm::max(t[1], t[2])) + near;
    return std::abs(sideOf(n, t[0], homogeneousEye)) <= near * glm::length(n) &&
           glm::all(glm::greaterThanEqual(eye, low)) && glm::all(glm::lessThanEqual(eye, high));
}

/// See edges.comp.glsl.
bool isSliver(const glm::vec4& eye, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 l = light.w == 0.0f ? glm::vec3(light) : glm::vec3(light) - a;
    const glm::vec3 e = eye.w == 0.0f ? glm::vec3(eye) : glm::vec3(eye) - a;
    return std::abs(glm::dot(glm::cross(b - a, l), e)) <
           float(EDGE_ON_SINE) * glm::length(b - a) * glm::length(l) * glm::length(e);
}

/// See edges.comp.glsl.
bool endsInQuad(const glm::vec4& end, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    if (end.w == 0.0f && light.w == 0.0f) return false;
    const glm::vec3 n = glm::cross(b - a, light.w == 0.0f ? glm::vec3(light) : glm::vec3(light) - a);
    const glm::vec3 e = end.w == 0.0f ? glm::vec3(end) : glm::vec3(end) - a;
    return std::abs(glm::dot(n, e)) < float(IN_LINE_SINE) * glm::length(n) * glm::length(e) &&
           inWedge(end, light, a, b);
}

/// See facing.comp.glsl.
bool isOver(const glm::vec4& end, const glm::vec4& light, float lightSide, const std::array<glm::vec3, 3>& v,
            const glm::vec3& n, bool& undecided) {
    const bool orthographic = end.w == 0.0f;
    if (orthographic && light.w == 0.0f) return false;
    const float endSide = sideOf(n, v[0], end);
    if (endSide == 0.0f || (endSide > 0.0f) == (lightSide > 0.0f)) return false;
    const glm::dvec3 e(end), p(light);
    return orthographic ? crosses(p, e, v, undecided) : crosses(e, p - double(light.w) * e, v, undecided);
}

class CpuSilhouettes : public SilhouetteTechnique {
public:
    std::string_view name() const override { return "cpu"; }
    SideShaders sideShaders() const override { return ListedSides::shaders(); }
    void drawSides(const SideList& sides, const gpu::Program&) override { sides_.draw(sides); }

    void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
               Silhouettes& out) override {
        if (positions_.empty() || geometry.deforms()) positions_ = geometry.readPositions();
        facing_.assign(geometry.placedTriangleCount(), gpu::uvec2(0));
        planes_.assign(geometry.placedTriangleCount(), gpu::vec4(0.0f));
        entries_.assign(std::size_t(group.count) * LIST_COUNT, {});
        if (out.parts) out.parts->read();  // their planes are made on the device
        for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
            faceTriangles(geometry, i, group, out);
            findEdges(geometry, i, group, options.halve, out);
        }
        upload(group, out);
    }

private:
    glm::vec3 position(std::uint32_t vertex) const {
        return {positions_[3 * vertex], positions_[3 * vertex + 1], positions_[3 * vertex + 2]};
    }
    static const glm::vec4& lightOf(const Silhouettes& out, std::uint32_t instance, const LightGroup& group,
                                    std::uint32_t l) {
        return out.hostLightsInModel[std::size_t(instance) * out.totalLights + group.first + l];
    }

    void faceTriangles(const Geometry& geometry, std::uint32_t i, const LightGroup& group, Silhouettes& out);
    void countEye(const gpu::InstanceData& instance, const glm::vec4& light, float lightSide,
                  const std::array<glm::vec3, 3>& v, const glm::vec3& n, std::uint32_t list, std::uint32_t l,
                  gpu::LightSummary& summary, gpu::CasterState& caster) const;
    void countEnds(const glm::vec4& eye, bool bothEnds, const glm::vec4& light, float lightSide,
                   const std::array<glm::vec3, 3>& v, const glm::vec3& n, gpu::LightSummary& summary,
                   gpu::SplitPart& part) const;
    void appendAll(const Geometry& geometry, std::uint32_t i, std::uint32_t k, const LightGroup& group, bool halve,
                   const gpu::uvec2& left, const gpu::uvec2& right, std::uint32_t flags, Silhouettes& out);
    bool findHazards(const gpu::InstanceData& instance, std::uint32_t i, std::uint32_t l, std::uint32_t list,
                     const gpu::Edge& edge, std::uint32_t flags, const glm::vec4& light, const glm::vec3& a,
                     const glm::vec3& b, Silhouettes& out) const;
    void findEdges(const Geometry& geometry, std::uint32_t i, const LightGroup& group, bool halve, Silhouettes& out);
    void upload(const LightGroup& group, Silhouettes& out);

    std::vector<float> positions_;
    std::vector<gpu::uvec2> facing_;
    std::vector<gpu::vec4> planes_;
    std::vector<std::vector<std::uint32_t>> entries_;  // light-major, LIST_COUNT lists each
    ListedSides sides_;
};

void CpuSilhouettes::faceTriangles(const Geometry& geometry, std::uint32_t i, const LightGroup& group,
                                   Silhouettes& out) {
    const gpu::InstanceData& instance = geometry.instances()[i];
    // A chunk at a time in structures of arrays, so that the compiler makes SIMD of the inner loop.
    std::array<float, CHUNK_SIZE> ax, ay, az, nx, ny, nz, side;
    std::array<std::array<glm::vec3, 3>, CHUNK_SIZE> corners;
    std::array<bool, CHUNK_SIZE> underEye;
    for (std::uint32_t first = 0; first < instance.triangleCount; first += CHUNK_SIZE) {
        const std::uint32_t count = std::min<std::uint32_t>(CHUNK_SIZE, instance.triangleCount - first);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t* index = &geometry.indices()[3 * (instance.triangleBase + first + k)];
            for (std::uint32_t c = 0; c < 3; ++c) corners[k][c] = position(instance.vertexBase + index[c]);
            const glm::vec3 a = corners[k][0], u = corners[k][1] - a, v = corners[k][2] - a;
            ax[k] = a.x, ay[k] = a.y, az[k] = a.z;
            nx[k] = u.y * v.z - u.z * v.y;
            ny[k] = u.z * v.x - u.x * v.z;
            nz[k] = u.x * v.y - u.y * v.x;
            const glm::vec3 n(nx[k], ny[k], nz[k]);
            underEye[k] = eyeIsOn(instance.eyeInModel, n, corners[k]);
            glm::vec3 normal, inView;
            for (int r = 0; r < 3; ++r) {
                normal[r] = glm::dot(glm::vec3(instance.normalFromModel[r]), n);
                inView[r] = glm::dot(instance.viewFromModel[r], glm::vec4(a, 1.0f));
            }
            normal /= std::max(glm::length(normal), 1e-37f);
            planes_[instance.placedTriangleBase + first + k] = {normal, -glm::dot(normal, inView)};
        }
        for (std::uint32_t l = 0; l < group.count; ++l) {
            if ((out.hostCasters[i].outOfReach | out.hostCasters[i].outOfView) >> l & 1u) continue;
            const glm::vec4 light = lightOf(out, i, group, l);
            for (std::uint32_t k = 0; k < count; ++k) {
                const float dx = light.x - light.w * ax[k], dy = light.y - light.w * ay[k],
                            dz = light.z - light.w * az[k];
                side[k] = nx[k] * dx + ny[k] * dy + nz[k] * dz;
            }
            gpu::LightSummary& summary = out.hostSummaries[l];
            for (std::uint32_t k = 0; k < count; ++k) {
                const std::uint32_t flags = geometry.triangleFlags()[instance.triangleBase + first + k];
                const bool near = inBoxOf(corners[k], light);
                if (near) side[k] = sideOfNearLight(corners[k], glm::dvec3(light));
                const bool front = side[k] > 0.0f;
                const bool back = side[k] < 0.0f || (!front && !near && (flags & TRIANGLE_EVEN));
                if (!front && !back && near) out.hostCasters[i].lightOn |= 1u << l;
                gpu::uvec2& bits = facing_[instance.placedTriangleBase + first + k];
                bits.x |= std::uint32_t(front) << l;
                bits.y |= std::uint32_t(back) << l;
                if (!(flags & TRIANGLE_CASTS) || !(front || back)) continue;
                summary.litTriangles += front;
                const gpu::CasterState& state = out.hostCasters[i];
                const bool fail = out.parts || (state.countedByFail >> l & 1u);  // by parts: somewhere
                summary.lightCaps += fail || (flags & TRIANGLE_HOLED) || state.missing;
                const bool apart = light.w != 0.0f && instance.eyeInModel.w != 0.0f;
                summary.darkCaps += fail && (apart || endOfVolume(state, l) != 0);
                const std::uint32_t list = listOf(instance, out.hostCasters[i], l, flags & TRIANGLE_EVEN);
                const glm::vec3 n(nx[k], ny[k], nz[k]);
                if (out.parts) {
                    gpu::SplitPart& part =
                        out.parts->host[out.parts->partOf(instance.placedTriangleBase + first + k, l)];
                    if (underEye[k]) part.hazards |= 1u << SPLIT_PASS;
                    const bool bothEnds = mayHoldFarEnds(instance, state, l);
                    countEnds(instance.eyeInModel, bothEnds, light, side[k], corners[k], n, summary, part);
                    continue;
                }
                if (underEye[k] && list != LIST_FAIL) out.hostCasters[i].hazards |= 1u << l;
                countEye(instance, light, side[k], corners[k], n, list, l, summary, out.hostCasters[i]);
            }
        }
    }
}

void CpuSilhouettes::countEye(const gpu::InstanceData& instance, const glm::vec4& light, float lightSide,
                              const std::array<glm::vec3, 3>& v, const glm::vec3& n, std::uint32_t list,
                              std::uint32_t l, gpu::LightSummary& summary, gpu::CasterState& caster) const {
    glm::vec4 eye = instance.eyeInModel;
    if (list == LIST_FAIL) {
        if (!mayHoldFarEnds(instance, caster, l)) return;
        eye = -eye;
    }
    bool undecided = false;
    summary.eyeInside[list] += isOver(eye, light, lightSide, v, n, undecided);
    if (undecided) caster.hazards |= 1u << l;
}

void CpuSilhouettes::countEnds(const glm::vec4& eye, bool bothEnds, const glm::vec4& light, float lightSide,
                               const std::array<glm::vec3, 3>& v, const glm::vec3& n, gpu::LightSummary& summary,
                               gpu::SplitPart& part) const {
    for (std::uint32_t end = SPLIT_PASS; end <= (bothEnds ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        bool undecided = false;
        const bool over = isOver(end == SPLIT_PASS ? eye : -eye, light, lightSide, v, n, undecided);
        part.eyeInside[end] += over;
        if (end == SPLIT_PASS) summary.eyeInside[LIST_WHOLE] += over;
        if (undecided) part.hazards |= 1u << end;
    }
}

void CpuSilhouettes::findEdges(const Geometry& geometry, std::uint32_t i, const LightGroup& group, bool halve,
                               Silhouettes& out) {
    const gpu::InstanceData& instance = geometry.instances()[i];
    const gpu::uvec2* facing = &facing_[instance.placedTriangleBase];
    const auto traversals = [&](std::uint32_t triangle) {
        const gpu::uvec2 bits = facing[triangle & EDGE_TRIANGLE];
        return triangle & EDGE_REVERSED ? gpu::uvec2(bits.y, bits.x) : bits;
    };
    for (std::uint32_t k = 0; k < instance.edgeCount; ++k) {
        const gpu::Edge& edge = geometry.edges()[instance.edgeBase + k];
        const gpu::uvec2 left = traversals(edge.left);
        const gpu::uvec2 right = edge.right == EDGE_NONE ? gpu::uvec2(0) : traversals(edge.right);
        std::uint32_t apart = 0;  // lights for which it is an edge of two parts, with one triangle in each
        for (std::uint32_t l = 0; out.parts && edge.right != EDGE_NONE && l < group.count; ++l) {
            const auto partOf = [&](std::uint32_t triangle) {
                return out.parts->partOf(instance.placedTriangleBase + (triangle & EDGE_TRIANGLE), l);
            };
            apart |= std::uint32_t(partOf(edge.left) != partOf(edge.right)) << l;
        }
        appendAll(geometry, i, k, group, halve, left & gpu::uvec2(~apart), right & gpu::uvec2(~apart), 0, out);
        if (apart == 0) continue;
        appendAll(geometry, i, k, group, halve, left & gpu::uvec2(apart), gpu::uvec2(0), 0, out);
        appendAll(geometry, i, k, group, halve, right & gpu::uvec2(apart), gpu::uvec2(0), QUAD_OF_RIGHT, out);
    }
}

void CpuSilhouettes::appendAll(const Geometry& geometry, std::uint32_t i, std::uint32_t k, const LightGroup& group,
                               bool halve, const gpu::uvec2& left, const gpu::uvec2& right, std::uint32_t flags,
                               Silhouettes& out) {
    const gpu::InstanceData& instance = geometry.instances()[i];
    const gpu::Edge& edge = geometry.edges()[instance.edgeBase + k];
    const gpu::uvec2 twice = left & right, both = left | right;
    const gpu::uvec2 once = (left ^ right) & ~gpu::uvec2(both.y, both.x);
    const std::uint32_t silhouette = twice.x | twice.y | once.x | once.y;
    for (std::uint32_t l = 0; silhouette != 0 && l < group.count; ++l) {
        if (!(silhouette >> l & 1u)) continue;
        const bool negative = (twice.y | once.y) >> l & 1u;
        const bool isTwice = (twice.x | twice.y) >> l & 1u;
        std::uint32_t list = listOf(instance, out.hostCasters[i], l, edge.left & EDGE_EVEN);
        // Of an even component only another part has the rest.
        if (out.parts && list == LIST_HALVED && !isTwice) list = LIST_WHOLE;
        const int times = isTwice && !(halve && list == LIST_HALVED) ? 2 : 1;
        const std::uint32_t entry = (instance.placedEdgeBase + k) << 1 | std::uint32_t(negative) | flags;
        const glm::vec4 eye = instance.eyeInModel, light = lightOf(out, i, group, l);
        const glm::vec3 a = position(instance.vertexBase + edge.a), b = position(instance.vertexBase + edge.b);
        if (!findHazards(instance, i, l, list, edge, flags, light, a, b, out)) continue;
        std::vector<std::uint32_t>& entries =
            entries_[l * LIST_COUNT + list + (isSliver(eye, light, a, b) ? LIST_EDGE_ON : 0)];
        entries.insert(entries.end(), std::size_t(times), entry);
        ++out.hostSummaries[l].silhouetteEdges;
        out.hostSummaries[l].doubleEdges += isTwice;
    }
}

bool CpuSilhouettes::findHazards(const gpu::InstanceData& instance, std::uint32_t i, std::uint32_t l,
                                 std::uint32_t list, const gpu::Edge& edge, std::uint32_t flags, const glm::vec4& light,
                                 const glm::vec3& a, const glm::vec3& b, Silhouettes& out) const {
    const glm::vec4 eye = instance.eyeInModel;
    const bool fail = list == LIST_FAIL, farEnds = mayHoldFarEnds(instance, out.hostCasters[i], l);
    if (!out.parts) {
        if ((fail || eye.w == 0.0f) && endsInQuad(fail ? eye : -eye, light, a, b)) return false;
        if ((!fail || farEnds) && hazardous(fail ? -eye : eye, light, a, b)) {
            out.hostCasters[i].hazards |= 1u << l;
        }
        return true;
    }
    const std::uint32_t triangle = (flags & QUAD_OF_RIGHT ? edge.right : edge.left) & EDGE_TRIANGLE;
    gpu::SplitPart& part = out.parts->host[out.parts->partOf(instance.placedTriangleBase + triangle, l)];
    bool drawn = true;
    for (std::uint32_t end = SPLIT_PASS; end <= (farEnds ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        const glm::vec4 there = end == SPLIT_PASS ? eye : -eye;
        if (hazardous(there, light, a, b)) part.hazards |= 1u << end;
        const bool needed = end == SPLIT_FAIL && (out.hostCasters[i].lightMoved >> l & 1u);  // see edge_sweep.glsl
        if (!needed && endsInQuad(there, light, a, b)) drawn = false;
    }
    return drawn;
}

void CpuSilhouettes::upload(const LightGroup& group, Silhouettes& out) {
    for (std::uint32_t list = 0; list < group.count * LIST_COUNT; ++list) {
        out.hostSummaries[list / LIST_COUNT].lists[list % LIST_COUNT].count = std::uint32_t(6 * entries_[list].size());
    }
    ListedSides::upload(entries_, out);
    out.summaries.write(std::span<const gpu::LightSummary>(out.hostSummaries));
    out.casters.write(std::span<const gpu::CasterState>(out.hostCasters));
    if (out.parts) out.parts->upload();
    out.facing.write(out.facingBase(group) * sizeof(gpu::uvec2), facing_.size() * sizeof(gpu::uvec2), facing_.data());
    out.planes.write(std::span<const gpu::vec4>(planes_));
}

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeCpuSilhouettes() {
    return std::make_unique<CpuSilhouettes>();
}

}  // namespace umbrage
