// SPDX-License-Identifier: Apache-2.0
// What a bench file asks for (docs/bench.md): which sequences, by which techniques, what is measured of them, and which
// plots and pictures are made. Read strictly, by the machinery of the sequence file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame/settings.h"
#include "job/job.h"
#include "shadow/split_plane.h"

namespace umbrage {

/// A sequence file and what is done with it.
struct BenchSequence {
    std::string name;  // in tables and of files
    Located<std::filesystem::path> file;
    std::vector<std::string> set;                     // as --set of the other commands
    std::optional<FrameRange> frames;                 // instead of the file's
    std::optional<std::vector<std::string>> measure;  // instead of the bench's
    std::optional<bool> tracer;                       // instead of the bench's
    // For tiles:
    std::vector<Located<std::string>> casters;  // globs; none: every instance with a mesh is one
    bool together = false;                      // all of them are one caster
    SplitChoice splitPlane;
    std::string printed;  // column of the paper's table
};

/// Counts of how often each pixel is processed, a panel for each method.
struct BenchPicture {
    struct Panel {
        Located<std::string> sequence;
        std::string method;        // of kTileMethods
        std::optional<int> frame;  // instead of the picture's
    };
    std::string name;  // of the file
    int frame = 1;
    std::vector<Panel> panels;
};

/// Updates a pixel would cost against the depth of what it sees, where one caster's volume is met most often.
struct BenchCurve {
    std::string name;
    Located<std::string> sequence;
    int frame = 1;
};

/// One value of a sequence changes, all else stays: how cost grows with it.
struct BenchGrowth {
    std::string name;  // in tables and of files
    Located<std::string> sequence;
    std::string set;                          // path of the value, as --set has it
    std::vector<std::vector<double>> values;  // of one number, or of a list
    std::string label;                        // of the axis
    std::string by;                           // a counter of the first frame is on the axis instead of the value
    bool isLinear = false;
    double patienceSeconds = 1.0;  // a frame

    /// As --set has it.
    std::string assignment(const std::vector<double>& value) const;
    /// What is assigned, without its path.
    static std::string text(const std::vector<double>& value);
};

/// A technique that is compared.
struct BenchTechnique {
    Technique technique;
    bool isPlain = false;  // without any skip

    /// As the file has it.
    std::string name() const;
    /// A job by this technique.
    Job of(Job job) const;
    static BenchTechnique named(const std::string& name);
};

struct Bench {
    std::filesystem::path file;
    std::vector<std::string> measure{"times"};
    std::vector<BenchSequence> sequences;
    std::vector<BenchTechnique> techniques;                     // none: each sequence's own
    bool tracer = false;                                        // constant colours, so that it can take part
    std::vector<double> offsets{1e-6, 1e-5, 1e-4, 1e-3, 1e-2};  // of the tracer, for error
    std::vector<int> shadowMaps;                                // sizes, for error; none: there are none
    std::vector<int> accumulation{1, 4, 16, 64, 256};           // for antialiasing
    int referencePictures = 1024;                               // of its reference
    int rounds = 5;
    std::optional<std::array<int, 2>> size;  // instead of each sequence's
    std::vector<BenchPicture> pictures;
    std::vector<BenchCurve> curves;
    std::vector<BenchGrowth> growth;

    const std::vector<std::string>& measureOf(const BenchSequence& sequence) const {
        return sequence.measure ? *sequence.measure : measure;
    }
    bool tracerFor(const BenchSequence& sequence) const { return sequence.tracer.value_or(tracer); }
    /// With what the bench overrides.
    Job jobOf(const BenchSequence& sequence) const;
};

/// @throws Error(Input) with file:line:column
Bench readBench(const std::filesystem::path& file);
Bench parseBench(const std::string& yaml, const std::string& name, const std::filesystem::path& folder);

/// The JSON Schema of bench files and their reference page (Markdown), from the same table.
std::string benchSchema();
std::string benchReference();

}  // namespace umbrage
