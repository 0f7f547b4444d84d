// SPDX-License-Identifier: Apache-2.0
#include "frame/record.h"

#include <algorithm>

#include "shading/lights.h"

namespace umbrage {
namespace {

constexpr int kTile = 8;  // pixels, both ways

Distribution distributionOf(const std::vector<float>& values) {
    Distribution distribution;
    for (const float value : values) distribution.add(value);
    return distribution;
}

void addTo(std::vector<float>& sum, const std::vector<float>& values) {
    sum.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
}

/// How many tiles of a picture have a value other than 0.
double tilesWith(const std::vector<float>& values, int width, int height) {
    const int columns = (width + kTile - 1) / kTile, rows = (height + kTile - 1) / kTile;
    std::vector<bool> any(std::size_t(columns) * std::size_t(rows));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (values[std::size_t(y) * std::size_t(width) + std::size_t(x)] != 0.0f) {
                any[std::size_t(y / kTile) * std::size_t(columns) + std::size_t(x / kTile)] = true;
            }
        }
    }
    return double(std::count(any.begin(), any.end(), true));
}

}  // namespace

void FillSums::add(const gpu::CasterFill& fill, bool byFail, bool halve) {
    for (std::uint32_t kind = 0; kind < FILL_KINDS; ++kind) {
        const double front[] = {double(fill.passedFront[kind]), double(fill.failedFront[kind])};
        const double back[] = {double(fill.passedBack[kind]), double(fill.failedBack[kind])};
        const double all = front[0] + front[1] + back[0] + back[1];
        (kind == FILL_LIGHT_CAPS ? lightCaps : kind == FILL_DARK_CAPS ? darkCaps : sides) += all;
        passed += front[0] + back[0];
        failed += front[1] + back[1];
        const double in = byFail ? back[1] : front[0], out = byFail ? front[1] : back[0];
        entered += in;
        left += out;
        net += (halve && kind == FILL_HALVED_SIDES ? 2.0 : 1.0) * (in - out);
    }
}

void FillSums::add(const FillSums& other) {
    sides += other.sides;
    lightCaps += other.lightCaps;
    darkCaps += other.darkCaps;
    passed += other.passed;
    failed += other.failed;
    entered += other.entered;
    left += other.left;
    net += other.net;
}

void recordActivity(int frame, const gpu::Activity& begin, Statistics& statistics) {
    const gpu::Activity& now = gpu::activity();
    statistics.record(frame, {}, "device.draws", double(now.draws - begin.draws));
    statistics.record(frame, {}, "device.dispatches", double(now.dispatches - begin.dispatches));
    statistics.record(frame, {}, "device.stateChanges", double(now.stateChanges - begin.stateChanges));
    statistics.record(frame, {}, "device.uploaded", double(now.uploadedBytes - begin.uploadedBytes));
    statistics.record(frame, {}, "device.readBack", double(now.readBackBytes - begin.readBackBytes));
    statistics.record(frame, {}, "memory.device", double(now.allocatedBytes));
}

FrameRecorder::FrameRecorder(const Scene& scene, const Moment& moment, const Geometry& geometry, const Picture& picture,
                             int frame, Statistics& statistics)
    : scene_(scene),
      moment_(moment),
      geometry_(geometry),
      picture_(picture),
      frame_(frame),
      statistics_(statistics),
      casters_(geometry.instanceCount()) {}

void FrameRecorder::record(const StatisticsPlace& place, const FillSums& sums) const {
    statistics_.record(frame_, place, "overdraw.fragments", sums.fragments());
    statistics_.record(frame_, place, "overdraw.updates", sums.updates());
    if (!place.caster.empty()) return;  // what tells casters apart
    statistics_.record(frame_, place, "overdraw.sides", sums.sides);
    statistics_.record(frame_, place, "overdraw.lightCaps", sums.lightCaps);
    statistics_.record(frame_, place, "overdraw.darkCaps", sums.darkCaps);
    statistics_.record(frame_, place, "overdraw.passed", sums.passed);
    statistics_.record(frame_, place, "overdraw.failed", sums.failed);
    statistics_.record(frame_, place, "overdraw.entered", sums.entered);
    statistics_.record(frame_, place, "overdraw.left", sums.left);
    const double samples = double(picture_.width) * picture_.height * picture_.samples;
    statistics_.record(frame_, place, "overdraw.depthComplexity", sums.fragments() / samples);
}

void FrameRecorder::recordPixels(const StatisticsPlace& place, const std::vector<float>& fragments,
                                 const std::vector<float>& updates) const {
    statistics_.record(frame_, place, "overdraw", distributionOf(fragments));
    statistics_.record(frame_, place, "updates", distributionOf(updates));
}

void FrameRecorder::light(const std::string& id, std::uint32_t l, const Silhouettes& silhouettes, bool halve,
                          const VolumeFill& fill, std::optional<int> startLayers,
                          const std::vector<std::uint32_t>& stencil) {
    const StatisticsPlace place{.light = id};
    const gpu::LightSummary& summary = silhouettes.hostSummaries[l];
    double quads = 0, eyeConstant = 0, zfail = 0, outOfReach = 0, outOfView = 0, ended = 0;
    for (const gpu::DrawCommand& list : summary.lists) quads += list.count / 6;
    for (const std::uint32_t layers : summary.eyeInside) eyeConstant += layers;
    FillSums sums;
    double nearCaps[NEAR_CAP_CASES] = {};
    for (std::size_t i = 0; i < casters_.size(); ++i) {
        for (std::size_t k = 0; k < NEAR_CAP_CASES; ++k) nearCaps[k] += fill.casters[i].nearCaps[k];
        const gpu::CasterState& caster = silhouettes.hostCasters[i];
        const bool byFail = caster.countedByFail >> l & 1u;
        zfail += byFail;
        outOfReach += caster.outOfReach >> l & 1u;
        outOfView += (caster.outOfView & ~caster.outOfReach) >> l & 1u;
        ended += endOfVolume(caster, l) != 0;
        FillSums own;
        own.add(fill.casters[i], byFail, halve);
        if (own.fragments() > 0) {
            record({.light = id, .caster = scene_.nodes[std::size_t(moment_.instances[i].node)].path}, own);
        }
        casters_[i].add(own);
        sums.add(own);
    }
    statistics_.record(frame_, place, "triangles.facing", summary.litTriangles);
    statistics_.record(frame_, place, "edges.silhouette", summary.silhouetteEdges);
    statistics_.record(frame_, place, "edges.silhouette.once", summary.silhouetteEdges - summary.doubleEdges);
    statistics_.record(frame_, place, "edges.silhouette.twice", summary.doubleEdges);
    statistics_.record(frame_, place, "quads", quads);
    statistics_.record(
        frame_, place, "quads.halved",
        halve ? (summary.lists[LIST_HALVED].count + summary.lists[LIST_HALVED + LIST_EDGE_ON].count) / 6 : 0);
    statistics_.record(frame_, place, "caps.light", summary.lightCaps);
    statistics_.record(frame_, place, "caps.dark", summary.darkCaps);
    statistics_.record(frame_, place, "caps.near.trivial", nearCaps[NEAR_CAP_TRIVIAL]);
    statistics_.record(frame_, place, "caps.near.easy", nearCaps[NEAR_CAP_EASY]);
    statistics_.record(frame_, place, "caps.near.hard", nearCaps[NEAR_CAP_HARD]);
    statistics_.record(frame_, place, "eye.constant", eyeConstant);
    statistics_.record(frame_, place, "casters.zfail", zfail);
    statistics_.record(frame_, place, "casters.outOfReach", outOfReach);
    statistics_.record(frame_, place, "casters.outOfView", outOfView);
    statistics_.record(frame_, place, "casters.ended", ended);
    record(place, sums);
    statistics_.record(frame_, place, "overdraw.queried", double(fill.queried));
    recordPixels(place, fill.fragments, fill.updates);
    if (startLayers) {
        const double samples = double(fill.fragments.size()) * picture_.samples;
        statistics_.record(frame_, place, "count.net", sums.net + *startLayers * samples);
    }
    if (!stencil.empty()) {
        Distribution distribution;
        for (const std::uint32_t count : stencil) distribution.add(count);
        statistics_.record(frame_, place, "stencil", distribution);
    }
    const double touched = tilesWith(fill.fragments, picture_.width, picture_.height);
    const double processed = tilesWith(fill.updates, picture_.width, picture_.height);
    statistics_.record(frame_, place, "tiles.touched", touched);
    statistics_.record(frame_, place, "tiles.processed", processed);
    statistics_.record(frame_, place, "tiles.culled", touched - processed);
    addTo(fragments_, fill.fragments);
    addTo(updates_, fill.updates);
}

void FrameRecorder::scene(const SceneFragments& scene) {
    const double fragments = double(scene.fragmentSamples) / picture_.samples;
    const double shaded = double(scene.shadedSamples) / picture_.samples;
    const auto covered = double(scene.coveredPixels);
    std::map<std::string, double> materials;  // equal names are one
    statistics_.record(frame_, {}, "scene.fragments", fragments);
    statistics_.record(frame_, {}, "scene.shaded", shaded);
    statistics_.record(frame_, {}, "scene.covered", covered);
    for (std::size_t m = 0; m < scene.samplesOfMaterials.size(); ++m) {
        if (scene.samplesOfMaterials[m] == 0) continue;
        std::string name = m < scene_.materials.size() ? scene_.materials[m].name : "(glTF's default)";
        if (name.empty()) name = "material " + std::to_string(m);
        materials[name] += double(scene.samplesOfMaterials[m]) / picture_.samples;
    }
    for (const auto& [name, itsFragments] : materials) {
        statistics_.record(frame_, {.material = name}, "scene.fragments", itsFragments);
    }
    if (covered == 0.0) return;
    statistics_.record(frame_, {}, "scene.depthComplexity", fragments / covered);
    statistics_.record(frame_, {}, "scene.overdraw", shaded / covered);
    Distribution all, passed;
    for (std::size_t i = 0; i < scene.fragments.size(); ++i) {
        if (scene.fragments[i] == 0.0f) continue;
        all.add(scene.fragments[i]);
        passed.add(scene.shaded[i]);
    }
    statistics_.record(frame_, {}, "scene", all);
    statistics_.record(frame_, {}, "shaded", passed);
}

void FrameRecorder::finish(std::size_t lightsSkipped, std::size_t lightsFellBack) {
    double triangles = 0, edges = 0;
    for (std::uint32_t i = 0; i < geometry_.instanceCount(); ++i) {
        const MeshTopology& topology = geometry_.topologies()[geometry_.meshOf(i)];
        for (const bool casts : topology.casts) triangles += casts;
        edges += topology.figures.edges;
    }
    statistics_.record(frame_, {}, "triangles", triangles);
    statistics_.record(frame_, {}, "casters", double(casters_.size()));
    statistics_.record(frame_, {}, "edges", edges);
    statistics_.record(frame_, {}, "lights.fellBack", double(lightsFellBack));
    statistics_.record(frame_, {}, "lights.skipped", double(lightsSkipped));
    for (const PlacedLight& light : moment_.lights) {
        if (!isOn(light.light)) statistics_.record(frame_, {.light = light.id}, "lights.skipped", 1.0);
    }
    recordActivity(frame_, begin_, statistics_);
    const auto tiles = [](int pixels) { return (pixels + kTile - 1) / kTile; };
    statistics_.record(frame_, {}, "tiles", double(tiles(picture_.width)) * tiles(picture_.height));
    if (fragments_.empty()) return;
    FillSums all;
    for (std::size_t i = 0; i < casters_.size(); ++i) {
        if (casters_[i].fragments() > 0) {
            record({.caster = scene_.nodes[std::size_t(moment_.instances[i].node)].path}, casters_[i]);
        }
        all.add(casters_[i]);
    }
    record({}, all);
    recordPixels({}, fragments_, updates_);
}

}  // namespace umbrage
