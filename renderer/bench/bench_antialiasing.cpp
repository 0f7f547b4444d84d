// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_antialiasing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/stopwatch.h"
#include "diagnostics/median.h"
#include "frame/accumulate.h"

namespace umbrage {
namespace {

/// A way to antialias one sequence.
struct Way {
    bool isAccumulation;
    int count;
    std::unique_ptr<FrameRenderer> renderer;
    std::vector<double> milliseconds;  // of each frame in each round
    double squares = 0.0;              // of differences, summed over frames and channels
    double values = 0.0;

    double rmse() const { return std::sqrt(squares / values); }
};

/// Numbers of samples that the device has; asked for another one it takes the next greater.
std::vector<int> sampleCounts(const gpu::Context& context) {
    GLint number = 0;
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, GL_RGBA32F, GL_NUM_SAMPLE_COUNTS, 1, &number);
    std::vector<GLint> counts(static_cast<std::size_t>(number));
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, GL_RGBA32F, GL_SAMPLES, number, counts.data());
    std::erase_if(counts, [&](GLint count) { return count < 2 || count > context.maxSamples(); });
    std::ranges::sort(counts);
    return counts;
}

/// Display values, three a pixel.
std::vector<float> displayed(std::vector<float> radiance, const DisplayTransform& display) {
    display.apply(radiance);
    std::vector<float> rgb;
    rgb.reserve(radiance.size() / 4 * 3);
    for (std::size_t i = 0; i < radiance.size(); i += 4) rgb.insert(rgb.end(), &radiance[i], &radiance[i] + 3);
    return rgb;
}

std::vector<float> render(FrameRenderer& renderer, const PlacedMoment& now, int frame) {
    Statistics unused;
    return renderAccumulated(renderer, now, {}, frame, unused).radiance;
}

class Antialiased {
public:
    Antialiased(const Bench& bench, const BenchScene& scene, const gpu::Context& context)
        : bench_(bench), scene_(scene), context_(context) {
        const Job::Color& color = scene.job.color;
        display_ = codec().displayTransform({color.config, color.display, color.view, color.exposureStops});
        for (const int samples : sampleCounts(context)) add(false, samples);
        for (const int pictures : bench.accumulation) add(true, pictures);
    }

    void judge(BenchObserver& observer, const std::atomic<bool>& interrupted) {
        const auto reference = renderer(1, bench_.referencePictures);
        for (const int frame : scene_.frames) {
            const PlacedMoment now = scene_.at(frame);
            const std::vector<float> exact = displayed(render(*reference, now, frame), *display_);
            for (Way& way : ways) {
                if (interrupted) return;
                const std::vector<float> rgb = displayed(render(*way.renderer, now, frame), *display_);
                for (std::size_t i = 0; i < rgb.size(); ++i) way.squares += std::pow(double(rgb[i]) - exact[i], 2.0);
                way.values += double(rgb.size());
            }
            observer.advanced(fmt::format("{} frame {}: judged", scene_.sequence.name, frame));
        }
    }

    void round(bool backwards) {
        for (std::size_t i = 0; i < ways.size(); ++i) {
            Way& way = ways[backwards ? ways.size() - 1 - i : i];
            for (const int frame : scene_.frames) {
                const Stopwatch watch;
                render(*way.renderer, scene_.at(frame), frame);
                way.milliseconds.push_back(watch.milliseconds());
            }
        }
    }

    const BenchScene& scene() const { return scene_; }
    std::vector<Way> ways;

private:
    std::unique_ptr<FrameRenderer> renderer(int samples, int pictures) const {
        const std::vector<BenchTechnique>& techniques = bench_.techniques;
        const Job job = techniques.empty() ? scene_.job : techniques.front().of(scene_.job);
        FrameSettings settings = settingsOf(job, scene_.composition);
        settings.samples = samples;
        settings.accumulation = pictures;
        settings.profile = false;
        return scene_.renderer(settings, context_);
    }
    void add(bool isAccumulation, int count) {
        ways.push_back({isAccumulation, count, isAccumulation ? renderer(1, count) : renderer(count, 1), {}, 0.0, 0.0});
    }

    const Bench& bench_;
    const BenchScene& scene_;
    const gpu::Context& context_;
    std::unique_ptr<DisplayTransform> display_;
};

void report(const Antialiased& one, BenchTable& table, BenchResult& result) {
    const std::string& name = one.scene().sequence.name;
    PlotSeries samples{"samples", {}}, pictures{"pictures", {}};
    for (const Way& way : one.ways) {
        const double milliseconds = median(way.milliseconds), codes = 255.0 * way.rmse();
        table.rows.push_back(
            {name, fmt::format("{} {}", way.count, way.isAccumulation ? "pictures" : "samples"), milliseconds, codes});
        (way.isAccumulation ? pictures : samples).points.emplace_back(milliseconds, codes);
    }
    std::ranges::sort(samples.points);
    std::ranges::sort(pictures.points);
    Plot plot{name + ": antialiasing",
              "a frame (ms)",
              "difference from a converged frame (root of the mean square, display codes of 255)",
              {},
              PlotScale::Logarithmic};
    plot.series = {samples, pictures};
    result.plots.emplace_back("antialiasing-" + name, std::move(plot));
}

}  // namespace

void measureAntialiasing(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context,
                         BenchObserver& observer, const std::atomic<bool>& interrupted, BenchResult& result) {
    BenchTable& table = result.tables.emplace_back(BenchTable{
        "antialiasing",
        "Antialiasing",
        {{"sequence", "sequence", "", -1},
         {"way", "way", "samples a pixel, or pictures that the frame is the mean of", -1},
         {"frame.ms", "frame ms", "a frame evaluated, rendered and read back; median", 2},
         {"rmse", "difference", "root of the mean square over pixels, channels and frames, display codes", 3}},
        {},
        {}});
    table.remarks.push_back(
        fmt::format("{} rounds, frames by the wall's clock; the converged frame is the mean of {} pictures at other "
                    "places in the pixels.",
                    bench.rounds, bench.referencePictures));
    for (const BenchScene* scene : scenes) {
        observer.started(scene->frames.size() + std::size_t(bench.rounds), "antialiasing of " + scene->sequence.name);
        Antialiased one(bench, *scene, context);
        one.judge(observer, interrupted);  // which warms up, too
        for (int round = 0; round < bench.rounds && !interrupted; ++round) {
            one.round(round % 2 != 0);
            observer.advanced(fmt::format("{}: round {}", scene->sequence.name, round + 1));
        }
        if (interrupted) return;
        report(one, table, result);
    }
}

}  // namespace umbrage
