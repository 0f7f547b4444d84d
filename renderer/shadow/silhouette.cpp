// SPDX-License-Identifier: Apache-2.0
#include "shadow/silhouette.h"

#include <algorithm>

namespace umbrage {

void Silhouettes::bind() const {
    lightsInModel.bindStorage(BIND_LIGHTS_IN_MODEL);
    facing.bindStorage(BIND_FACING);
    planes.bindStorage(BIND_PLANES);
    casters.bindStorage(BIND_CASTERS);
    summaries.bindStorage(BIND_SUMMARY);
    quads.bindStorage(BIND_QUADS);
    if (parts) parts->bind();
}

void Silhouettes::readFaces(const LightGroup& group) {
    const std::size_t first = facingBase(group);
    hostFacing.resize(std::max(hostFacing.size(), first + facingStride));
    facing.read(first * sizeof(gpu::uvec2), facingStride * sizeof(gpu::uvec2), &hostFacing[first]);
    hostPlanes.resize(facingStride);
    planes.read(0, facingStride * sizeof(gpu::vec4), hostPlanes.data());
}

std::uint32_t listOf(const gpu::InstanceData& instance, const gpu::CasterState& caster, std::uint32_t l, bool even) {
    if (caster.countedByFail >> l & 1u) return LIST_FAIL;
    return even && !(instance.flags & INSTANCE_WHOLE) && !(caster.lightOn >> l & 1u) ? LIST_HALVED : LIST_WHOLE;
}

void placeLights(const Geometry& geometry, std::span<const ShadowLight> lights, Silhouettes& out) {
    out.totalLights = std::uint32_t(lights.size());
    out.facingStride = geometry.placedTriangleCount();
    out.hostLightsInModel.resize(geometry.instanceCount() * lights.size());
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const glm::dmat4 modelFromWorld = glm::inverse(geometry.worldFromModel(i));
        for (const ShadowLight& light : lights) out.hostLightsInModel[next++] = glm::vec4(modelFromWorld * light);
    }
    // Without lights there still is one sweep, for the planes.
    const std::size_t groups = std::max<std::size_t>(1, (lights.size() + LIGHTS_PER_GROUP - 1) / LIGHTS_PER_GROUP);
    out.lightsInModel.reserve("lights in model space", out.hostLightsInModel.size() * sizeof(glm::vec4));
    out.lightsInModel.write(std::span<const glm::vec4>(out.hostLightsInModel));
    out.facing.reserve("facing bits", groups * out.facingStride * sizeof(gpu::uvec2));
    out.planes.reserve("triangle planes", out.facingStride * sizeof(gpu::vec4));
    out.summaries.reserve("light summaries", LIGHTS_PER_GROUP * sizeof(gpu::LightSummary));
}

namespace {

std::uint32_t largestList(std::span<const gpu::LightSummary> summaries) {
    std::uint32_t quads = 0;
    for (const gpu::LightSummary& summary : summaries) {
        for (const gpu::DrawCommand& list : summary.lists) quads = std::max(quads, list.count / 6);
    }
    return quads;
}

/// With an orthographic eye in line with the light and two places of a caster's silhouette, on either side of the
/// light, volumes end at both ends of the view rays, and neither count has a constant. For such a caster the light is
/// moved across the view by 2^-18 of its distance, far below what a pixel shows.
void moveAcrossView(const gpu::InstanceData& instance, glm::vec4& light) {
    const glm::vec3 along(instance.eyeInModel);
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::vec3(0.8f, 0.53f, -0.29f) * glm::length(along)));
    const float size = std::max(glm::length(glm::vec3(light)), 1e-30f);
    light += glm::vec4(0x1p-18f * size * across, 0.0f);
}

/// The same for parts whose volumes hold both ends of the view rays, so that neither count of theirs is safe.
/// @return whether any light was moved
bool moveLightsOfUnsafeParts(const Geometry& geometry, const LightGroup& group, Silhouettes& out) {
    constexpr std::uint32_t kBothEnds = 1u << SPLIT_PASS | 1u << SPLIT_FAIL;
    bool any = false;
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const gpu::InstanceData& instance = geometry.instances()[i];
        std::uint32_t& moved = out.hostCasters[i].lightMoved;
        for (std::uint32_t l = 0; l < group.count; ++l) {
            if (moved >> l & 1u) continue;
            bool unsafe = false;
            for (std::uint32_t t = 0; t < instance.triangleCount && !unsafe; ++t) {
                unsafe = out.parts->host[out.parts->partOf(instance.placedTriangleBase + t, l)].hazards == kBothEnds;
            }
            if (!unsafe) continue;
            moveAcrossView(instance, out.hostLightsInModel[i * out.totalLights + group.first + l]);
            moved |= 1u << l;
            any = true;
        }
    }
    return any;
}

void clearSummaries(const Silhouettes& out, std::uint32_t lightCount, std::vector<gpu::LightSummary>& summaries) {
    summaries.assign(lightCount, {});
    for (std::uint32_t l = 0; l < lightCount; ++l) {
        for (std::uint32_t list = 0; list < LIST_COUNT; ++list) {
            // Vertex 4 q of the shared quad pattern is entry q of the whole buffer, so a list starts at its entry.
            summaries[l].lists[list] = {0, 1, 0, 4 * (l * LIST_COUNT + list) * out.capacity, 0};
        }
    }
}

}  // namespace

void findSilhouettes(SilhouetteTechnique& technique, const Geometry& geometry, const LightGroup& group,
                     std::uint32_t countedByFail, const SweepOptions& options, Silhouettes& out) {
    for (gpu::CasterState& caster : out.hostCasters) {
        caster.countedByFail = countedByFail;
        caster.hazards = caster.lightOn = caster.lightMoved = 0;
    }
    // Bits of lights whose count was changed already, and of those known to lie on a caster.
    std::vector<std::uint32_t> changed(out.hostCasters.size()), lightOn(out.hostCasters.size());
    if (out.capacity == 0) out.capacity = 1024 + geometry.placedEdgeCount() / 16;
    for (;;) {
        if (technique.fillsLists()) {
            out.quads.reserve("side quads",
                              std::size_t(group.count) * LIST_COUNT * out.capacity * sizeof(std::uint32_t));
        }
        clearSummaries(out, group.count, out.hostSummaries);
        out.summaries.write(std::span<const gpu::LightSummary>(out.hostSummaries));
        out.casters.write(std::span<const gpu::CasterState>(out.hostCasters));
        if (out.parts) out.parts->begin();
        technique.sweep(geometry, group, options, out);

        const std::uint32_t needed = largestList(out.hostSummaries);
        bool again = technique.fillsLists() && needed > out.capacity;
        bool lightsMoved = out.parts && moveLightsOfUnsafeParts(geometry, group, out);
        if (again) out.capacity = needed + needed / 4;
        for (std::size_t i = 0; i < out.hostCasters.size(); ++i) {
            gpu::CasterState& caster = out.hostCasters[i];
            caster.hazards &= options.hazards;
            if (const std::uint32_t found = caster.hazards & changed[i] & ~caster.lightMoved; found != 0) {
                for (std::uint32_t l = 0; l < group.count; ++l) {
                    if (!(found >> l & 1u)) continue;
                    moveAcrossView(geometry.instances()[i],
                                   out.hostLightsInModel[i * out.totalLights + group.first + l]);
                }
                caster.lightMoved |= found;
                lightsMoved = true;
            }
            const std::uint32_t found = caster.hazards & ~changed[i];
            again = again || found != 0 || caster.lightOn != lightOn[i];
            lightOn[i] = caster.lightOn;
            caster.countedByFail ^= found;
            caster.hazards = 0;
            changed[i] |= found;
        }
        if (lightsMoved) out.lightsInModel.write(std::span<const glm::vec4>(out.hostLightsInModel));
        if (!again && !lightsMoved) return;
    }
}

}  // namespace umbrage
