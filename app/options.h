// SPDX-License-Identifier: Apache-2.0
// The command line as plain data. options.cpp alone knows how it is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace umbrage {

enum class ProgressKind { Auto, Bar, Lines, None };

/// What overrides values of a sequence.
struct JobOptions {
    std::string frames, size, camera;
    std::vector<std::string> set;
    std::vector<std::string> budgets;  // FIGURE=LIMIT
};

struct RenderOptions {
    std::string input;  // a sequence (.yaml, .yml) or a scene (.gltf, .glb)
    JobOptions job;
    std::string out, device = "auto", ocio;
    int workers = 0;
    bool dryRun = false, explain = false, onlyDiagnostics = false, allowExternalFiles = false;
    ProgressKind progress = ProgressKind::Auto;
};

struct CompareCommandOptions {
    std::vector<std::string> inputs;  // GOLDEN OUT, or a sequence
    RenderOptions render;             // of the sequence, but for its input
    std::string rules, json, junit, csv, html, markdown;
    bool annotations = false, otherDevice = false, all = false;
};

struct AcceptCommandOptions {
    std::vector<std::string> inputs;  // as CompareCommandOptions
    RenderOptions render;
    bool yes = false, force = false, statistics = false;
};

enum class Pictures { All, Failed, None };

struct VerifyCommandOptions {
    std::vector<std::string> inputs;  // as RenderOptions::input
    JobOptions job;
    std::string techniques;  // silhouette:count,... or all; empty: each sequence's own pair
    std::string fault;
    std::string out = "out/verify", json, csv, markdown, device = "auto";
    int othersEvery = 1;
    int random = 0;          // scenes to make instead of inputs
    std::uint64_t seed = 1;  // of the first of them
    std::uint64_t maxHard = 0;
    Pictures pictures = Pictures::Failed;
    bool counts = false, perFrame = false, perLight = false, summary = false, allowExternalFiles = false;
    ProgressKind progress = ProgressKind::Auto;
    std::string commandLine;  // as typed, for reports
};

struct BenchCommandOptions {
    std::string file;
    std::string out = "out/bench", json, csv, markdown, device = "auto";
    int rounds = 0;  // 0: as the file says
    bool allowExternalFiles = false;
    ProgressKind progress = ProgressKind::Auto;
    std::string commandLine;  // as typed, for reports
};

struct InspectOptions {
    std::string scene;
    bool allowExternalFiles = false;
};

struct StatsOptions {
    std::vector<std::string> inputs;     // statistics files (.json)
    std::string frames, light, counter;  // what to look at; empty: everything
    std::string merge, compare, csv, html, plot;
    std::vector<std::string> budgets;     // FIGURE=LIMIT
    std::vector<std::string> tolerances;  // GLOB=SHARE or GLOB=skip
};

struct SchemaOptions {
    bool markdown = false, aovs = false, statistics = false, bench = false, comparison = false;
};

struct Options {
    std::optional<RenderOptions> render;
    std::optional<CompareCommandOptions> compare;
    std::optional<AcceptCommandOptions> accept;
    std::optional<VerifyCommandOptions> verify;
    std::optional<BenchCommandOptions> bench;
    std::optional<InspectOptions> inspect;
    std::optional<StatsOptions> stats;
    std::optional<SchemaOptions> schema;
    bool devices = false;
    bool quiet = false;
};

/// @return nothing when the program is done (help, version, or a usage error, which is printed); `exitCode` says so
std::optional<Options> parseOptions(int argc, char** argv, int& exitCode);

}  // namespace umbrage
