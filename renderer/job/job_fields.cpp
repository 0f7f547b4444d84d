// SPDX-License-Identifier: Apache-2.0
#include "job/job_fields.h"

#include <fmt/ranges.h>

#include "job/aovs.h"
#include "job/job_types.h"
#include "job/names.h"

namespace umbrage {
namespace {

std::vector<std::string> orAuto(std::vector<std::string> names) {
    names.insert(names.begin(), "auto");
    return names;
}

Type<float> single(const Limits& limits = {}) {
    return converted<float>(
        number(limits), [](double value, const YamlNode&) { return static_cast<float>(value); },
        [](float value) { return std::stod(fmt::format("{}", value)); });  // .1, not .10000000149
}

Type<Triple> axis() {
    const std::string expected = "an axis [x, y, z], not 0";
    return converted<Triple>(triple(expected), [expected](Triple axis, const YamlNode& node) {
        if (axis == Triple{}) refuseType(node, "axis", expected);
        return axis;
    });
}

Type<std::vector<JobDisplacement>> displacements() {
    const auto procedure = mapping<JobDisplacement>(
        "displace", "A procedure that moves vertices, on the nodes whose path a glob matches.",
        {
            field<JobDisplacement>("kind", choice(namesOf(kProcedures)), &JobDisplacement::kind,
                                   "The procedure: " + meaningsOf(kProcedures)),
            field<JobDisplacement>("amplitude", sampledNumber(), &JobDisplacement::amplitude,
                                   "Largest displacement in metres; of a twist, degrees a metre"),
            field<JobDisplacement>("axis", axis(), &JobDisplacement::axis,
                                   "Of wave and twist, through the mesh's origin"),
            field<JobDisplacement>("frequency", single(atLeast(0)), &JobDisplacement::frequency,
                                   "Of noise and wave in space")
                .in("1/metre"),
            field<JobDisplacement>("speed", single(), &JobDisplacement::speed, "In time; 0 stands still")
                .in("1/second"),
            field<JobDisplacement>("interpolation", interpolation(), &JobDisplacement::interpolation,
                                   "Between the time samples"),
        });
    return converted<std::vector<JobDisplacement>>(dictionary(procedure, "a mapping {glob: procedure, ...}"),
                                                   [](const auto& entries, const YamlNode&) {
                                                       std::vector<JobDisplacement> made;
                                                       for (const auto& [glob, displacement] : entries) {
                                                           made.push_back(displacement);
                                                           made.back().glob = glob;
                                                       }
                                                       return made;
                                                   });
}

// --- settings ---

Type<Job::Time> timeSettings() {
    return mapping<Job::Time>(
        "time", "Which frames; the time of frame f is f / fps seconds.",
        {
            field<Job::Time>("fps", number(above(0)), &Job::Time::framesPerSecond, "Frame rate").in("frames/second"),
            field<Job::Time>("frames", frameRange(), &Job::Time::frames, "The frames to render"),
        });
}

using Ambient = std::pair<Triple, Triple>;  // sky, ground

Type<Ambient> ambient() {
    const auto constant = converted<Ambient>(
        color(),
        [](const Triple& value, const YamlNode&) {
            return Ambient{value, value};
        },
        [](const Ambient& value) { return value.first; });
    const auto hemispheric =
        mapping<Ambient>("ambient", "Light from everywhere, by the direction of the surface.",
                         {
                             field<Ambient>("sky", color(), &Ambient::first, "Radiance from above (+Y)"),
                             field<Ambient>("ground", color(), &Ambient::second, "Radiance from below"),
                         });
    return either(constant, hemispheric, [](const YamlNode& node) { return !node.isMapping(); });
}

Type<Job::ImageSettings> imageSettings() {
    using Image = Job::ImageSettings;
    const Image byDefault;
    return mapping<Image>(
        "image", "The picture.",
        {
            fieldThrough<Image, std::array<int, 2>>(
                "size", arrayOf<2>(integer(between(1, 16384)), "a list [width, height]"),
                [](Image& image, const std::array<int, 2>& size) { image.width = size[0], image.height = size[1]; },
                "Width and height in pixels", {{byDefault.width, byDefault.height}}),
            field<Image>("samples", oneOf({1, 2, 4, 8, 16}), &Image::samples,
                         "Samples a pixel; what the device cannot do is an error when rendering starts"),
            field<Image>("accumulation", integer(between(1, 256)), &Image::accumulation,
                         "Pictures that a frame is the mean of, in linear light, each with its samples at other places "
                         "of the pixels: antialiasing of edges, shadows and highlights, as slow as there are pictures. "
                         "Together with samples there are as many samples as both multiplied"),
            field<Image>("background", color(), &Image::background, "Where nothing is hit"),
            fieldThrough<Image, Ambient>("ambient", ambient(),
                                         [](Image& image, const Ambient& value) {
                                             image.ambientSky = value.first, image.ambientGround = value.second;
                                         },
                                         "Light from everywhere that no shadow takes away",
                                         {{byDefault.ambientSky, byDefault.ambientGround}}),
        });
}

Type<JobParts> casterParts() {
    const auto named = converted<JobParts>(
        choice({"auto", "instances"}),
        [](const std::string& name, const YamlNode&) { return JobParts{.automatic = name == "auto"}; },
        [](const JobParts& parts) { return parts.automatic ? "auto" : "instances"; });
    const auto globs = converted<JobParts>(
        listOf(located(text("a glob of node paths")), "a list of globs"),
        [](const auto& list, const YamlNode&) { return JobParts{.automatic = false, .globs = list}; });
    Type<JobParts> type = either(named, globs, [](const YamlNode& node) { return !node.isSequence(); });
    type.read = [a = named.read, b = globs.read](const YamlNode& node, const std::string& name) {
        return node.isSequence() ? b(node, name) : a(node, name);
    };
    return type;
}

using SplitPlanes = std::pair<std::string, std::vector<JobSplitPlane>>;

Type<SplitPlanes> splitPlanes() {
    const std::vector<std::string> names = {"auto", "point-camera-light", "point-point-light"};
    const auto named = converted<JobSplitPlane>(
        choice(names), [](const std::string& name, const YamlNode&) { return JobSplitPlane{.plane = name}; });
    using Point = std::array<double, 3>;
    const auto point = arrayOf<3>(number(), "a list [x, y, z]");
    const auto through = mapping<JobSplitPlane>(
        "splitPlane", "A split plane through the light and two points.",
        {fieldThrough<JobSplitPlane, std::array<Point, 2>>(
             "points", arrayOf<2>(point, "a list [[x, y, z], [x, y, z]]"),
             [](JobSplitPlane& plane, const std::array<Point, 2>& points) { plane.points = points; },
             "The points, in the node's space")
             .required()});
    const auto ofNodes = converted<SplitPlanes>(
        dictionary(either(named, through, [](const YamlNode& node) { return !node.isMapping(); }),
                   "a mapping {glob: name, or points, ...}"),
        [](const auto& entries, const YamlNode&) {
            SplitPlanes made{"auto", {}};
            for (const auto& [glob, plane] : entries) {
                made.second.push_back(plane);
                made.second.back().glob = glob;
            }
            return made;
        });
    const auto ofAll = converted<SplitPlanes>(
        choice(names),
        [](const std::string& name, const YamlNode&) {
            return SplitPlanes{name, {}};
        },
        [](const SplitPlanes& planes) { return planes.first; });
    return either(ofAll, ofNodes, [](const YamlNode& node) { return !node.isMapping(); });
}

Type<Job::Shadow> shadowSettings() {
    using Shadow = Job::Shadow;
    return mapping<Shadow>(
        "shadow", "How shadows are found. auto takes the fastest exact technique and says which.",
        {
            field<Shadow>("enabled", boolean(), &Shadow::enabled, "off: everything is lit"),
            field<Shadow>("count", choice(orAuto(namesOf(kCounts))), &Shadow::count,
                          "How pixels are counted: " + meaningsOf(kCounts) +
                              "; auto: tiles where the device is a processor, but z-pass there, too, where it is asked "
                              "what volumes cost a rasteriser (statistics, overlays and AOVs of them)"),
            field<Shadow>("whenInexact", choice(namesOf(kWhenInexact)), &Shadow::whenInexact,
                          "Where the way of counting is not exact and says so: " + meaningsOf(kWhenInexact)),
            field<Shadow>("extrusion", number(atLeast(0)), &Shadow::extrusionMetres,
                          "Where volumes of z-fail-finite end, from the light; 0: behind the box of all that it shines "
                          "on")
                .in("metres"),
            field<Shadow>("silhouette", choice(orAuto(namesOf(kSilhouettes))), &Shadow::silhouette,
                          "How silhouette edges are found: " + meaningsOf(kSilhouettes) +
                              "; auto: cpu where the device is a processor, else compute"),
            field<Shadow>("eyeConstant", boolean(), &Shadow::eyeConstant,
                          "off: plain z-pass, which is wrong with the eye in a shadow"),
            fieldThrough<Shadow, JobParts>(
                "parts", casterParts(),
                [](Shadow& shadow, const JobParts& parts) {
                    shadow.parts.automatic = parts.automatic, shadow.parts.globs = parts.globs;
                },
                "Which casters split-plane counts as one: auto divides meshes anew for every light and eye; instances "
                "takes each mesh of each node; globs make one part of everything at and below each node they match",
                Shadow{}.parts),
            fieldThrough<Shadow, SplitPlanes>(
                "splitPlane", splitPlanes(),
                [](Shadow& shadow, const SplitPlanes& planes) {
                    shadow.parts.splitPlane = planes.first, shadow.parts.ownSplitPlanes = planes.second;
                },
                "Where split-plane splits volumes, for all parts or by globs of nodes; auto: through the axis of thin "
                "parts, else towards the eye",
                SplitPlanes{"auto", {}}),
            field<Shadow>("skips", mapOf(boolean(), "a mapping {name of a skip: true or false}", namesOf(kSkips)),
                          &Shadow::skips,
                          "Turns single skips of work without effect off; all are on: " + meaningsOf(kSkips)),
        });
}

Type<Job::Color> colorSettings() {
    using Color = Job::Color;
    return mapping<Color>(
        "color", "From linear Rec.709 to the display; for PNG only, EXR stays linear.",
        {
            field<Color>("config", text("a path"), &Color::config,
                         "An OpenColorIO configuration, from this file's folder; --ocio wins over it")
                .unset("$OCIO, or the one in the program"),
            field<Color>("display", text(), &Color::display, "The display, by its name there"),
            field<Color>("view", text(), &Color::view, "The view, by its name there"),
            field<Color>("exposure", number(), &Color::exposureStops, "Brightens the picture").in("stops"),
        });
}

Type<Job::Diagnostics> diagnosticsSettings() {
    using Diagnostics = Job::Diagnostics;
    return mapping<Diagnostics>(
        "diagnostics", "Pictures and numbers for people who want to know why.",
        {
            field<Diagnostics>("overlays", listOf(choice(namesOf(kOverlays)), "a list of overlays"),
                               &Diagnostics::overlays, "Pictures with a legend: " + meaningsOf(kOverlays)),
            field<Diagnostics>(
                "against", choice(orAuto(techniqueNames())), &Diagnostics::against,
                "What the overlay techniques compares with; auto: the same silhouettes counted the other way"),
            field<Diagnostics>("burnIn", boolean(), &Diagnostics::burnIn,
                               "Writes frame, technique and largest value into a corner of each overlay"),
            field<Diagnostics>("profile", boolean(), &Diagnostics::profile,
                               "Measures each pass; slower, because every pass is waited for"),
            field<Diagnostics>("repeats", integer(between(1, 1000)), &Diagnostics::repeats,
                               "Renders each frame as often; times are medians"),
            field<Diagnostics>("only", boolean(), &Diagnostics::only,
                               "Shades nothing and writes no beauty picture: overlays are on black"),
        });
}

using Aovs = std::map<std::string, std::string>;

Type<Aovs> aovs() {
    const auto asWritten = mapOf(choice({"png", "exr"}), "a mapping {AOV: png or exr}", namesOf(kAovs));
    Type<Aovs> type = converted<Aovs>(
        asWritten,
        [](const Aovs& kinds, const YamlNode& node) {
            for (const AovInfo& aov : kAovs) {
                const YamlNode* kind = node.find(aov.name);
                if (kind && !aov.isPicture && kinds.at(std::string(aov.name)) == "png")
                    refuse(*kind, fmt::format("{} is data, which PNG would cut to [0, 1]", aov.name), "write exr");
            }
            return kinds;
        },
        [](const Aovs& kinds) { return kinds; });
    Json patterns = Json::object();
    for (const AovInfo& aov : kAovs)
        patterns[fmt::format("^{}$", aov.name)] = {{"enum", aov.isPicture ? Json{"png", "exr"} : Json{"exr"}},
                                                   {"description", aov.meaning}};
    type.schema = {{"type", "object"}, {"patternProperties", patterns}, {"additionalProperties", false}};
    return type;
}

Type<Job::Output> outputSettings() {
    using Output = Job::Output;
    return mapping<Output>(
        "output", "The files.",
        {
            field<Output>("path", text("a path with fields"), &Output::path,
                          "Name of each file, from this file's folder. Fields: {aov}, {frame} or {frame:04} (digits), "
                          "{ext}, {scene} (this file's name); {{ and }} are braces"),
            field<Output>("aovs", aovs(), &Output::aovs,
                          fmt::format("What is written, data only as exr (docs/aovs.md says what each is): {}",
                                      fmt::join(namesOf(kAovs), ", "))),
            field<Output>("layers", text("a path with fields that ends with .exr"), &Output::layers,
                          "One file for all AOVs that are asked for as exr, as layers, instead of one for each; "
                          "fields as in path, without {aov} and {ext}")
                .unset("none is written"),
            field<Output>("pngBits", oneOf({8, 16}), &Output::pngBits, "Bits a channel of PNG files"),
            field<Output>("exrHalf", boolean(), &Output::exrHalf, "off: colours and normals as 32-bit floats"),
        });
}

/// A path that ends with one of these.
Type<std::string> fileName(const std::string& name, const std::vector<std::string>& endings) {
    const std::string what = fmt::format("a path that ends with {}", fmt::join(endings, " or "));
    return converted<std::string>(
        text(what),
        [=](const std::string& value, const YamlNode& node) {
            const auto ends = [&](const std::string& ending) { return value.ends_with(ending); };
            if (std::none_of(endings.begin(), endings.end(), ends)) refuseType(node, name, what);
            return value;
        },
        [](const std::string& value) { return value; });
}

Type<Job::Statistics> statisticsSettings() {
    using Statistics = Job::Statistics;
    return mapping<Statistics>("statistics", "Numbers per frame, light and shadow caster: docs/statistics.md.",
                               {field<Statistics>("path", fileName("path", {".json", ".csv"}), &Statistics::path,
                                                  "The file, from this file's folder")
                                    .unset("none is written"),
                                field<Statistics>("page", fileName("page", {".html"}), &Statistics::page,
                                                  "The same as a page to look at, with thumbnails, in one file")
                                    .unset("none is written"),
                                field<Statistics>("budgets", budgets(), &Statistics::budgets,
                                                  "What every frame must hold to, or the run fails: a counter, or "
                                                  "QUANTITY.mean, .p50, .p95, .p99 or .max, and the most it may be; "
                                                  "--budget adds to them")
                                    .unset("none")});
}

void setLayers(Job& job, const std::vector<Layer>& layers) {
    for (const Layer& entry : layers) {
        if (const auto* gltf = std::get_if<GltfLayer>(&entry)) job.gltfLayers.push_back(*gltf);
        if (const auto* generated = std::get_if<GeneratedLayer>(&entry)) job.generatedLayers.push_back(*generated);
        if (const auto* overs = std::get_if<Overs>(&entry))
            job.overLayers.insert(job.overLayers.end(), overs->begin(), overs->end());
    }
}

void checkJob(const Job& job, const YamlNode& node) {
    const std::vector<std::string>& overlays = job.diagnostics.overlays;
    if (job.shadow.count != "split-plane" && std::count(overlays.begin(), overlays.end(), "split-plane") > 0) {
        refuse(*node.find("diagnostics"), "the overlay split-plane shows what only the count split-plane has",
               "set shadow.count to split-plane");
    }
    for (const Budget& budget : job.statistics.budgets) {
        const BudgetNeeds needs = needsOf(budget.name);
        if (job.diagnostics.profile || (needs != BudgetNeeds::Times && needs != BudgetNeeds::Ratio)) continue;
        refuse(*node.find("statistics")->find("budgets")->find(budget.name),
               fmt::format("{} is measured only where diagnostics.profile is true", budget.name),
               "set diagnostics.profile to true");
    }
    if (job.gltfLayers.empty() && job.generatedLayers.empty())
        refuse(*node.find("scene"), "the scene has no glTF layer", "add - gltf: FILE");
}

}  // namespace

Type<Job> sequenceType() {
    const auto animations = opinion(listOf(located(nameOrIndex()), "a list of names or indices"));
    return mapping<Job>(
        "sequence", "The whole file.",
        {
            fieldThrough<Job, int>(
                "umbrage", oneOf({1}), [](Job&, int) {}, "Version of this format")
                .required(),
            fieldThrough<Job, std::vector<Layer>>("scene", layers(), setLayers,
                                                  "What is there; at least one glTF layer or generated one")
                .required(),
            field<Job>("lights", extraLights(), &Job::lights, "Lights besides those of the files").unset("none"),
            field<Job>("camera", camera(), &Job::camera, "Path, name or index of a camera in the scene, or a new one")
                .unset("the scene's first, or one that sees everything"),
            field<Job>("animations", animations, &Job::animations,
                       "Which of the files' animations play, by name or index; [] none")
                .unset("[0] where there is one"),
            field<Job>("displace", displacements(), &Job::displacements, "Procedures on meshes, by glob").unset("none"),
            field<Job>("time", timeSettings(), &Job::time, "Frames and frame rate"),
            field<Job>("image", imageSettings(), &Job::image, "Size, samples, background, ambient light"),
            field<Job>("shadow", shadowSettings(), &Job::shadow, "Techniques"),
            field<Job>("color", colorSettings(), &Job::color, "Colour management"),
            field<Job>("diagnostics", diagnosticsSettings(), &Job::diagnostics, "Overlays and profiling"),
            field<Job>("output", outputSettings(), &Job::output, "Files to write"),
            field<Job>("statistics", statisticsSettings(), &Job::statistics, "Numbers to write"),
            field<Job>("golden", goldenSettings(), &Job::golden, "What the output is compared with").unset("none"),
        },
        checkJob);
}

}  // namespace umbrage
