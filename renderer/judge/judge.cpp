// SPDX-License-Identifier: Apache-2.0
#include "judge/judge.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <thread>

#include "judge/components.h"
#include "judge/explain.h"
#include "judge/truth.h"
#include "shaders/shared.h"

namespace umbrage {

using oracle::EyeRay;
using oracle::kNothing;

namespace {

constexpr double kQuarterPi = 0.78539816339744831;

/// Calls work(row) for all rows on several threads.
template <class Work>
void forRows(int rows, int threads, const Work& work) {
    std::atomic<int> next{0};
    std::vector<std::jthread> pool;
    for (int t = 0; t < threads; ++t) {
        pool.emplace_back([&] {
            for (int row = next++; row < rows; row = next++) work(row);
        });
    }
}

}  // namespace

struct Judge::Impl {
    const Scene& scene;
    int width, height, threads;
    Tolerance tolerance;
    Truth truth;

    // The frame:
    std::optional<oracle::EyeRays> rays;
    std::vector<glm::vec2> positions;    // of samples in their pixel
    std::vector<std::uint32_t> claimed;  // oracle's number of what the renderer sees, kNothing: background
    std::vector<bool> judged;            // no line or point there
    std::vector<std::uint32_t> seen;
    std::vector<JudgedLight> lights;
    std::vector<std::string> lightIds;
    std::vector<std::vector<std::uint8_t>> facing, reaches;  // per light and sample
    double farthest = 0.0, milliseconds = 0.0;
    std::optional<Explainer> explainer;
    /// Of a light's exact shadow.
    struct Outline {
        double lengthPixels = 0.0;
        std::uint64_t bandPopulation = 0;
    };
    std::vector<Outline> outlines;

    /// The frame that a technique was judged at before, for toggles: per light and sample.
    struct Before {
        std::vector<std::vector<std::uint8_t>> masks, exact;
    };
    std::map<std::string, Before> before;  // per technique

    Impl(const Scene& s, int w, int h, const Tolerance& t, int threadCount)
        : scene(s),
          width(w),
          height(h),
          threads(threadCount > 0 ? threadCount : std::max(1, int(std::thread::hardware_concurrency()))),
          tolerance(t),
          truth(s) {}

    std::size_t pixelCount() const { return std::size_t(width) * std::size_t(height); }
    /// Pixel coordinates of a sample.
    glm::dvec2 placeOf(std::size_t i) const {
        const std::size_t pixel = i % pixelCount();
        return glm::dvec2(positions[i / pixelCount()]) +
               glm::dvec2(double(pixel % std::size_t(width)), double(pixel / std::size_t(width)));
    }
    Explainer::Sample sampleAt(std::size_t i) const { return {placeOf(i).x, placeOf(i).y, seen[i], claimed[i]}; }

    void findExact();
    Outline outlineOf(std::size_t l) const;
    LightVerdict judgeLight(std::size_t l, const LightPlanes& planes, std::vector<SampleVerdict>& verdicts) const;
    void judgeCounts(std::size_t l, const LightPlanes& planes, LightVerdict& verdict) const;
};

/// Stage one: what is seen at every sample, and which lights reach it.
void Judge::Impl::findExact() {
    const auto start = std::chrono::steady_clock::now();
    const oracle::Oracle& oracle = truth.oracle();
    seen.assign(claimed.size(), kNothing);
    facing.assign(lights.size(), std::vector<std::uint8_t>(claimed.size()));
    reaches = facing;
    std::vector<double> farthestOfRow(positions.size() * std::size_t(height));
    forRows(int(farthestOfRow.size()), threads, [&](int row) {
        for (std::size_t i = std::size_t(row) * std::size_t(width); i < std::size_t(row + 1) * std::size_t(width);
             ++i) {
            const glm::dvec2 at = placeOf(i);
            const EyeRay ray = rays->at(at.x, at.y);
            seen[i] = oracle.see(ray, claimed[i]);
            if (seen[i] == kNothing) continue;
            farthestOfRow[std::size_t(row)] =
                std::max(farthestOfRow[std::size_t(row)], oracle.distanceTo(seen[i], ray));
            for (std::size_t l = 0; l < lights.size(); ++l) {
                const Exactly answer = exactly(oracle, lights[l], seen[i], ray);
                facing[l][i] = answer.facing;
                reaches[l][i] = answer.reaches;
            }
        }
    });
    farthest = *std::ranges::max_element(farthestOfRow);
    milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

LightVerdict Judge::Impl::judgeLight(std::size_t l, const LightPlanes& planes,
                                     std::vector<SampleVerdict>& verdicts) const {
    LightVerdict verdict;
    verdict.light = lightIds[l];
    verdict.samplesPerPixel = int(positions.size());
    verdict.boundaryLength = outlines[l].lengthPixels;
    verdict.bandPopulation = outlines[l].bandPopulation;
    std::vector<SampleVerdict> perSample(seen.size(), SampleVerdict::Right);
    forRows(int(seen.size() / std::size_t(width)), threads, [&](int row) {
        for (std::size_t i = std::size_t(row) * std::size_t(width); i < std::size_t(row + 1) * std::size_t(width);
             ++i) {
            if (!judged[i] || planes.reaches[i] == reaches[l][i]) continue;
            perSample[i] = explainer->explainMask(lights[l], sampleAt(i), planes.reaches[i] != 0);
        }
    });
    std::vector<bool> wrong(pixelCount());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        verdict.litFacing += facing[l][i];
        verdict.exactDark += facing[l][i] && !reaches[l][i];
        const SampleVerdict v = perSample[i];
        if (v == SampleVerdict::Right) continue;
        const std::size_t pixel = i % pixelCount();
        wrong[pixel] = true;
        verdicts[pixel] = std::max(verdicts[pixel], v);
        const bool dark = !planes.reaches[i];
        if (isHard(v)) {
            ++(dark ? verdict.hardFalseDark : verdict.hardFalseLit);
            continue;
        }
        ++(v == SampleVerdict::Primary   ? verdict.primary
           : v == SampleVerdict::Grazing ? verdict.grazing
                                         : verdict.boundary);
        ++(dark ? verdict.bandFalseDark : verdict.bandFalseLit);
    }
    const Component streak = largestComponent(wrong, width, height);
    verdict.largestComponent = streak.pixels;
    verdict.largestExtent = streak.extent;
    return verdict;
}

void Judge::Impl::judgeCounts(std::size_t l, const LightPlanes& planes, LightVerdict& verdict) const {
    const std::uint32_t mask = planes.countsAreWide ? ~0u : 0xffu;
    std::vector<LightVerdict> rows(static_cast<std::size_t>(height));
    forRows(height, threads, [&](int row) {
        LightVerdict& sum = rows[std::size_t(row)];
        for (std::size_t i = std::size_t(row) * std::size_t(width); i < std::size_t(row + 1) * std::size_t(width);
             ++i) {
            if (!judged[i] || seen[i] == kNothing || !lights[l].on) continue;
            const Explainer::Sample sample = sampleAt(i);
            const EyeRay ray = rays->at(sample.x, sample.y);
            const std::uint32_t exact = truth.oracle().volumesAround(lights[l].place, seen[i], ray);
            ++sum.countsJudged;
            if (((planes.counts[i] ^ exact) & mask) == 0) continue;
            ++sum.countErrors;
            const auto error = std::uint64_t(std::abs(double(planes.counts[i] & mask) - double(exact & mask)));
            sum.largestCountError =
                std::max(sum.largestCountError, std::min<std::uint64_t>(error, mask + 1ull - error));
            sum.hardCountErrors += !explainer->explainsCount(
                lights[l], sample, [&](std::uint32_t layers) { return ((planes.counts[i] ^ layers) & mask) == 0; });
        }
    });
    for (const LightVerdict& sum : rows) {
        verdict.countsJudged += sum.countsJudged;
        verdict.countErrors += sum.countErrors;
        verdict.hardCountErrors += sum.hardCountErrors;
        verdict.largestCountError = std::max(verdict.largestCountError, sum.largestCountError);
    }
}

/// The outline's length (Cauchy and Crofton: pi/4 per change along rows and columns), and around it the samples on
/// which rounding may decide.
Judge::Impl::Outline Judge::Impl::outlineOf(std::size_t l) const {
    const std::size_t rowLength = std::size_t(width);
    std::atomic<std::uint64_t> changes{0}, population{0};
    forRows(height, threads, [&](int row) {
        for (std::size_t s = 0; s < positions.size(); ++s) {
            for (std::size_t x = 0; x < rowLength; ++x) {
                const std::size_t i = s * pixelCount() + std::size_t(row) * rowLength + x;
                bool near = false;
                const auto compare = [&](std::size_t j, bool countOnce) {
                    if (reaches[l][i] == reaches[l][j]) return;
                    near = true;
                    if (countOnce && facing[l][i] && facing[l][j]) ++changes;
                };
                if (x > 0) compare(i - 1, true);
                if (row > 0) compare(i - rowLength, true);
                if (x + 1 < rowLength) compare(i + 1, false);
                if (row + 1 < height) compare(i + rowLength, false);
                if (near && judged[i] && explainer->changesNearby(lights[l], sampleAt(i), reaches[l][i])) ++population;
            }
        }
    });
    return {kQuarterPi * double(changes) / double(positions.size()), population};
}

Judge::Judge(const Scene& scene, int width, int height, const Tolerance& tolerance, int threads)
    : impl_(std::make_unique<Impl>(scene, width, height, tolerance, threads)) {}

Judge::~Judge() = default;

void Judge::setFrame(const Moment& moment, const PlacedCamera& camera, const FrameRenderer& renderer,
                     const FramePixels& pixels) {
    Impl& j = *impl_;
    j.truth.update(moment, renderer.geometry());
    j.rays.emplace(camera, j.width, j.height);
    j.positions = pixels.seen.positions;
    j.claimed.clear();
    j.judged.clear();
    for (const std::uint32_t placed : pixels.seen.triangles) {
        j.claimed.push_back(j.truth.indexOf(placed));
        j.judged.push_back(placed != LINE_OR_POINT);
    }
    j.lights.clear();
    j.lightIds.clear();
    for (const PlacedLight& light : moment.lights) {
        j.lights.emplace_back(light);
        j.lightIds.push_back(light.id);
    }
    j.findExact();
    j.explainer.emplace(j.truth.oracle(), *j.rays, j.tolerance, j.farthest);
    j.outlines.clear();
    for (std::size_t l = 0; l < j.lights.size(); ++l) j.outlines.push_back(j.outlineOf(l));
}

const std::vector<std::vector<std::uint8_t>>& Judge::exact() const {
    return impl_->reaches;
}

double Judge::oracleMilliseconds() const {
    return impl_->milliseconds;
}

FrameVerdict Judge::judge(const FramePixels& pixels, const std::string& technique, VerdictPlanes& planes) {
    Impl& j = *impl_;
    FrameVerdict verdict;
    planes.width = j.width;
    planes.height = j.height;
    planes.verdicts.assign(j.lights.size(), std::vector<SampleVerdict>(j.pixelCount(), SampleVerdict::Right));
    planes.exact.assign(j.lights.size(), std::vector<std::uint8_t>(j.pixelCount(), 1));
    std::vector<std::vector<std::uint8_t>> masks;
    Impl::Before& before = j.before[technique];
    for (std::size_t l = 0; l < j.lights.size(); ++l) {
        LightVerdict light = j.judgeLight(l, pixels.lights[l], planes.verdicts[l]);
        if (!pixels.lights[l].counts.empty()) j.judgeCounts(l, pixels.lights[l], light);
        for (std::size_t i = 0; i < j.seen.size(); ++i) {
            if (!j.reaches[l][i]) planes.exact[l][i % j.pixelCount()] = 0;
        }
        masks.push_back(pixels.lights[l].reaches);
        if (l < before.masks.size() && before.masks[l].size() == masks[l].size()) {
            for (std::size_t i = 0; i < masks[l].size(); ++i) {
                light.excessToggles += masks[l][i] != before.masks[l][i] && j.reaches[l][i] == before.exact[l][i];
            }
        }
        verdict.lights.push_back(std::move(light));
    }
    before = {std::move(masks), j.reaches};
    verdict.oracleMilliseconds = j.milliseconds;
    return verdict;
}

RadianceError compareRadiance(const std::vector<float>& radiance, const std::vector<float>& exact,
                              const DisplayTransform& display) {
    RadianceError error;
    double squares = 0.0, codeSquares = 0.0;
    std::vector<float> shown = radiance, shownExact = exact;
    display.apply(shown);
    display.apply(shownExact);
    const auto code = [](float v) { return int(std::lround(255.0f * v)); };
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        if (i % 4 == 3 || radiance[i] == exact[i]) continue;
        double difference = std::abs(double(radiance[i]) - double(exact[i]));
        int codes = 255;
        if (std::isfinite(difference)) {
            codes = std::abs(code(shown[i]) - code(shownExact[i]));
        } else {
            difference = HUGE_VAL;  // also where one is no number, which no comparison would find
        }
        error.largest = std::max(error.largest, difference);
        error.largestCode = std::max(error.largestCode, codes);
        squares += difference * difference;
        codeSquares += double(codes) * codes;
    }
    const double values = std::max(1.0, 0.75 * double(radiance.size()));
    error.rms = std::sqrt(squares / values);
    error.rmsCode = std::sqrt(codeSquares / values);
    return error;
}

}  // namespace umbrage
