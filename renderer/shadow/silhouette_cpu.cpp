// SPDX-License-Identifier: Apache-2.0
// Silhouettes on the host, as engines did before programmable hardware (and Doom 3 and OGRE after it): the reference
// for the device's techniques, the baseline they are measured against, and, where the device is a processor itself, the
// fastest. Facing bits are made by SIMD over whole meshes; what else can happen to a triangle (an eye constant, a
// hazard, a light that lies on it) is looked for only where its mesh's box says that it may.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

#include "shadow/host_predicates.h"
#include "shadow/host_triangles.h"
#include "shadow/sides.h"

namespace umbrage {
namespace {

/// A stretch of an instance's triangles or edges.
struct Stretch {
    std::uint32_t instance, first, count;
};

/// A quad that was found.
struct Found {
    std::uint32_t entry;  // of a list
    std::uint16_t list;   // LIST_COUNT a light
    std::uint16_t times;
};

/// Whether the part of the line p + t d with t from 0 to `end` comes as near to a box as `margin`.
bool passes(const Geometry::Bounds& box, const glm::dvec3& p, const glm::dvec3& d, double end, double margin) {
    const glm::dvec3 wide(margin);
    double from = 0.0, to = end;
    for (int k = 0; k < 3; ++k) {
        const double low = box.low[k] - wide[k] - p[k], high = box.high[k] + wide[k] - p[k];
        if (d[k] == 0.0) {
            if (low > 0.0 || high < 0.0) return false;
            continue;
        }
        from = std::max(from, std::min(low / d[k], high / d[k]));
        to = std::min(to, std::max(low / d[k], high / d[k]));
    }
    return from <= to;
}

/// What may happen between a light, the ends of view rays and an instance. All bits of lights.
struct Nearness {
    std::uint32_t lightIn = 0;   // the light is in the instance's box
    std::uint32_t lineHits = 0;  // the line from light to eye passes the box
    std::uint32_t lineNear = 0;  // or comes near it, as far as T4 looks
    bool eyeIn = false;          // the eye is in the box
};

class CpuSilhouettes : public SilhouetteTechnique {
public:
    std::string_view name() const override { return "cpu"; }
    bool onHost() const override { return true; }
    SideShaders sideShaders() const override { return ListedSides::shaders(); }
    void drawSides(const SideList& sides, const gpu::Program&) override { sides_.draw(sides); }

    void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
               Silhouettes& out) override;

private:
    /// What one sweep is about.
    struct Sweep {
        const Geometry& geometry;
        const LightGroup& group;
        const SweepOptions& options;
        Silhouettes& out;

        const glm::vec4& light(std::uint32_t instance, std::uint32_t l) const {
            return out.hostLightsInModel[std::size_t(instance) * out.totalLights + group.first + l];
        }
    };
    using Summaries = std::vector<gpu::LightSummary>;

    static void orAtomically(std::uint32_t& to, std::uint32_t bits) {
        if (bits != 0) std::atomic_ref(to).fetch_or(bits, std::memory_order_relaxed);
    }
    Nearness nearnessOf(const Sweep& sweep, std::uint32_t i) const;
    void faceTriangles(const Sweep& sweep, const Stretch& at, Summaries& summaries);
    void lookClosely(const Sweep& sweep, const Stretch& at, std::uint32_t l, Summaries& summaries);
    void countEye(const Sweep& sweep, std::uint32_t i, std::uint32_t l, float lightSide, const TriangleCorners& v,
                  const glm::vec3& n, std::uint32_t list, gpu::LightSummary& summary) const;
    void countEnds(const Sweep& sweep, std::uint32_t i, std::uint32_t l, float lightSide, const TriangleCorners& v,
                   const glm::vec3& n, gpu::LightSummary& summary, gpu::SplitPart& part) const;
    void findEdges(const Sweep& sweep, const Stretch& at, Summaries& summaries, std::vector<Found>& found) const;
    void append(const Sweep& sweep, std::uint32_t i, std::uint32_t k, const gpu::uvec2& left, const gpu::uvec2& right,
                std::uint32_t flags, Summaries& summaries, std::vector<Found>& found) const;
    bool findHazards(const Sweep& sweep, std::uint32_t i, std::uint32_t l, std::uint32_t list, const gpu::Edge& edge,
                     std::uint32_t flags, const glm::vec3& a, const glm::vec3& b) const;
    void upload(const Sweep& sweep);

    std::vector<Stretch> triangleStretches_, edgeStretches_;
    std::vector<Nearness> nearness_;  // per instance
    std::vector<gpu::uvec2> facing_;
    std::vector<gpu::vec4> planes_;
    std::vector<std::vector<Found>> found_;            // per stretch of edges
    std::vector<std::vector<std::uint32_t>> entries_;  // light-major, LIST_COUNT lists each
    ListedSides sides_;
};

std::vector<Stretch> stretches(const Geometry& geometry, std::uint32_t gpu::InstanceData::*countOf) {
    constexpr std::uint32_t kLength = 8 * CHUNK_SIZE;
    std::vector<Stretch> all;
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const std::uint32_t count = geometry.instances()[i].*countOf;
        for (std::uint32_t first = 0; first < count; first += kLength) {
            all.push_back({i, first, std::min(kLength, count - first)});
        }
    }
    return all;
}

void CpuSilhouettes::sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                           Silhouettes& out) {
    const Sweep sweep{geometry, group, options, out};
    if (triangleStretches_.empty()) {
        triangleStretches_ = stretches(geometry, &gpu::InstanceData::triangleCount);
        edgeStretches_ = stretches(geometry, &gpu::InstanceData::edgeCount);
        found_.resize(edgeStretches_.size());
        nearness_.resize(geometry.instanceCount());
    }
    facing_.assign(geometry.placedTriangleCount(), gpu::uvec2(0));
    planes_.assign(geometry.placedTriangleCount(), gpu::vec4(0.0f));
    if (out.parts) out.parts->read();  // their planes are made on the device
    // Lists come out in the same order whatever thread fills them, and sums have none. Parts are summed up as they are.
    tbb::enumerable_thread_specific<Summaries> summaries(Summaries(group.count));
    const auto forAll = [&](std::size_t count, const auto& visit) {
        if (out.parts) {
            for (std::size_t k = 0; k < count; ++k) visit(k);
        } else {
            tbb::parallel_for(std::size_t(0), count, visit);
        }
    };
    forAll(nearness_.size(), [&](std::size_t i) { nearness_[i] = nearnessOf(sweep, std::uint32_t(i)); });
    forAll(triangleStretches_.size(),
           [&](std::size_t k) { faceTriangles(sweep, triangleStretches_[k], summaries.local()); });
    forAll(edgeStretches_.size(), [&](std::size_t k) {
        found_[k].clear();
        if (!options.edges) return;
        findEdges(sweep, edgeStretches_[k], summaries.local(), found_[k]);
    });
    for (const Summaries& some : summaries) {
        for (std::uint32_t l = 0; l < group.count; ++l) {
            gpu::LightSummary& summary = out.hostSummaries[l];
            for (std::size_t list = 0; list < LIST_KINDS; ++list) summary.eyeInside[list] += some[l].eyeInside[list];
            summary.litTriangles += some[l].litTriangles;
            summary.silhouetteEdges += some[l].silhouetteEdges;
            summary.doubleEdges += some[l].doubleEdges;
            summary.lightCaps += some[l].lightCaps;
            summary.darkCaps += some[l].darkCaps;
        }
    }
    upload(sweep);
}

Nearness CpuSilhouettes::nearnessOf(const Sweep& sweep, std::uint32_t i) const {
    // Of sizes and distances. The latter: twice the margins of the wedge in host_predicates.
    constexpr double kRounding = 1e-4, kWedge = 0x1p-5;
    Nearness near;
    const Geometry::Bounds& box = sweep.out.hostTriangles.box(i);
    const glm::dvec4 eye(sweep.geometry.instances()[i].eyeInModel);
    const auto distance = [&](const glm::dvec4& p) {
        return p.w == 0.0 ? 0.0 : glm::distance(0.5 * (box.low + box.high), glm::dvec3(p));
    };
    const double reach = distance(eye) + glm::length(box.high - box.low);
    const auto holds = [&](const glm::dvec3& p) {
        return passes(box, p, glm::dvec3(1.0, 0.0, 0.0), 0.0, kRounding * reach);
    };
    near.eyeIn = eye.w != 0.0 && holds(glm::dvec3(eye));
    for (std::uint32_t l = 0; l < sweep.group.count; ++l) {
        const glm::dvec4 light(sweep.light(i, l));
        if (light.w != 0.0 && holds(glm::dvec3(light))) near.lightIn |= 1u << l;
        if (eye.w == 0.0 && light.w == 0.0) continue;
        // An orthographic eye has two ends.
        const glm::dvec3 from(eye.w != 0.0 ? eye : light),
            along(eye.w != 0.0 ? glm::dvec3(light - light.w * eye) : glm::dvec3(eye));
        const double end = eye.w != 0.0 && light.w != 0.0 ? 1.0 : HUGE_VAL;
        const auto meets = [&](double share) {
            const double margin = share * (reach + distance(light));
            return passes(box, from, along, end, margin) || (eye.w == 0.0 && passes(box, from, -along, end, margin));
        };
        if (meets(kRounding)) near.lineHits |= 1u << l;
        if (meets(kWedge)) near.lineNear |= 1u << l;
    }
    return near;
}

void CpuSilhouettes::faceTriangles(const Sweep& sweep, const Stretch& at, Summaries& summaries) {
    const auto& [geometry, group, options, out] = sweep;
    const gpu::InstanceData& instance = geometry.instances()[at.instance];
    const gpu::CasterState& caster = out.hostCasters[at.instance];
    const std::uint32_t placed = instance.placedTriangleBase + at.first;
    sweep.out.hostTriangles.planes(instance, at.instance, at.first, at.count, &planes_[placed]);
    std::array<std::uint32_t, 8 * CHUNK_SIZE> front{}, back{};
    const std::uint32_t skipped = caster.outOfReach | caster.outOfView;
    for (std::uint32_t l = 0; l < group.count; ++l) {
        if ((skipped >> l & 1u) != 0) continue;
        out.hostTriangles.face(at.instance, at.first, at.count, sweep.light(at.instance, l), 1u << l, front.data(),
                               back.data());
    }
    for (std::uint32_t k = 0; k < at.count; ++k) facing_[placed + k] = {front[k], back[k]};
    const Nearness& near = nearness_[at.instance];
    for (std::uint32_t l = 0; l < group.count; ++l) {
        if ((skipped >> l & 1u) != 0) continue;
        const bool closely =
            options.figures || out.parts || near.eyeIn || ((near.lightIn | near.lineHits) >> l & 1u) != 0;
        if (closely) lookClosely(sweep, at, l, summaries);
    }
}

/// One light and the triangles for which more than their facing may matter.
void CpuSilhouettes::lookClosely(const Sweep& sweep, const Stretch& at, std::uint32_t l, Summaries& summaries) {
    const auto& [geometry, group, options, out] = sweep;
    const gpu::InstanceData& instance = geometry.instances()[at.instance];
    gpu::CasterState& caster = out.hostCasters[at.instance];
    gpu::LightSummary& summary = summaries[l];
    const glm::vec4 light = sweep.light(at.instance, l);
    const bool farEnds = mayHoldFarEnds(instance, caster, l);
    const std::uint32_t bit = 1u << l;
    for (std::uint32_t t = at.first; t < at.first + at.count; ++t) {
        const std::uint32_t placed = instance.placedTriangleBase + t;
        const std::uint32_t flags = geometry.triangleFlags()[instance.triangleBase + t];
        const TriangleCorners corners = sweep.out.hostTriangles.corners(geometry, at.instance, t);
        const glm::vec3 n = sweep.out.hostTriangles.normal(at.instance, t);
        gpu::uvec2& bits = facing_[placed];
        float side = sideOf(n, corners[0], light);
        if (inBoxOf(corners, light)) {
            side = sideOfNearLight(corners, glm::dvec3(light));
            bits = {side > 0.0f ? bits.x | bit : bits.x & ~bit, side < 0.0f ? bits.y | bit : bits.y & ~bit};
            // Where the light lies on the triangle it has no weight: its volume would be half of space.
            if (side == 0.0f) orAtomically(caster.lightOn, bit);
        }
        if ((flags & TRIANGLE_CASTS) == 0 || ((bits.x | bits.y) & bit) == 0) continue;
        summary.litTriangles += side > 0.0f;
        const bool fail = out.parts || (caster.countedByFail & bit) != 0;  // by parts: somewhere
        summary.lightCaps += fail || (flags & TRIANGLE_HOLED) != 0 || caster.missing != 0;
        const bool apart = light.w != 0.0f && instance.eyeInModel.w != 0.0f;
        summary.darkCaps += fail && (apart || endOfVolume(caster, l) != 0);
        const bool underEye = nearness_[at.instance].eyeIn && eyeIsOn(instance.eyeInModel, n, corners);
        if (out.parts) {
            gpu::SplitPart& part = out.parts->host[out.parts->partOf(placed, l)];
            if (underEye) part.hazards |= 1u << SPLIT_PASS;
            countEnds(sweep, at.instance, l, side, corners, n, summary, part);
            continue;
        }
        const std::uint32_t list = listOf(instance, caster, l, (flags & TRIANGLE_EVEN) != 0);
        if (underEye && list != LIST_FAIL) orAtomically(caster.hazards, bit);
        if (list != LIST_FAIL || farEnds) countEye(sweep, at.instance, l, side, corners, n, list, summary);
    }
}

void CpuSilhouettes::countEye(const Sweep& sweep, std::uint32_t i, std::uint32_t l, float lightSide,
                              const TriangleCorners& v, const glm::vec3& n, std::uint32_t list,
                              gpu::LightSummary& summary) const {
    const glm::vec4 eye = sweep.geometry.instances()[i].eyeInModel;
    bool undecided = false;
    summary.eyeInside[list] += isOver(list == LIST_FAIL ? -eye : eye, sweep.light(i, l), lightSide, v, n, undecided);
    if (undecided) orAtomically(sweep.out.hostCasters[i].hazards, 1u << l);
}

void CpuSilhouettes::countEnds(const Sweep& sweep, std::uint32_t i, std::uint32_t l, float lightSide,
                               const TriangleCorners& v, const glm::vec3& n, gpu::LightSummary& summary,
                               gpu::SplitPart& part) const {
    const gpu::InstanceData& instance = sweep.geometry.instances()[i];
    const bool bothEnds = mayHoldFarEnds(instance, sweep.out.hostCasters[i], l);
    for (std::uint32_t end = SPLIT_PASS; end <= (bothEnds ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        const glm::vec4 eye = end == SPLIT_PASS ? instance.eyeInModel : -instance.eyeInModel;
        bool undecided = false;
        const bool over = isOver(eye, sweep.light(i, l), lightSide, v, n, undecided);
        part.eyeInside[end] += over;
        if (end == SPLIT_PASS) summary.eyeInside[LIST_WHOLE] += over;
        if (undecided) part.hazards |= 1u << end;
    }
}

void CpuSilhouettes::findEdges(const Sweep& sweep, const Stretch& at, Summaries& summaries,
                               std::vector<Found>& found) const {
    const SplitParts* parts = sweep.out.parts;
    const gpu::InstanceData& instance = sweep.geometry.instances()[at.instance];
    const gpu::uvec2* facing = &facing_[instance.placedTriangleBase];
    const auto traversals = [&](std::uint32_t triangle) {
        const gpu::uvec2 bits = facing[triangle & EDGE_TRIANGLE];
        return (triangle & EDGE_REVERSED) != 0 ? gpu::uvec2(bits.y, bits.x) : bits;
    };
    for (std::uint32_t k = at.first; k < at.first + at.count; ++k) {
        const gpu::Edge& edge = sweep.geometry.edges()[instance.edgeBase + k];
        const gpu::uvec2 left = traversals(edge.left);
        const gpu::uvec2 right = edge.right == EDGE_NONE ? gpu::uvec2(0) : traversals(edge.right);
        std::uint32_t apart = 0;  // lights for which it is an edge of two parts, with one triangle in each
        for (std::uint32_t l = 0; parts && edge.right != EDGE_NONE && l < sweep.group.count; ++l) {
            const auto partOf = [&](std::uint32_t triangle) {
                return parts->partOf(instance.placedTriangleBase + (triangle & EDGE_TRIANGLE), l);
            };
            apart |= std::uint32_t(partOf(edge.left) != partOf(edge.right)) << l;
        }
        append(sweep, at.instance, k, left & gpu::uvec2(~apart), right & gpu::uvec2(~apart), 0, summaries, found);
        if (apart == 0) continue;
        append(sweep, at.instance, k, left & gpu::uvec2(apart), gpu::uvec2(0), 0, summaries, found);
        append(sweep, at.instance, k, right & gpu::uvec2(apart), gpu::uvec2(0), QUAD_OF_RIGHT, summaries, found);
    }
}

void CpuSilhouettes::append(const Sweep& sweep, std::uint32_t i, std::uint32_t k, const gpu::uvec2& left,
                            const gpu::uvec2& right, std::uint32_t flags, Summaries& summaries,
                            std::vector<Found>& found) const {
    const gpu::uvec2 twice = left & right, both = left | right;
    const gpu::uvec2 once = (left ^ right) & ~gpu::uvec2(both.y, both.x);
    std::uint32_t silhouette = twice.x | twice.y | once.x | once.y;
    if (silhouette == 0) return;
    const gpu::InstanceData& instance = sweep.geometry.instances()[i];
    const gpu::CasterState& caster = sweep.out.hostCasters[i];
    const gpu::Edge& edge = sweep.geometry.edges()[instance.edgeBase + k];
    const glm::vec3 a = sweep.out.hostTriangles.position(instance.vertexBase + edge.a);
    const glm::vec3 b = sweep.out.hostTriangles.position(instance.vertexBase + edge.b);
    for (; silhouette != 0; silhouette &= silhouette - 1) {
        const auto l = std::uint32_t(std::countr_zero(silhouette));
        const bool negative = ((twice.y | once.y) >> l & 1u) != 0, isTwice = ((twice.x | twice.y) >> l & 1u) != 0;
        std::uint32_t list = listOf(instance, caster, l, (edge.left & EDGE_EVEN) != 0);
        // Of an even component only another part has the rest.
        if (sweep.out.parts && list == LIST_HALVED && !isTwice) list = LIST_WHOLE;
        if (!findHazards(sweep, i, l, list, edge, flags, a, b)) continue;
        const bool sliver = isSliver(instance.eyeInModel, sweep.light(i, l), a, b);
        const std::uint32_t entry = (instance.placedEdgeBase + k) << 1 | std::uint32_t(negative) | flags;
        found.push_back({entry, std::uint16_t(l * LIST_COUNT + list + (sliver ? LIST_EDGE_ON : 0)),
                         std::uint16_t(isTwice && !(sweep.options.halve && list == LIST_HALVED) ? 2 : 1)});
        ++summaries[l].silhouetteEdges;
        summaries[l].doubleEdges += isTwice;
    }
}

bool CpuSilhouettes::findHazards(const Sweep& sweep, std::uint32_t i, std::uint32_t l, std::uint32_t list,
                                 const gpu::Edge& edge, std::uint32_t flags, const glm::vec3& a,
                                 const glm::vec3& b) const {
    const auto& [geometry, group, options, out] = sweep;
    const gpu::InstanceData& instance = geometry.instances()[i];
    gpu::CasterState& caster = out.hostCasters[i];
    const glm::vec4 eye = instance.eyeInModel, light = sweep.light(i, l);
    const bool fail = list == LIST_FAIL, farEnds = mayHoldFarEnds(instance, caster, l);
    if (!out.parts) {
        if ((nearness_[i].lineNear >> l & 1u) == 0) return true;
        if ((fail || eye.w == 0.0f) && endsInQuad(fail ? eye : -eye, light, a, b)) return false;
        if ((!fail || farEnds) && hazardous(fail ? -eye : eye, light, a, b)) orAtomically(caster.hazards, 1u << l);
        return true;
    }
    const std::uint32_t triangle = ((flags & QUAD_OF_RIGHT) != 0 ? edge.right : edge.left) & EDGE_TRIANGLE;
    gpu::SplitPart& part = out.parts->host[out.parts->partOf(instance.placedTriangleBase + triangle, l)];
    bool drawn = true;
    for (std::uint32_t end = SPLIT_PASS; end <= (farEnds ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        const glm::vec4 there = end == SPLIT_PASS ? eye : -eye;
        if (hazardous(there, light, a, b)) part.hazards |= 1u << end;
        const bool needed = end == SPLIT_FAIL && (caster.lightMoved >> l & 1u) != 0;  // see edge_sweep.glsl
        if (!needed && endsInQuad(there, light, a, b)) drawn = false;
    }
    return drawn;
}

void CpuSilhouettes::upload(const Sweep& sweep) {
    const auto& [geometry, group, options, out] = sweep;
    entries_.resize(std::size_t(group.count) * LIST_COUNT);
    for (std::vector<std::uint32_t>& entries : entries_) entries.clear();
    for (const std::vector<Found>& some : found_) {
        for (const Found& quad : some) {
            for (std::uint16_t n = 0; n < quad.times; ++n) entries_[quad.list].push_back(quad.entry);
        }
    }
    for (std::size_t list = 0; list < entries_.size(); ++list) {
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
