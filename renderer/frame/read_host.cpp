// SPDX-License-Identifier: Apache-2.0
#include "frame/read_host.h"

#include <algorithm>

#include "frame/volume_diagnostics.h"
#include "shadow/split_picture.h"

namespace umbrage {

void readSamples(const HostResolve::Input& frame, Resolve& resolve, const Eye& eye,
                 std::span<const std::size_t> shining, FramePixels& pixels) {
    const std::vector<glm::vec2> positions = frame.gbuffer.samplePositions();
    const glm::dvec2 halfSize(0.5 * frame.gbuffer.width(), -0.5 * frame.gbuffer.height());
    for (const glm::vec2& position : positions)
        pixels.seen.positions.push_back(position + glm::vec2(eye.shift * halfSize));
    for (std::size_t s = 0; s < positions.size(); ++s) {
        // Also without any light there is one group: it says what is seen.
        for (std::uint32_t first = 0; first == 0 || first < shining.size(); first += LIGHTS_PER_GROUP) {
            const std::vector<gpu::uvec2> sample = resolve.readSample(frame.gbuffer, frame.masks, frame.silhouettes,
                                                                      int(s), positions[s], first / LIGHTS_PER_GROUP);
            if (first == 0) {
                for (const gpu::uvec2& pixel : sample) pixels.seen.triangles.push_back(pixel.x);
            }
            for (std::size_t l = first; l < std::min<std::size_t>(first + LIGHTS_PER_GROUP, shining.size()); ++l) {
                std::vector<std::uint8_t>& reaches = pixels.lights[shining[l]].reaches;
                for (const gpu::uvec2& pixel : sample) reaches.push_back(pixel.y >> (l - first) & 1u);
            }
        }
    }
    for (LightPlanes& planes : pixels.lights) planes.reaches.resize(pixels.seen.triangles.size());
}

void shadeLights(const HostResolve::Input& frame, HostResolve& resolve, std::span<const std::size_t> shining,
                 FramePixels& pixels) {
    gpu::ViewData dark = frame.view;
    dark.ambientSky = dark.ambientGround = dark.background = glm::vec4(0.0f);
    for (std::size_t l = 0; l < shining.size(); ++l) {
        std::vector<gpu::LightData> alone(frame.lights.begin(), frame.lights.end());
        for (std::size_t other = 0; other < alone.size(); ++other) {
            if (other != l) alone[other].color.w = 0.0f;
        }
        const std::vector<float> rgba =
            resolve.shade({frame.gbuffer, frame.seen, frame.masks, frame.silhouettes, dark, alone, false});
        AovPlane& plane = pixels.lights[shining[l]].aovs["light"];
        const auto components = std::size_t(plane.components);
        for (std::size_t i = 0; i < plane.values.size(); ++i) {
            plane.values[i] = rgba[4 * (i / components) + i % components];
        }
    }
}

void drawSplitPlanes(const FrameSettings& settings, std::span<const LightParts> parts,
                     std::span<const ShadowLight> places, const Eye& eye, std::span<const std::size_t> shining,
                     FramePixels& pixels) {
    SplitPicture picture(settings.width, settings.height);
    std::vector<float> distances(pixels.normalAndDepth.size() / 4);
    for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = pixels.normalAndDepth[4 * i + 3];
    for (std::size_t l = 0; l < parts.size(); ++l) {
        picture.add(parts[l], places[l], eye, colorOfLight(shining[l]), distances);
    }
    pixels.splitPlanes = std::move(picture.values);
}

}  // namespace umbrage
