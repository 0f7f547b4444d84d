// SPDX-License-Identifier: Apache-2.0
// Metamorphic tests: what must hold between two pictures of one scene, whatever is right in each. M1: techniques count
// alike; M6: skips; M7: repetition; M8: casters add up; M9: lights add up. Those that change the scene are in
// metamorphic_scenes_test.cpp.
#include "subjects.h"

namespace umbrage::test {
namespace {

bool isSurface(std::uint32_t seen) {
    return seen != NO_TRIANGLE && seen != LINE_OR_POINT;
}

std::uint32_t countMask(const LightPlanes& a, const LightPlanes& b) {
    return a.countsAreWide && b.countsAreWide ? ~0u : 0xffu;
}

/// Pixels of surfaces, summed over lights, whose counts differ.
std::size_t countDifferences(const FramePixels& a, const FramePixels& b) {
    std::size_t differences = 0;
    for (std::size_t l = 0; l < a.lights.size(); ++l) {
        const std::uint32_t mask = countMask(a.lights[l], b.lights[l]);
        for (std::size_t i = 0; i < a.lights[l].counts.size(); ++i) {
            const bool differs = ((a.lights[l].counts[i] ^ b.lights[l].counts[i]) & mask) != 0;
            differences += isSurface(a.seen.triangles[i]) && differs;
        }
    }
    return differences;
}

TEST(Metamorphic, M1AllTechniquesCountTheSameLayersOrMakeTheSameMasks) {
    std::size_t layers = 0;
    for (const Subject& subject : subjects()) {
        SCOPED_TRACE(subject.name);
        How how;
        how.counts = true;
        const FramePixels reference = picture(subject, how);
        for (const LightPlanes& light : reference.lights) {
            for (std::size_t i = 0; i < light.counts.size(); ++i) {
                if (isSurface(reference.seen.triangles[i])) layers += light.counts[i];
            }
        }
        for (const Technique& technique : allTechniques()) {
            SCOPED_TRACE(technique.name());
            how.technique = technique;
            const FramePixels other = picture(subject, how);
            // Volumes that are cut have other corners, which round anew; those that end count nothing beyond a light's
            // range; parity is no count; and what a geometry stage makes is rounded otherwise on llvmpipe
            // (docs/silhouettes.md). On borders these may differ. More where a technique snaps no corners to a grid of
            // 1/256 pixel, as the device does.
            const bool sameCorners =
                technique.count == "z-pass" || technique.count == "z-fail" || technique.count == "split-plane";
            if (technique.silhouette == "geometry-shader") {
                EXPECT_LE(maskDifferences(reference, other), reference.seen.triangles.size() / 200);
            } else if (sameCorners) {
                EXPECT_EQ(countDifferences(reference, other), 0u);
                EXPECT_EQ(maskDifferences(reference, other), 0u);
            } else if (technique.count == "tiles") {
                const std::size_t samples = reference.seen.triangles.size() * reference.lights.size();
                EXPECT_LE(maskDifferences(reference, other), samples / 1000);
            } else {
                EXPECT_LE(maskDifferences(reference, other), 4u);
            }
        }
    }
    EXPECT_GT(layers, 10000u) << "there must be something to count";
}

TEST(Metamorphic, M6SkipsChangeNoBit) {
    std::size_t shadow = 0;
    for (const Subject& subject : subjects()) {
        SCOPED_TRACE(subject.name);
        How how;
        how.halve = how.skipOutOfReach = how.skipOutOfView = how.endVolumes = false;
        const FramePixels byDevice = picture(subject, how);
        shadow += shadowed(subject, byDevice);
        how.technique.count = "tiles";  // which snaps no corners, so it is compared with itself
        const FramePixels byTiles = picture(subject, how);
        for (const bool halve : {false, true}) {
            for (const std::string count : {"z-pass", "z-fail", "tiles"}) {
                SCOPED_TRACE((halve ? "halve, " : "range and view, ") + count);
                const FramePixels& without = count == "tiles" ? byTiles : byDevice;
                how.technique.count = count;
                how.halve = halve;
                how.skipOutOfReach = how.skipOutOfView = !halve;
                const FramePixels with = picture(subject, how);
                EXPECT_EQ(maskDifferences(without, with), 0u);
                if (maskDifferences(without, with) == 0) {
                    EXPECT_EQ(without.radiance, with.radiance);
                }
            }
        }
    }
    EXPECT_GT(shadow, 1000u) << "there must be shadows";
}

void expectSameBits(const FramePixels& a, const FramePixels& b) {
    EXPECT_EQ(a.radiance, b.radiance);
    EXPECT_EQ(a.seen.triangles, b.seen.triangles);
    EXPECT_EQ(maskDifferences(a, b), 0u);
    EXPECT_EQ(countDifferences(a, b), 0u);
}

TEST(Metamorphic, M7AFrameIsTheSameAgainAndAfterAnother) {
    std::size_t shadow = 0, changes = 0;
    for (const Subject& subject : subjects()) {
        SCOPED_TRACE(subject.name);
        const Moment moment = subject.moment(), later = evaluate(subject.scene, subject.animations, 1.7);
        // Elsewhere: what is kept relative to the eye moves with it.
        PlacedCamera elsewhere = subject.camera;
        elsewhere.worldFromCamera[3] += glm::dvec4(1234.5, -67.8, 910.1, 0.0);
        PlacedCamera beside = subject.camera;
        beside.worldFromCamera[3] += glm::dvec4(0.25, 0.5, -0.125, 0.0);
        FrameOutputs outputs;
        outputs.samples = true;
        Statistics statistics;
        FrameRenderer renderer(subject.scene, moment, subject.settings(), context());
        const FramePixels first = renderer.render(moment, subject.camera, outputs, 1, statistics);
        shadow += shadowed(subject, first);
        expectSameBits(first, renderer.render(moment, subject.camera, outputs, 1, statistics));
        const FramePixels other = renderer.render(later, beside, outputs, 2, statistics);
        changes += maskDifferences(first, other);
        expectSameBits(first, renderer.render(moment, subject.camera, outputs, 1, statistics));
        FrameOutputs more = outputs;
        more.counts = more.overdraw = more.figures = more.geometry = true;
        renderer.render(moment, elsewhere, more, 3, statistics);
        expectSameBits(first, renderer.render(moment, subject.camera, outputs, 1, statistics));
    }
    EXPECT_GT(shadow, 1000u) << "there must be shadows";
    EXPECT_GT(changes, 1000u) << "the frame between must be another one";
}

/// The moment without all instances but these.
Moment only(Moment moment, const std::vector<std::size_t>& kept) {
    std::vector<Instance> instances;
    for (const std::size_t i : kept) instances.push_back(moment.instances[i]);
    moment.instances = std::move(instances);
    return moment;
}

/// Of every pixel, the instance that is seen.
std::vector<std::size_t> seenInstances(const Subject& subject, const Moment& moment) {
    FrameOutputs outputs;
    outputs.samples = true;
    Statistics statistics;
    FrameRenderer renderer(subject.scene, moment, subject.settings(), context());
    const FramePixels pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
    const std::vector<gpu::InstanceData>& instances = renderer.geometry().instances();
    std::vector<std::size_t> seen;
    for (const std::uint32_t triangle : pixels.seen.triangles) {
        const auto next =
            std::ranges::upper_bound(instances, triangle, std::less<>(), &gpu::InstanceData::placedTriangleBase);
        seen.push_back(isSurface(triangle) ? std::size_t(next - instances.begin()) - 1 : instances.size());
    }
    return seen;
}

/// On the receiver that is seen most: what it alone counts, and what each other caster adds to that.
TEST(Metamorphic, M8CountsOfSeparateCastersAddUp) {
    std::size_t layers = 0, casters = 0;
    for (const Subject& subject : subjects()) {
        const Moment moment = subject.moment();
        if (moment.instances.size() < 2 || moment.instances.size() > 24) continue;
        SCOPED_TRACE(subject.name);
        const std::vector<std::size_t> seen = seenInstances(subject, moment);
        std::size_t receiver = 0;
        for (std::size_t i = 1; i < moment.instances.size(); ++i) {
            if (std::ranges::count(seen, i) > std::ranges::count(seen, receiver)) receiver = i;
        }
        How how;
        how.counts = true;
        const FramePixels together = picture(subject, moment, how),
                          alone = picture(subject, only(moment, {receiver}), how);
        std::vector<std::vector<std::uint32_t>> sums;
        for (const LightPlanes& light : alone.lights) sums.push_back(light.counts);
        for (std::size_t i = 0; i < moment.instances.size(); ++i) {
            if (i == receiver) continue;
            ++casters;
            const FramePixels two = picture(subject, only(moment, {std::min(i, receiver), std::max(i, receiver)}), how);
            for (std::size_t l = 0; l < sums.size(); ++l) {
                for (std::size_t p = 0; p < sums[l].size(); ++p)
                    sums[l][p] += two.lights[l].counts[p] - alone.lights[l].counts[p];
            }
        }
        std::size_t differences = 0;
        for (std::size_t l = 0; l < sums.size(); ++l) {
            for (std::size_t p = 0; p < seen.size(); ++p) {
                if (seen[p] != receiver) continue;
                differences += ((sums[l][p] ^ together.lights[l].counts[p]) & 0xffu) != 0;
                layers += together.lights[l].counts[p];
            }
        }
        EXPECT_EQ(differences, 0u);
    }
    EXPECT_GT(casters, 20u);
    EXPECT_GT(layers, 1000u) << "there must be something to count";
}

/// Removing lights: what remains, what is taken away and what shines by itself make up the whole.
TEST(Metamorphic, M9RadianceOfLightsAddsUp) {
    std::size_t shadow = 0, removed = 0;
    for (const Subject& subject : subjects()) {
        SCOPED_TRACE(subject.name);
        const Moment moment = subject.moment();
        if (moment.lights.size() < 2) continue;
        Moment dark = moment;
        dark.lights.clear();
        const FramePixels all = picture(subject, moment), none = picture(subject, dark);
        shadow += shadowed(subject, all);
        double largest = 0.0;
        for (std::size_t l = 0; l < moment.lights.size(); l += 3) {
            ++removed;
            Moment without = moment, alone = dark;
            without.lights.erase(without.lights.begin() + std::ptrdiff_t(l));
            alone.lights.push_back(moment.lights[l]);
            const FramePixels rest = picture(subject, without), one = picture(subject, alone);
            EXPECT_EQ(one.lights[0].reaches, all.lights[l].reaches) << "other lights must not matter to a mask";
            for (std::size_t i = 0; i < all.radiance.size(); ++i) {
                if (i % 4 == 3) continue;
                const double sum = double(rest.radiance[i]) + double(one.radiance[i]) - double(none.radiance[i]);
                largest = std::max(
                    largest, std::abs(sum - double(all.radiance[i])) / (1e-3 + std::abs(double(all.radiance[i]))));
            }
        }
        EXPECT_LT(largest, 1e-5);
    }
    EXPECT_GT(removed, 10u);
    EXPECT_GT(shadow, 1000u) << "there must be shadows";
}

}  // namespace
}  // namespace umbrage::test
