// SPDX-License-Identifier: Apache-2.0
// The tracer: what the renderer is measured against. Embree's packets of 4 x 4 pixels, primary rays and one robust
// occlusion ray for each lit sample and light; the renderer's lights, BRDF (glTF 2.0, appendix B) and ambient term,
// with materials of constant colour. As fast as it could be made, on all cores.
#pragma once

#include <memory>
#include <vector>

#include "bench/tracer_scene.h"
#include "frame/frame.h"

namespace umbrage {

/// Replaces textures and vertex colours by the factors they are multiplied with, so that renderer and tracer shade the
/// same.
void makeColorsConstant(Scene& scene);

struct TracerSettings {
    int width = 0, height = 0;
    bool shadows = true;
    /// Where shadow rays begin, in parts of the largest of the point's coordinates (from the middle of the scene) and
    /// its distance from the eye. Of 1e-7 to 1e-2 in steps of 3 and 10 this has the fewest wrong samples over knights,
    /// tree, hall, noise-spheres and courtyard (bench measure `error`).
    float offset = 1e-4f;
    glm::vec3 background{0.0f}, ambientSky{0.0f}, ambientGround{0.0f};
};

/// Of what the renderer has the same settings for.
TracerSettings tracerSettings(const FrameSettings& settings);

/// The fastest that this processor can run.
TraceTile* traceTileHere();

class Tracer {
public:
    Tracer(const TracerScene& scene, const TracerSettings& settings, TraceTile* traceTile = traceTileHere());

    /// A picture of what the scene has placed and built. @return linear RGBA, rows from the top
    const std::vector<float>& trace(const Moment& moment, const PlacedCamera& camera);

    /// The same, with what the judge wants to know of it: samples and which lights reach them.
    FramePixels traceSamples(const Moment& moment, const PlacedCamera& camera);

private:
    void run(const Moment& moment, const PlacedCamera& camera, FramePixels* samples);

    const TracerScene& scene_;
    TracerSettings settings_;
    TraceTile* traceTile_;
    std::vector<float> radiance_;
};

}  // namespace umbrage
