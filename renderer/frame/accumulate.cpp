// SPDX-License-Identifier: Apache-2.0
#include "frame/accumulate.h"

#include <bit>
#include <cmath>

namespace umbrage {
namespace {

/// Of the AOVs, those that are what light does: an average of data is no data.
constexpr std::array kMeans = {"light", "ambient", "emissive"};

/// All planes that are means, in the same order for all pictures of a frame.
std::vector<std::vector<float>*> meansOf(FramePixels& pixels) {
    std::vector<std::vector<float>*> planes{&pixels.radiance};
    const auto add = [&](AovPlanes& aovs) {
        for (const char* name : kMeans) {
            if (const auto found = aovs.find(name); found != aovs.end()) planes.push_back(&found->second.values);
        }
    };
    add(pixels.aovs);
    for (LightPlanes& light : pixels.lights) {
        planes.push_back(&light.shadow);
        add(light.aovs);
    }
    return planes;
}

/// What pictures after the first are asked for.
FrameOutputs onlyMeans(const FrameOutputs& outputs) {
    FrameOutputs means;
    means.radiance = outputs.radiance;
    means.shadows = outputs.shadows;
    for (const char* name : kMeans) {
        if (outputs.wants(name)) means.aovs.insert(name);
    }
    return means;
}

}  // namespace

glm::dvec2 accumulationShift(int index, int count, int samples) {
    const std::uint32_t strata = std::bit_ceil(std::uint32_t(count));
    // A digit of the index adds its direction number: 1/2, 1/4, 1/8 ..., or of the second dimension 1/2, 3/4, 5/8 ...
    std::uint32_t first = 0, second = 0, one = 1u << 31, other = 1u << 31;
    for (auto digits = std::uint32_t(index); digits != 0; digits >>= 1) {
        if (digits & 1u) first ^= one, second ^= other;
        one >>= 1;
        other ^= other >> 1;
    }
    const auto at = [&](std::uint32_t place) {
        const double moved = place * 0x1p-32 + (strata / 2 + 0.5) / strata;
        return (moved - std::floor(moved) - 0.5) / std::sqrt(double(samples));
    };
    return {at(first), at(second)};
}

FramePixels renderAccumulated(FrameRenderer& renderer, const PlacedMoment& now, const FrameOutputs& outputs, int frame,
                              Statistics& statistics, const PlacedMoment* before) {
    const FrameSettings& settings = renderer.settings();
    const auto cameraOf = [&](int picture) {
        PlacedCamera camera = now.camera;
        camera.shiftPixels = accumulationShift(picture, settings.accumulation, settings.samples);
        return camera;
    };
    FramePixels mean = renderer.render(now.moment, cameraOf(0), outputs, frame, statistics, before);
    if (settings.accumulation == 1) return mean;
    const std::vector<std::vector<float>*> planes = meansOf(mean);
    std::vector<std::vector<double>> sums;
    for (const std::vector<float>* plane : planes) sums.emplace_back(plane->begin(), plane->end());
    const FrameOutputs asked = onlyMeans(outputs);
    for (int picture = 1; picture < settings.accumulation; ++picture) {
        Statistics unused;
        FramePixels pixels = renderer.render(now.moment, cameraOf(picture), asked, frame, unused);
        const std::vector<std::vector<float>*> added = meansOf(pixels);
        for (std::size_t p = 0; p < sums.size(); ++p) {
            for (std::size_t i = 0; i < sums[p].size(); ++i) sums[p][i] += double((*added[p])[i]);
        }
        for (const auto& [pass, milliseconds] : pixels.milliseconds) mean.milliseconds[pass] += milliseconds;
        mean.notes.insert(mean.notes.end(), pixels.notes.begin(), pixels.notes.end());
    }
    for (std::size_t p = 0; p < sums.size(); ++p) {
        for (std::size_t i = 0; i < sums[p].size(); ++i) {
            (*planes[p])[i] = float(sums[p][i] / double(settings.accumulation));
        }
    }
    return mean;
}

}  // namespace umbrage
