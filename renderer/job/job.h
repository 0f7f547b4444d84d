// SPDX-License-Identifier: Apache-2.0
// What is asked for: a sequence file as plain data (docs/sequence.md). readJob() parses strictly; nothing here
// opens a scene, so names of nodes are checked later, by compose(), with the places kept here.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/budgets.h"
#include "job/frame_range.h"
#include "job/golden_rules.h"

namespace umbrage {

/// Where a value stands in the sequence file (1-based), or that it came from --set or a default (line 0).
struct Place {
    std::string file;
    int line = 0, column = 0;

    std::string text() const;  // "file:line:column", "--set shadow.count", ...
};

template <class T>
struct Located {
    T value{};
    Place place;
};

enum class KeyInterpolation { Step, Linear };

/// A constant, or {seconds: value, ...} held at both ends. N floats a value.
template <int N>
struct Sampled {
    std::vector<double> timesSeconds;  // strictly increasing; empty: `values` holds one constant
    std::vector<std::array<double, N>> values;
    Place place;

    bool animated() const { return !timesSeconds.empty(); }
};

struct LayerTransform {
    std::array<double, 3> translate{0, 0, 0};      // metres
    std::array<double, 3> rotateDegrees{0, 0, 0};  // about x, then y, then z
    std::array<double, 3> scale{1, 1, 1};
};

/// scene: - gltf: FILE
struct GltfLayer {
    Located<std::filesystem::path> file;  // absolute, or relative to the working directory
    Located<std::string> scene;           // name or index; empty: the file's default
    Located<std::string> at;              // path of the node that becomes its parent; "" the root
    LayerTransform transform;
};

/// scene: - generated: a scene of any size, made when it is asked for (scene/generated.h)
struct GeneratedLayer {
    int triangles = 100000;   // of all bodies, about
    int columns = 64;         // of bodies, on a square grid
    int layers = 1;           // bodies above each other in a column
    double roughness = 0.15;  // how far the bodies' surface goes in and out, in parts of their size
    double moving = 50.0;     // per cent of the bodies
    int lights = 3;
    bool movingLights = false;
    double lightRangeMetres = 0.0;  // 0: unlimited
};

/// Opinions on a light: in over: and in lights:. Angles in degrees in the file, radians here.
struct LightOpinion {
    std::optional<Sampled<1>> intensity;  // candela or lux, >= 0
    std::optional<Sampled<3>> color;      // linear Rec.709, >= 0
    std::optional<Sampled<1>> rangeMetres;
    std::optional<Sampled<1>> innerConeAngle, outerConeAngle;
    KeyInterpolation interpolation = KeyInterpolation::Linear;
};

/// scene: - over: {"/Glob*": {light: {...}}}
struct OverLayer {
    Located<std::string> glob;
    LightOpinion light;
};

enum class JobLightType { Point, Spot, Directional };

/// lights: an extra one. Spot and directional lights shine from `position` towards `target`.
struct JobLight {
    Located<std::string> name;
    JobLightType type = JobLightType::Point;
    Sampled<3> position{{}, {{0, 0, 0}}, {}};
    Sampled<3> target{{}, {{0, 0, -1}}, {}};
    LightOpinion light;
};

/// camera: a path or name of a glTF camera, or one described here.
struct JobCamera {
    Located<std::string> node;  // empty: described, or (described not set) the scene's first
    bool described = false;
    bool perspective = true;
    Sampled<3> position{{}, {{0, 0, 5}}, {}};
    Sampled<3> target{{}, {{0, 0, 0}}, {}};
    double yfovDegrees = 45.0;
    double ymag = 1.0;                // orthographic: half height in metres
    double znear = 0.05, zfar = 0.0;  // zfar 0: infinite (perspective)
    KeyInterpolation interpolation = KeyInterpolation::Linear;
};

struct JobDisplacement {
    Located<std::string> glob;
    std::string kind = "noise";  // of kProcedures
    Sampled<1> amplitude{{}, {{0.1}}, {}};
    std::array<double, 3> axis{0, 1, 0};
    float frequency = 3.0f, speed = 1.0f;
    KeyInterpolation interpolation = KeyInterpolation::Linear;
};

/// shadow.splitPlane: {"/Glob*": ...}
struct JobSplitPlane {
    Located<std::string> glob{};
    std::string plane = "auto";  // as JobParts::splitPlane
    std::optional<std::array<std::array<double, 3>, 2>>
        points{};  // in the node's space; then the plane is through them
};

/// How casters are divided, for counts that differ from part to part.
struct JobParts {
    bool automatic = true;                        // else an instance each ...
    std::vector<Located<std::string>> globs{};    // ... but for what is at and below each node that these match
    std::string splitPlane = "auto";              // point-camera-light, point-point-light
    std::vector<JobSplitPlane> ownSplitPlanes{};  // of some nodes' parts
};

/// golden: of the sequence file.
struct JobGolden {
    std::string path;  // folder; empty: none
    GoldenRules rules;
};

struct Job {
    std::filesystem::path file;  // the sequence file, for messages; or the bare scene
    std::string shape;           // what of it shapes the pictures, the same however it is written
    std::vector<GltfLayer> gltfLayers;
    std::vector<GeneratedLayer> generatedLayers;
    std::vector<OverLayer> overLayers;
    std::vector<JobLight> lights;
    JobCamera camera;
    std::optional<std::vector<Located<std::string>>> animations;  // names or indices; unset: [0] when there is one
    std::vector<JobDisplacement> displacements;

    struct Time {
        double framesPerSecond = 24.0;
        FrameRange frames = FrameRange::single(1);
        bool wholeAnimation = false;  // of a scene without YAML: instead of `frames`, as many as its animation lasts
    } time;

    struct ImageSettings {
        int width = 1024, height = 768;
        int samples = 1;
        int accumulation = 1;                          // pictures that a frame is the mean of
        std::array<double, 3> background{0, 0, 0};     // linear Rec.709
        std::array<double, 3> ambientSky{0, 0, 0};     // hemispheric: radiance from +Y ...
        std::array<double, 3> ambientGround{0, 0, 0};  // ... and from -Y; equal: a constant ambient term
    } image;

    struct Shadow {
        bool enabled = true;
        std::string count = "auto";  // of kCounts
        std::string whenInexact = "fall-back";
        double extrusionMetres = 0.0;     // 0: behind all that a light shines on
        std::string silhouette = "auto";  // of kSilhouettes
        bool eyeConstant = true;          // off: the textbook z-pass, wrong with the eye in a volume
        JobParts parts;
        std::map<std::string, bool> skips;  // skip name -> on; absent: on

        bool isSkipOn(const std::string& name) const {
            const auto found = skips.find(name);
            return found == skips.end() || found->second;
        }
    } shadow;

    struct Color {
        std::string config;  // path of an OpenColorIO configuration; empty: --ocio, $OCIO, the built-in one
        std::string display = "sRGB", view = "ACES SDR";
        double exposureStops = 0.0;
    } color;

    struct Diagnostics {
        std::vector<std::string> overlays;
        std::string against = "auto";  // technique that the overlay `techniques` compares with
        bool burnIn = false;           // frame, technique and maximum in a corner of overlays
        bool profile = false;          // time each pass (T15)
        int repeats = 1;               // of each frame: times are medians
        bool only = false;             // nothing is shaded, the picture is not written
    } diagnostics;

    struct Output {
        std::string path = "{aov}.{frame:04}.{ext}";                 // resolved against the sequence file's folder
        std::map<std::string, std::string> aovs{{"beauty", "png"}};  // AOV name -> file kind
        std::string layers;  // one EXR for all AOVs that are written as such; empty: one for each
        int pngBits = 8;
        bool exrHalf = true;  // colours and normals as half; depth, counts and masks keep their own types
    } output;

    struct Statistics {
        std::string path;  // .json or .csv; empty: none
        std::string page;  // .html; empty: none
        std::vector<Budget> budgets;

        bool isWanted() const { return isWritten() || !budgets.empty(); }
        bool isWritten() const { return !path.empty() || !page.empty(); }
    } statistics;

    JobGolden golden;
};

/// What the command line adds to a sequence file.
struct JobOverrides {
    /// An option with a name of its own, which errors then give as their place.
    struct Option {
        std::string name, assignment;
    };

    std::vector<std::string> set;        // "image.size=[640,480]": a YAML path and a YAML value
    std::vector<Option> options{};       // applied before `set`
    std::vector<std::string> budgets{};  // "overdraw.p95=6", applied last
    bool wholeAnimation = false;         // --frames all
};

/// Budgets of the command line: "overdraw.p95=6", each with a limit as the sequence file has it. The last one on a
/// figure counts.
/// @throws Error(Usage, Input) with "--budget"
std::vector<Budget> parseBudgets(const std::vector<std::string>& assignments);

/// @throws Error(Input) with file:line:column, or with "--set NAME" for overrides; Error(Usage) for wholeAnimation, as
///         only a scene without YAML leaves its frames open
Job readJob(const std::filesystem::path& sequenceFile, const JobOverrides& overrides = {});

/// The same from text; relative paths are resolved against `folder`.
Job parseJob(const std::string& yaml, const std::string& name, const std::filesystem::path& folder,
             const JobOverrides& overrides = {});

/// The job of a scene file without YAML: frame 1 on a dark grey background, output into the working directory's "out"
/// folder.
Job jobForScene(const std::filesystem::path& sceneFile, const JobOverrides& overrides = {});

/// The JSON Schema (draft 2020-12) of sequence files, from the same table as the parser.
std::string jobSchema();

/// The reference page of the sequence file (Markdown), from the same table.
std::string jobReference();

}  // namespace umbrage
