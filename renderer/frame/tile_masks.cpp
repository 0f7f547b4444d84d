// SPDX-License-Identifier: Apache-2.0
#include "frame/tile_masks.h"

#include <algorithm>
#include <limits>

namespace umbrage {

void TileMasks::see(const Silhouettes& silhouettes, const LightGroup& group, const Target& target, const TileEye& eye,
                    int sample) {
    // Of a picture with one sample a pixel somebody else reads it, too.
    if (target.gbuffer.samples() > 1) {
        target.resolve.readSeen(target.gbuffer, target.masks, silhouettes, sample, eye.sample, target.seen);
    }
    SeenPicture picture;
    picture.triangles = target.seen.triangles;
    picture.depths = target.seen.depths;
    picture.noTriangle = NO_TRIANGLE;
    picture.emptyDepth = target.eye.emptyDepth();
    const double sceneDepths = 1.0 - target.eye.ledge, range = target.eye.zfar - target.eye.znear;
    picture.depthScale = (target.eye.perspective ? 1.0 / target.eye.znear : range) / sceneDepths;
    picture.depthOffset = target.eye.perspective ? 0.0 : -target.eye.zfar;
    picture.planes = silhouettes.hostPlanes;
    picture.facing = std::span(silhouettes.hostFacing).subspan(silhouettes.facingBase(group));
    if (!seen_) seen_.emplace(eye.width, eye.height);
    seen_->set(picture, eye);
}

void TileMasks::count(std::span<const std::vector<CountPlan>> plans, const Geometry& geometry,
                      const Silhouettes& silhouettes, const LightGroup& group, const Target& target, bool everyPixel) {
    if (!ties_) ties_ = gpu::findSampleTies();
    const int width = target.gbuffer.width(), height = target.gbuffer.height();
    const std::vector<glm::vec2> positions = target.gbuffer.samplePositions();
    const glm::dvec2 shiftPixels = 0.5 * target.eye.shift * glm::dvec2(width, -height);
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    dark_.resize(pixels * positions.size());
    // The first sample last: readCounts() is about it.
    for (std::size_t s = positions.size(); s-- > 0;) {
        const TileEye eye{width,
                          height,
                          target.eye.rayScale,
                          target.eye.perspective,
                          target.eye.znear,
                          glm::dvec2(positions[s]) + shiftPixels,
                          glm::dvec2(ties_->right, ties_->down)};
        const TileScene scene{geometry, silhouettes, group, eye, target.eyeConstant};
        lights_.begin(scene);
        see(silhouettes, group, target, eye, int(s));
        if (everyPixel) seen_->lightAll();
        lights_.findExposed(scene, *seen_, counter_);
        counted_.resize(plans.size());
        for (std::uint32_t l = 0; l < plans.size(); ++l) {
            TileLight& light = counted_[l];
            lights_.find(plans[l], scene, *seen_, l, light);
            const gpu::LightData& data = target.lights[l];
            light.position = glm::vec3(data.position);
            const bool hasRange = data.position.w != 0.0f && data.direction.w > 0.0f;
            const bool limited = hasRange && target.skipOutOfReach && !everyPixel;
            light.range2 = limited ? 1.001f / data.direction.w : std::numeric_limits<float>::infinity();
        }
        seen_->toRows(counter_.count(*seen_, counted_).data(), dark_.data() + s * pixels);
    }
    target.masks.set(group.first / LIGHTS_PER_GROUP, dark_);
}

std::vector<std::uint32_t> TileMasks::readCounts(std::uint32_t l) {
    const SeenTiles& seen = *seen_;
    std::vector<std::int32_t> rows(seen.pixelsOfPicture());
    seen.toRows(counter_.countsOf(seen, counted_[l]).data(), rows.data());
    std::vector<std::uint32_t> counts(rows.size());
    std::ranges::transform(rows, counts.begin(), [](std::int32_t count) { return std::uint32_t(std::abs(count)); });
    return counts;
}

}  // namespace umbrage
