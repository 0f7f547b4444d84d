// SPDX-License-Identifier: Apache-2.0
// One frame: moment -> positions -> G-buffer -> facing -> edges -> counts -> masks -> resolve -> pixels on the host.
// FrameRenderer::render() reads like that line.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "diagnostics/statistics.h"
#include "frame/mask_maker.h"
#include "gpu/context.h"
#include "scene/moment.h"
#include "shading/again.h"
#include "shadow/fault.h"
#include "shadow/geometry.h"
#include "shadow/silhouette.h"

namespace umbrage {

/// What becomes of a light that the chosen technique does not count exactly, as it says itself.
enum class WhenInexact { FallBack, Refuse, Allow };  // in the order of kWhenInexact

struct FrameSettings {
    int width = 1024, height = 768, samples = 1;
    int accumulation = 1;  // pictures a frame is the mean of: see frame/accumulate.h
    bool shadows = true;
    std::string silhouette = "compute", count = "z-pass";  // of kSilhouettes and kCounts
    WhenInexact whenInexact = WhenInexact::FallBack;
    double extrusionMetres = 0.0;  // of z-fail-finite; 0: behind all that a light shines on
    bool eyeConstant = true;
    JobParts parts;
    // Skips: without effect on picture and masks, but for the last. They change counts, so they are off whenever counts
    // are asked for.
    bool halveEvenComponents = true;  // see shadow/counts.h
    bool skipOutOfReach = true;       // see shadow/bounds.h
    bool skipOutOfView = true;        // these two: see shadow/extent.h
    bool endVolumes = true;           // moves corners, so that a mask may round otherwise on a boundary
    bool resolveOnHost = true;        // where the device is a processor and there is one sample a pixel
    glm::vec3 background{0.0f}, ambientSky{0.0f}, ambientGround{0.0f};
    std::shared_ptr<MaskMaker> maskMaker;  // instead of shadows; null: none
    bool profile = false;
    Fault fault = Fault::None;  // planted on purpose, for the judge's own tests
};

/// What is read back, beside the picture. Nothing asked for, nothing paid.
struct FrameOutputs {
    bool radiance = true;   // the picture
    bool geometry = false;  // normals and depth
    bool shadows = false, counts = false, overdraw = false;
    bool scene = false;                       // how often opaque surfaces touch each pixel
    std::set<std::string, std::less<>> aovs;  // of job/aovs.h, those without a flag here
    bool hulls = false;                       // what the shadow volumes look like
    bool splitPlanes = false;                 // and the planes, where count is split-plane; with `geometry`
    bool topCasters = false;                  // whose volumes fill most
    bool figures = false;                     // counters into Statistics
    bool samples = false;                     // every sample by itself, for the judge

    bool wants(std::string_view aov) const { return aovs.contains(aov); }
};

/// An AOV: `components` values a pixel, rows from the top.
struct AovPlane {
    std::vector<float> values;
    std::vector<std::uint32_t> integers;  // instead, of those that are
    int components = 1;
};
using AovPlanes = std::map<std::string, AovPlane, std::less<>>;  // by name, as in FrameOutputs::aovs

/// Planes are width x height, rows from the top.
struct LightPlanes {
    std::string id;
    std::vector<float> shadow;          // 1: the light reaches the surface
    std::vector<std::uint32_t> counts;  // shadow volumes that hold the surface point
    bool countsAreWide = false;
    std::vector<std::uint8_t> reaches;  // as `shadow`, of every sample: sample after sample
    AovPlanes aovs;                     // those with channels for each light
};

/// One of those whose volumes have the most fragments.
struct FillingCaster {
    std::string path;           // of its node
    double fragments = 0.0;     // samples, of all lights
    std::vector<float> pixels;  // fragments at each pixel
};

/// What is seen at every sample, and where it lies in its pixel (from the upper left corner).
struct SeenSamples {
    std::vector<glm::vec2> positions;      // of the samples of every pixel
    std::vector<std::uint32_t> triangles;  // sample after sample: placed triangle, NO_TRIANGLE or LINE_OR_POINT
};

struct FramePixels {
    std::vector<float> radiance;        // RGBA, linear Rec.709
    std::vector<float> normalAndDepth;  // world normal, distance along the view axis
    std::vector<LightPlanes> lights;    // of the moment, in its order; zero where a light is off
    std::vector<float> overdrawFragments, overdrawUpdates;
    SceneFragments scene;
    std::vector<float> hulls;               // RGBA: see shadow/hulls.h, in display values
    std::vector<float> splitPlanes;         // as hulls: see shadow/split_picture.h
    std::vector<FillingCaster> topCasters;  // ten at most, the one that fills most first
    AovPlanes aovs;                         // the others
    SeenSamples seen;
    std::vector<std::string> notes;              // for people, each once in a renderer's life
    std::map<std::size_t, double> milliseconds;  // per pass, by its counter's place; only when profiled
};

/// A moment and the camera that sees it.
struct PlacedMoment {
    Moment moment;
    PlacedCamera camera;
};

class FrameRenderer {
public:
    /// @param first  the scene at the first frame's time
    /// @throws Error(Input, Device)
    FrameRenderer(const Scene& scene, const Moment& first, const FrameSettings& settings, const gpu::Context& context);
    ~FrameRenderer();

    /// @param before  for the AOV motion; without it nothing has moved
    FramePixels render(const Moment& moment, const PlacedCamera& camera, const FrameOutputs& outputs, int frame,
                       Statistics& statistics, const PlacedMoment* before = nullptr);

    /// The picture of the last render() with other masks: `reaches` per light of the moment, as in LightPlanes.
    std::vector<float> shadeAgain(const std::vector<std::vector<std::uint8_t>>& reaches);

    const FrameSettings& settings() const;

    /// Positions and numbering of what the last render() drew.
    const Geometry& geometry() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace umbrage
