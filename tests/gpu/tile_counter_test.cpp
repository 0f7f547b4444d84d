// SPDX-License-Identifier: Apache-2.0
// The tile counter beside the device: two rasterisers that share nothing count the same updates and the same layers, as
// far as the device's grid of 1/256 pixel lets them.
#include "bench/tile_counter.h"

#include <nlohmann/json.hpp>

#include "bench/tile_casters.h"
#include "shading/lights.h"
#include "subjects.h"

namespace umbrage::test {
namespace {

/// A frame by the device, with all its numbers, and what the tile counter makes of it.
struct Both {
    Both(const Subject& subject, const How& how, Weights weights) : moment(subject.moment()) {
        FrameRenderer renderer(subject.scene, moment, subject.settings(how), context());
        FrameOutputs outputs;
        outputs.geometry = outputs.overdraw = outputs.figures = true;
        outputs.counts = how.counts;
        Statistics statistics;
        pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
        json = nlohmann::json::parse(statistics.file({}).json())["frames"][0];
        const Eye eye = makeEye(subject.camera, subject.width, subject.height);
        const TileView view(eye, subject.width, subject.height);
        Truth truth(subject.scene);
        truth.update(moment, renderer.geometry());
        const auto casters = tileCasters(subject.scene, moment, renderer.geometry(), truth, eye, {}, weights);
        const std::vector<double> depths = inverseDepthsOf(pixels, casters, eye, view);
        for (const PlacedLight& light : moment.lights) {
            std::vector<TileVolume> volumes;
            for (const TileCaster& caster : casters) {
                volumes.push_back(tileVolume(caster, shadowLight(light), {}, eye, view));
            }
            counts.push_back(countTiles(volumes, depths, view, false, 2));
        }
    }

    double device(std::size_t light, const char* counter) const {
        return json["lights"][pixels.lights[light].id]["values"].value(counter, 0.0);
    }
    double ours(std::size_t light, std::string_view method) const {
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            if (kTileMethods[m].name == method) return double(counts[light].methods[m].updates);
        }
        return 0.0;
    }
    bool isOn(std::size_t light) const { return umbrage::isOn(moment.lights[light].light); }

    Moment moment;
    FramePixels pixels;
    nlohmann::json json;
    std::vector<TileCounts> counts;  // per light
};

/// With few casters, all of them in the depth buffer and away from the eye: the device halves their sides.
std::vector<Subject> plain() {
    return {solid(ours("knight", 320, 240)), solid(ours("tree", 320, 240)), solid(ours("pole", 320, 240))};
}

std::vector<Subject> allSubjects() {
    std::vector<Subject> all = plain();
    all.push_back(solid(ours("courtyard", 256, 192)));
    return all;
}

TEST(TilesAndDevice, UpdateAsOftenByZPass) {
    std::size_t lights = 0;
    for (const Subject& subject : plain()) {
        const Both both(subject, {.skipOutOfReach = false}, Weights::Least);
        for (std::size_t l = 0; l < both.moment.lights.size(); ++l) {
            if (!both.isOn(l)) continue;
            const double updates = both.device(l, "overdraw.updates");
            EXPECT_NEAR(both.ours(l, "ZP"), updates, 1e-3 * updates) << subject.name << " " << both.pixels.lights[l].id;
            EXPECT_GT(updates, 1000.0);
            ++lights;
        }
    }
    EXPECT_GE(lights, 3u);
}

TEST(TilesAndDevice, UpdateAsOftenByZFail) {
    std::size_t lights = 0;
    for (const Subject& subject : allSubjects()) {
        const How how{.technique = {"compute", "z-fail"}, .skipOutOfReach = false, .endVolumes = false};
        const Both both(subject, how, Weights::TwoSided);
        for (std::size_t l = 0; l < both.moment.lights.size(); ++l) {
            if (!both.isOn(l)) continue;
            const double updates = both.device(l, "overdraw.updates");
            EXPECT_NEAR(both.ours(l, "ZF"), updates, 2e-3 * updates) << subject.name << " " << both.pixels.lights[l].id;
            ++lights;
        }
    }
    EXPECT_GE(lights, 3u);
}

TEST(TilesAndDevice, CountTheSameLayers) {
    std::size_t different = 0, dark = 0, all = 0;
    for (const Subject& subject : allSubjects()) {
        const Both both(subject, {.counts = true}, Weights::TwoSided);
        for (std::size_t l = 0; l < both.moment.lights.size(); ++l) {
            if (!both.isOn(l)) continue;
            for (std::size_t i = 0; i < both.counts[l].layers.size(); ++i) {
                const std::uint32_t theirs = both.pixels.lights[l].counts[i];
                different += std::uint32_t(both.counts[l].layers[i]) != theirs;
                dark += theirs > 0;
                ++all;
            }
        }
    }
    std::printf("%zu of %zu counts differ, on borders; %zu are dark\n", different, all, dark);
    EXPECT_GT(dark, all / 20);
    EXPECT_LT(double(different), 2e-4 * double(all));
}

}  // namespace
}  // namespace umbrage::test
