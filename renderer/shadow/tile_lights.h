// SPDX-License-Identifier: Apache-2.0
// From silhouettes to what the tile counter takes. It needs no caps but of triangles that are missing from the depth
// buffer where they are the nearest (T1), and finds those itself, one by one; and because sides and the eye's constant
// are decided by the same determinants, in double and with the light moved by a hair, it knows no hazards (T4).
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <span>
#include <vector>

#include "shadow/counts.h"
#include "tiles/tile_counter.h"

namespace umbrage {

/// A sample of every pixel, and the eye. Of the silhouettes what is on the host is up to date.
struct TileScene {
    const Geometry& geometry;
    const Silhouettes& silhouettes;
    const LightGroup& group;
    const TileEye& eye;
    bool eyeConstant;  // off: textbook z-pass, wrong with the eye in a volume

    /// Bits of lights that the front and the back of a placed triangle face.
    const glm::uvec2& facing(std::uint32_t placed) const {
        return silhouettes.hostFacing[silhouettes.facingBase(group) + placed];
    }
    /// Which side of it faces light `l` of the group: 1 the front, -1 the back, 0 none (or both: edge-on).
    int sideFacing(std::uint32_t placed, std::uint32_t l) const {
        return int(facing(placed).x >> l & 1u) - int(facing(placed).y >> l & 1u);
    }
};

/// An instance's model space as the eye sees it, and a sphere around it in view space.
struct InstanceInView {
    std::array<glm::dvec4, 3> rows;
    bool mirrored = false;
    glm::dvec3 center{0.0};
    double radius = 0.0;

    glm::dvec4 of(const glm::dvec4& p) const {
        return {glm::dot(rows[0], p), glm::dot(rows[1], p), glm::dot(rows[2], p), p.w};
    }
    glm::dvec3 of(const glm::vec3& p) const { return glm::dvec3(of(glm::dvec4(p, 1.0))); }
    double farthestMetres() const { return glm::length(center) + radius; }
    glm::dvec3 eyeHair() const;
};

class TileLights {
public:
    /// Once a group of lights and sample.
    void begin(const TileScene& scene);

    /// Finds the casting triangles that may be nearer than what is seen: culled, with holes, or before the near plane.
    /// @param seen  at the eye's sample
    void findExposed(const TileScene& scene, const SeenTiles& seen, TileCounter& counter);

    /// Fills polygons, samples and start of a light.
    /// @param plans  of light `l` of the group; their sides
    /// @param seen  at the eye's sample
    void find(std::span<const CountPlan> plans, const TileScene& scene, const SeenTiles& seen, std::uint32_t l,
              TileLight& light);

private:
    struct Exposed {
        std::uint32_t triangle;  // placed
        TilePolygon cap;         // as if the light were in front
    };
    /// What a rasteriser may miss of the triangles along one edge.
    struct RimSample {
        std::uint32_t triangle;  // placed
        TileSample sample;

        auto operator<=>(const RimSample&) const = default;
    };
    struct ListedEdge;
    void findRim(const TileScene& scene, const SeenTiles& seen, std::uint32_t l, const ListedEdge& listed,
                 std::vector<RimSample>& found) const;
    std::vector<TileSource> sourcesInView(const TileScene& scene, std::uint32_t light) const;
    int layersOverEye(const TileScene& scene, std::uint32_t l, std::span<const TileSource> sources) const;

    std::vector<InstanceInView> instances_;
    std::vector<Exposed> exposed_;  // by ascending triangle
    tbb::enumerable_thread_specific<std::vector<TilePolygon>> madePolygons_;
    tbb::enumerable_thread_specific<std::vector<RimSample>> madeRim_;
    tbb::enumerable_thread_specific<std::vector<Exposed>> madeExposed_;
};

}  // namespace umbrage
