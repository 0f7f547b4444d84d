// SPDX-License-Identifier: Apache-2.0
// What it costs to compare two pictures of 1024x768, next to reading them.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "golden/metrics.h"

namespace umbrage {
namespace {

constexpr int kWidth = 1024, kHeight = 768;

/// Smooth colours with noise on them, like a shaded picture. `changed`: in a square of 64 pixels, or `everywhere`.
StoredImage picture(bool displayEncoded, bool changed, bool everywhere) {
    StoredImage image;
    image.data = image.display = {0, 0, kWidth, kHeight};
    image.displayEncoded = displayEncoded;
    std::mt19937 random(1);
    for (int c = 0; c < 3; ++c) {
        std::vector<float> values;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool here = changed && (everywhere || (x / 64 == 5 && y / 64 == 7));
                const float shade = float((x * (c + 1) + y * (3 - c)) % 512) / 640.0f + float(random() % 64) / 640.0f;
                values.push_back((displayEncoded ? 1.0f : 8.0f) * shade * (here ? 0.95f : 1.0f));
            }
        }
        image.channels.push_back({std::string("BGR").substr(c, 1), PixelType::Half, values});
    }
    return image;
}

void measured(benchmark::State& state, const std::vector<std::string>& wanted, bool displayEncoded, bool everywhere) {
    const StoredImage golden = picture(displayEncoded, false, false);
    const StoredImage output = picture(displayEncoded, true, everywhere);
    double value = 0.0;
    for (auto _ : state) value = measure(golden, output, {.tolerance = 0.01}, wanted).figures.back().value;
    state.counters["value"] = value;
}

void reading(benchmark::State& state, const char* extension) {
    const StoredImage image = picture(true, false, false);
    const auto file = std::filesystem::temp_directory_path() / (std::string("umbrage-compare-bench.") + extension);
    ImageFile written{kWidth, kHeight, {}, {}};
    const bool png = file.extension() == ".png";
    for (const char* name : {"R", "G", "B"}) {
        written.channels.push_back({name, png ? PixelType::UInt8 : PixelType::Half, image.floats(name)->data(), 1});
    }
    codec().write(file, written);
    for (auto _ : state) benchmark::DoNotOptimize(codec().read(file).channels.size());
    std::filesystem::remove(file);
}

const std::vector<std::string> kPlain{"max-abs", "mean-abs", "rmse", "psnr", "max-relative", "fraction", "densest"};

BENCHMARK_CAPTURE(reading, png, "png")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reading, exr, "exr")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measured, plain, kPlain, true, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measured, flip, {"flip"}, true, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measured, flipOfASquare, {"flip"}, true, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measured, hdrFlip, {"hdr-flip"}, false, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measured, yee, {"yee"}, true, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace umbrage

BENCHMARK_MAIN();
