// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "bench/bench_file_parts.h"
#include "bench/laine_table.h"
#include "bench/tile_counter.h"
#include "error.h"
#include "job/field_types.h"
#include "job/names.h"
#include "job/reference_page.h"

namespace umbrage {
namespace {

constexpr const char* kTitle = "bench";
const std::string kPlain = "plain ";

Type<std::vector<std::string>> measurements() {
    return listOf(choice({"times", "error", "antialiasing", "tiles"}), "a list of measurements");
}

Type<std::string> tileMethod() {
    std::vector<std::string> names;
    for (const TileMethod& method : kTileMethods) names.emplace_back(method.name);
    return choice(names);
}

Type<std::vector<BenchTechnique>> techniques() {
    std::vector<std::string> names = techniqueNames();
    for (const std::string& name : techniqueNames()) names.push_back(kPlain + name);
    return converted<std::vector<BenchTechnique>>(listOf(choice(names), "a list of techniques"),
                                                  [](const std::vector<std::string>& chosen, const YamlNode&) {
                                                      std::vector<BenchTechnique> made;
                                                      for (const std::string& name : chosen) {
                                                          made.push_back(BenchTechnique::named(name));
                                                      }
                                                      return made;
                                                  });
}

Type<BenchSequence> sequence() {
    using Sequence = BenchSequence;
    const auto file =
        converted<Located<std::filesystem::path>>(text("a path"), [](const std::string& path, const YamlNode& node) {
            return Located<std::filesystem::path>{path, node.place};
        });
    const auto plane = choiceOf<SplitPlaneKind>({{"point-camera-light", SplitPlaneKind::PointCameraLight},
                                                 {"point-point-light", SplitPlaneKind::PointPointLight}});
    std::vector<std::string> printed;
    for (const PrintedRow& row : kPrintedRows) printed.emplace_back(row.name);
    return mapping<Sequence>(
        "sequences", "A sequence file and what is done with it.",
        {
            field<Sequence>("file", file, &Sequence::file, "The sequence file, from this file's folder").required(),
            field<Sequence>("name", fileStem(), &Sequence::name, "Its name in tables and of files").unset("the file's"),
            field<Sequence>("set", listOf(text(), "a list of PATH=VALUE"), &Sequence::set,
                            "Overrides values of it, as --set does")
                .unset("none"),
            fieldThrough<Sequence, FrameRange>(
                "frames", frameRange(), [](Sequence& s, const FrameRange& frames) { s.frames = frames; }, "Its frames")
                .unset("the file's"),
            fieldThrough<Sequence, std::vector<std::string>>(
                "measure", measurements(),
                [](Sequence& s, const std::vector<std::string>& measure) { s.measure = measure; },
                "What is measured of it; [] nothing, for pictures alone")
                .unset("what the bench says"),
            fieldThrough<Sequence, bool>(
                "tracer", boolean(), [](Sequence& s, bool tracer) { s.tracer = tracer; },
                "As the bench's, for this sequence")
                .unset("what the bench says"),
            field<Sequence>("casters", listOf(located(text()), "a list of globs"), &Sequence::casters,
                            "For tiles: all meshes at and below a node that one of these matches are one caster, "
                            "nothing else casts")
                .unset("each node with a mesh is one"),
            field<Sequence>("together", boolean(), &Sequence::together, "All these casters are one"),
            fieldThrough<Sequence, SplitPlaneKind>(
                "splitPlane", plane, [](Sequence& s, SplitPlaneKind kind) { s.splitPlane.kind = kind; },
                "For tiles: how each caster's split plane is made")
                .unset("by its shape"),
            field<Sequence>("printed", choice(printed), &Sequence::printed,
                            "Scene of Laine's Table 1 whose figures stand beside")
                .unset("none"),
        },
        [](const Sequence& s, const YamlNode& node) {
            if (s.together && s.casters.empty()) {
                refuse(*node.find("together"), "together is about casters, and none are named", "add casters: [GLOB]");
            }
        });
}

Type<std::vector<BenchPicture>> pictures() {
    using Panel = BenchPicture::Panel;
    const auto panel = mapping<Panel>(
        "panels", "A picture of a picture.",
        {
            field<Panel>("sequence", located(text()), &Panel::sequence, "Name of the sequence").required(),
            field<Panel>("method", tileMethod(), &Panel::method, "Method of the tile counter").required(),
            fieldThrough<Panel, int>(
                "frame", integer(), [](Panel& p, int frame) { p.frame = frame; }, "Another frame")
                .unset("the picture's"),
        });
    return listOf(mapping<BenchPicture>(
                      "pictures", "How often each pixel is processed, in false colour, panels side by side.",
                      {
                          field<BenchPicture>("name", fileStem(), &BenchPicture::name, "Of the file").required(),
                          field<BenchPicture>("frame", integer(), &BenchPicture::frame, "The frame"),
                          field<BenchPicture>("panels", notEmpty(listOf(panel, "a list of panels")),
                                              &BenchPicture::panels, "What stands side by side")
                              .required(),
                      }),
                  "a list of pictures");
}

Type<std::vector<BenchCurve>> curves() {
    return listOf(mapping<BenchCurve>(
                      "curves",
                      "Count updates that a pixel costs, against the depth of what it would see: the pixel at "
                      "which view rays meet one caster's volume most often.",
                      {
                          field<BenchCurve>("name", fileStem(), &BenchCurve::name, "Of the file").required(),
                          field<BenchCurve>("sequence", located(text()), &BenchCurve::sequence, "Name of the sequence")
                              .required(),
                          field<BenchCurve>("frame", integer(), &BenchCurve::frame, "The frame"),
                      }),
                  "a list of curves");
}

void checkNames(const Bench& bench, const YamlNode& node) {
    std::vector<std::string> names;
    for (const BenchSequence& sequence : bench.sequences) names.push_back(sequence.name);
    const auto known = [&](const Located<std::string>& name) {
        if (std::find(names.begin(), names.end(), name.value) != names.end()) return;
        throw Error(ErrorKind::Input, name.place.text(), fmt::format("there is no sequence \"{}\"", name.value),
                    hintForName(name.value, names));
    };
    for (const BenchPicture& picture : bench.pictures) {
        for (const BenchPicture::Panel& panel : picture.panels) known(panel.sequence);
    }
    for (const BenchCurve& curve : bench.curves) known(curve.sequence);
    for (const BenchGrowth& growth : bench.growth) known(growth.sequence);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) {
        refuse(*node.find("sequences"), fmt::format("two sequences have the name \"{}\"", *twice),
               "give one of them another with name:");
    }
}

Type<Bench> benchType() {
    return mapping<Bench>(
        kTitle, "The whole file.",
        {
            fieldThrough<Bench, int>(
                "bench", oneOf({1}), [](Bench&, int) {}, "Version of this format")
                .required(),
            field<Bench>(
                "measure", measurements(), &Bench::measure,
                "times: of frames and passes; error: what shadows cost against how many samples are wrong, with "
                "plots; antialiasing: what a frame costs against how far it is from a converged one, with plots; "
                "tiles: "
                "what a rasteriser that culls tiles of 8 x 8 pixels "
                "processes (Laine 2005)"),
            field<Bench>("sequences", notEmpty(listOf(sequence(), "a list of sequences")), &Bench::sequences,
                         "What is rendered")
                .required(),
            field<Bench>("techniques", techniques(), &Bench::techniques,
                         "For times, error and growth: silhouette:count pairs that are compared; \"plain \" in front: "
                         "without any skip, so that plain cpu:z-fail is the textbook's, with volumes to infinity; for "
                         "antialiasing the first of them is how shadows are found")
                .unset("each sequence's own"),
            field<Bench>(
                "tracer", boolean(), &Bench::tracer,
                "For times, error and growth: also by the tracer, Embree's packets of primary rays and one robust "
                "occlusion ray "
                "for each lit sample and light. Textures and vertex colours are replaced by the factors they "
                "are multiplied with, for every technique"),
            field<Bench>(
                "offsets", notEmpty(listOf(number(between(0.0, 1.0)), "a list of numbers")), &Bench::offsets,
                "For error: where the tracer's shadow rays begin, in parts of the largest coordinate or distance "
                "there"),
            field<Bench>(
                "shadowMaps", listOf(integer(between(1, 8192)), "a list of sizes"), &Bench::shadowMaps,
                "For error: also by shadow maps with as many texels along a side, each with a bias by slope and "
                "without: one texel, one comparison; orthographic for directional lights, fitted to what is seen, as "
                "wide as the cone for spots, six faces of that size for points; drawn anew in every frame")
                .unset("none"),
            field<Bench>("accumulation", notEmpty(listOf(integer(between(1, 256)), "a list of numbers of pictures")),
                         &Bench::accumulation,
                         "For antialiasing: values of image.accumulation, with one sample a pixel, that are compared "
                         "with the numbers of samples (image.samples) that the device offers"),
            field<Bench>("reference", integer(between(1, 65536)), &Bench::referencePictures,
                         "For antialiasing: pictures that the converged frame is the mean of; at places in the pixels "
                         "that frames with less have not"),
            field<Bench>("rounds", integer(between(1, 1000)), &Bench::rounds,
                         "For all but tiles: how often everything is measured, all in turn"),
            fieldThrough<Bench, std::array<int, 2>>(
                "size", arrayOf<2>(integer(between(1, 16384)), "a list [width, height]"),
                [](Bench& b, const std::array<int, 2>& size) { b.size = size; }, "Width and height in pixels")
                .unset("each sequence's own"),
            field<Bench>("pictures", pictures(), &Bench::pictures, "Pictures of processed pixels").unset("none"),
            field<Bench>("curves", curves(), &Bench::curves, "Curves of updates").unset("none"),
            field<Bench>("growth", growths(), &Bench::growth, "How cost grows, by the techniques and the tracer")
                .unset("none"),
        });
}

}  // namespace

BenchTechnique BenchTechnique::named(const std::string& name) {
    const bool plain = name.starts_with(kPlain);
    return {Technique::named(plain ? name.substr(kPlain.size()) : name), plain};
}

std::string BenchTechnique::name() const {
    return (isPlain ? kPlain : "") + technique.name();
}

Job BenchTechnique::of(Job job) const {
    job.shadow.silhouette = technique.silhouette;
    job.shadow.count = technique.count;
    if (isPlain) {
        for (const NameAndMeaning& skip : kSkips) job.shadow.skips[std::string(skip.name)] = false;
    }
    return job;
}

Job Bench::jobOf(const BenchSequence& sequence) const {
    JobOverrides overrides;
    if (size) overrides.set.push_back(fmt::format("image.size=[{}, {}]", (*size)[0], (*size)[1]));
    overrides.set.insert(overrides.set.end(), sequence.set.begin(), sequence.set.end());
    Job job = readJob(sequence.file.value, overrides);
    if (sequence.frames) job.time.frames = *sequence.frames;
    return job;
}

Bench parseBench(const std::string& yaml, const std::string& name, const std::filesystem::path& folder) {
    const YamlNode root = parseYaml(yaml, name);
    if (root.kind == YamlNode::Kind::Null) refuse(root, "the file is empty", "a bench begins with bench: 1");
    if (root.isMapping() && !root.find("bench")) {
        refuse(root, "the version key is missing",
               root.find("umbrage") ? "this is a sequence file" : "add the line bench: 1");
    }
    Bench bench = benchType().read(root, "the bench");
    bench.file = name;
    for (BenchSequence& sequence : bench.sequences) {
        if (sequence.name.empty()) sequence.name = sequence.file.value.stem().string();
        sequence.file.value = (folder / sequence.file.value).lexically_normal();
    }
    checkNames(bench, root);
    return bench;
}

Bench readBench(const std::filesystem::path& file) {
    return parseBench(contentsOf(file), file.string(), file.parent_path());
}

std::string benchSchema() {
    return schemaText("umbrage bench", benchType());
}

std::string benchReference() {
    return "# The bench file\n\n"
           "What `umbrage bench` measures, from the table that its parser uses: `umbrage schema --bench --markdown` "
           "wrote this\npage, and `umbrage schema --bench` writes the same as a JSON Schema for editors. As strict as "
           "the sequence file.\n" +
           referenceText(benchType().pages);
}

}  // namespace umbrage
