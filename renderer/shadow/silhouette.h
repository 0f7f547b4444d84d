// SPDX-License-Identifier: Apache-2.0
// Silhouettes: from lights and geometry to stored facing bits and side quads on the device. One technique a file; all
// of them fill the same buffers and draw the same quads, listed or not, so that counting does not know which one ran.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "shadow/fault.h"
#include "shadow/geometry.h"
#include "shadow/host_triangles.h"
#include "shadow/split_parts.h"

namespace umbrage {

/// A light as shadows see it: homogeneous in the world, (position, 1) or (direction towards it, 0).
using ShadowLight = glm::dvec4;

/// Lights of one group (at most LIGHTS_PER_GROUP), as positions in the frame's whole list.
struct LightGroup {
    std::uint32_t first = 0, count = 0;
};

/// What a silhouette technique fills for one group of lights.
struct Silhouettes {
    gpu::Buffer lightsInModel;  // vec4 per instance and light of the frame
    gpu::Buffer facing;         // uvec2 per placed triangle, group after group
    gpu::Buffer planes;         // vec4 per placed triangle: view space
    gpu::Buffer casters;        // gpu::CasterState per instance
    gpu::Buffer summaries;      // gpu::LightSummary per light of the group; also the indirect draw commands
    gpu::Buffer quads;          // capacity entries per list and light, of techniques that fill lists
    std::uint32_t capacity = 0;

    std::vector<glm::vec4> hostLightsInModel;
    std::vector<gpu::LightSummary> hostSummaries;
    std::vector<gpu::CasterState> hostCasters;
    std::uint32_t totalLights = 0, facingStride = 0;
    std::vector<std::array<glm::vec4, 6>> extents;  // faces of what each light of the group shines on, in view space

    HostTriangles hostTriangles;  // up to date where something on the host asks for it

    SplitParts* parts = nullptr;  // where counts are made by parts: not owned

    std::uint32_t facingBase(const LightGroup& group) const { return group.first / LIGHTS_PER_GROUP * facingStride; }
    void bind() const;
};

/// Of light `l` of the group: 0, or 1 + the face of its extent that sides end behind.
inline std::uint32_t endOfVolume(const gpu::CasterState& caster, std::uint32_t l) {
    return caster.ends[l / 10] >> (3 * (l % 10)) & 7u;
}

struct SweepOptions {
    bool edges = true;            // off: only facing bits and planes, for frames without shadows
    bool halve = true;            // LIST_HALVED gets one quad for two crossings, else both
    bool figures = false;         // also count lit triangles and silhouette edges
    std::uint32_t hazards = ~0u;  // bits of lights: for others nothing depends on an eye constant (T4)
};

/// What makes the corners of a technique's side quads: quad.vert for those that are listed, or others that end in
/// side_quad.glsl.
struct SideShaders {
    const char* vertex;
    const char* geometry = "";
    gpu::Program::Defines defines{};
};

/// The side quads in one list of a light.
struct SideList {
    const Geometry& geometry;
    const Silhouettes& silhouettes;
    const LightGroup& group;
    std::uint32_t l = 0;     // of the group, which was swept last
    std::uint32_t list = 0;  // LIST_... (+ LIST_EDGE_ON)
};

class SilhouetteTechnique {
public:
    virtual ~SilhouetteTechnique() = default;
    virtual std::string_view name() const = 0;
    /// Whether a sweep fills Silhouettes::quads; else quads are found while they are drawn.
    virtual bool fillsLists() const { return true; }
    /// Whether it reads Silhouettes::hostTriangles.
    virtual bool onHost() const { return false; }

    /// One sweep over the triangles and edges. `casters` says which are counted by z-fail; the sweep adds hazards to
    /// it, and fills everything else. Lists that outgrow `capacity` are cut, but their counts are right.
    virtual void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                       Silhouettes& out) = 0;

    virtual SideShaders sideShaders() const = 0;
    /// Draws by a program of those shaders, which is in use with its uniforms 0 and 1 and all storage bound.
    virtual void drawSides(const SideList& sides, const gpu::Program& program) = 0;
};

/// @param name  of kSilhouettes
/// @param fault  planted into the device's own
std::unique_ptr<SilhouetteTechnique> makeSilhouetteTechnique(std::string_view name, Fault fault = Fault::None);

/// Which list a caster's side quads go to: see caster_lists.glsl. @param l  of the group
std::uint32_t listOf(const gpu::InstanceData& instance, const gpu::CasterState& caster, std::uint32_t l, bool even);

/// Lights into every instance's model space, in double and rounded once (docs/rules.md, G3).
void placeLights(const Geometry& geometry, std::span<const ShadowLight> lights, Silhouettes& out);

/// Sweeps until every list fits, casters on which a light lies are counted whole, and none is counted from within the
/// hazard zone of its volumes (T4): one that is changes to the other count, and if that is no safer (which only happens
/// with an orthographic eye) its light is moved a little. Results are read back.
/// @param countedByFail  bits of the group's lights whose casters are counted by z-fail, hazards apart
void findSilhouettes(SilhouetteTechnique& technique, const Geometry& geometry, const LightGroup& group,
                     std::uint32_t countedByFail, const SweepOptions& options, Silhouettes& out);

}  // namespace umbrage
