// SPDX-License-Identifier: Apache-2.0
// Our own scenes: z-pass with the eye constant and z-fail are two different sums over the same volumes, so their masks
// and counts must agree (lemma L2), but for pixels on a shadow boundary where caps and sides are rasterised apart.
//
// A few small frames of each on every run; all frames with UMBRAGE_ALL_FRAMES=small, or at their own size with =own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "frame/frame.h"
#include "frame/settings.h"
#include "job/job.h"
#include "scene/compose.h"
#include "techniques.h"

namespace umbrage::test {
namespace {

struct Agreement {
    std::uint64_t pixels = 0, maskDiffers = 0, countDiffers = 0, offBoundary = 0, skipsDiffer = 0, splitDiffers = 0;
    int worstFrame = 0;
    std::uint64_t worst = 0;
};

/// Whether some pixel around (x, y) has another value: only there may two rasterisations differ.
template <class T>
bool onBoundary(const std::vector<T>& plane, int width, int height, int x, int y) {
    const T here = plane[std::size_t(y * width + x)];
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
            if (plane[std::size_t(v * width + u)] != here) return true;
        }
    }
    return false;
}

TEST(Textbook, ZPassWithoutTheEyeConstantIsWrongInNestedVolumes) {
    const Job job = readJob(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs/nested.yaml");
    const Composition composition = compose(job);
    const Moment moment = evaluate(composition.scene, composition.animations, 0.0);
    const PlacedCamera camera = placeCamera(composition.scene, moment, composition.cameraNode);
    FrameSettings settings;
    settings.width = 256;
    settings.height = 192;
    FrameOutputs outputs;
    outputs.shadows = true;
    Statistics statistics;
    const FramePixels right =
        FrameRenderer(composition.scene, moment, settings, context()).render(moment, camera, outputs, 1, statistics);
    settings.eyeConstant = false;
    const FramePixels wrong =
        FrameRenderer(composition.scene, moment, settings, context()).render(moment, camera, outputs, 1, statistics);
    std::size_t differs = 0;
    for (std::size_t i = 0; i < right.lights[0].shadow.size(); ++i) {
        differs += right.lights[0].shadow[i] != wrong.lights[0].shadow[i];
    }
    EXPECT_GT(differs, right.lights[0].shadow.size() / 10);
}

class Sequence : public testing::TestWithParam<std::string> {};

TEST_P(Sequence, TheHostResolvesAsTheDeviceDoes) {
    const Job job = readJob(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs" / (GetParam() + ".yaml"));
    const Composition composition = compose(job);
    FrameSettings settings = settingsOf(job, composition);
    settings.width = 129;  // no whole vectors
    settings.height = 96;
    settings.samples = 1;
    const PlacedMoment now = placedMoment(job, composition, 7);
    const auto radiance = [&](bool onHost) {
        settings.resolveOnHost = onHost;
        Statistics statistics;
        return FrameRenderer(composition.scene, now.moment, settings, context())
            .render(now.moment, now.camera, {}, 7, statistics)
            .radiance;
    };
    const std::vector<float> host = radiance(true), device = radiance(false);
    ASSERT_EQ(host.size(), device.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < host.size(); ++i) {
        ASSERT_NEAR(host[i], device[i], 2e-3 * (0.01 + std::abs(device[i]))) << i;
        sum += device[i];
    }
    EXPECT_GT(sum, 0.0);
}

TEST_P(Sequence, PassAndFailAgree) {
    const char* allFrames = std::getenv("UMBRAGE_ALL_FRAMES");
    const bool ownSize = allFrames && std::string(allFrames) == "own";
    Job job = readJob(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs" / (GetParam() + ".yaml"));
    if (!ownSize) {
        job.image.width = 256;
        job.image.height = 192;
    }
    if (!allFrames) {
        const std::vector<int>& frames = job.time.frames.frames();
        const int last = frames.back();
        job.time.frames = frames.size() > 1 ? FrameRange::parse("1," + std::to_string(last), "test") : job.time.frames;
    }
    const Composition composition = compose(job);
    const auto momentOf = [&](int frame) {
        return evaluate(composition.scene, composition.animations, frame / job.time.framesPerSecond);
    };
    FrameSettings settings;
    settings.width = job.image.width;
    settings.height = job.image.height;
    settings.endVolumes = false;  // which moves corners
    const Moment first = momentOf(job.time.frames.frames().front());
    settings.count = "z-pass";
    FrameRenderer pass(composition.scene, first, settings, context());
    settings.count = "z-fail";
    FrameRenderer fail(composition.scene, first, settings, context());
    settings.count = "split-plane";
    FrameRenderer split(composition.scene, first, settings, context());
    FrameOutputs outputs;
    outputs.shadows = outputs.counts = true;

    Agreement total;
    for (const int frame : job.time.frames.frames()) {
        const Moment moment = momentOf(frame);
        const PlacedCamera camera = placeCamera(composition.scene, moment, composition.cameraNode);
        Statistics statistics;
        const FramePixels a = pass.render(moment, camera, outputs, frame, statistics);
        const FramePixels b = fail.render(moment, camera, outputs, frame, statistics);
        FrameOutputs masksOnly;
        masksOnly.shadows = true;  // with all skips
        const FramePixels c = pass.render(moment, camera, masksOnly, frame, statistics);
        const FramePixels d = split.render(moment, camera, masksOnly, frame, statistics);
        ASSERT_EQ(a.lights.size(), b.lights.size());
        total.skipsDiffer += a.radiance != c.radiance;
        std::uint64_t differs = 0;
        for (std::size_t l = 0; l < a.lights.size(); ++l) {
            for (int y = 0; y < settings.height; ++y) {
                for (int x = 0; x < settings.width; ++x) {
                    const auto i = std::size_t(y * settings.width + x);
                    ++total.pixels;
                    total.skipsDiffer += a.lights[l].shadow[i] != c.lights[l].shadow[i];
                    total.countDiffers += a.lights[l].counts[i] != b.lights[l].counts[i];
                    const float both = d.lights[l].shadow[i];
                    total.splitDiffers += both != a.lights[l].shadow[i] && both != b.lights[l].shadow[i];
                    if (a.lights[l].shadow[i] == b.lights[l].shadow[i]) continue;
                    ++differs;
                    total.offBoundary += !onBoundary(a.lights[l].shadow, settings.width, settings.height, x, y) &&
                                         !onBoundary(b.lights[l].shadow, settings.width, settings.height, x, y);
                }
            }
        }
        total.maskDiffers += differs;
        if (differs > total.worst) {
            total.worst = differs;
            total.worstFrame = frame;
        }
    }
    std::printf(
        "%s: %zu frames, %llu pixels x lights: masks differ in %llu, off boundaries %llu, counts in %llu; "
        "worst frame %d with %llu\n",
        GetParam().c_str(), job.time.frames.frames().size(), static_cast<unsigned long long>(total.pixels),
        static_cast<unsigned long long>(total.maskDiffers), static_cast<unsigned long long>(total.offBoundary),
        static_cast<unsigned long long>(total.countDiffers), total.worstFrame,
        static_cast<unsigned long long>(total.worst));
    EXPECT_EQ(total.offBoundary, 0u);
    EXPECT_EQ(total.splitDiffers, 0u) << "split-plane makes the choice of one of them at every pixel";
    EXPECT_EQ(total.skipsDiffer, 0u) << "skips must not change a bit of picture or masks";
    EXPECT_LE(double(total.maskDiffers), 1e-5 * double(total.pixels));
}

std::vector<std::string> sequences() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs")) {
        if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Own, Sequence, testing::ValuesIn(sequences()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace umbrage::test
