// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>

#include "command_line.h"
#include "exit_codes.h"
#include "job/aovs.h"
#include "job/nearest.h"
#include "shadow/fault.h"
#include "version.h"

namespace umbrage {
namespace {

constexpr const char* kFooter =
    "Exit codes: 0 ok; 1 frames failed, differ, are wrong or over budget; 2 usage; 3 bad sequence or scene; 4 no "
    "OpenGL;\n"
    "5 output could not be written; "
    "130/143 interrupted. Results go to stdout, everything else to stderr.\n"
    "Examples:\n"
    "  umbrage render configs/courtyard.yaml --frames 1-48x2 --out /tmp/frames\n"
    "  umbrage render scene.glb --size 640x480 --set shadow.count=z-fail\n"
    "  umbrage compare tests/golden/courtyard out/courtyard --html differences.html\n"
    "  umbrage verify configs/stress/*.yaml --techniques all --json stress.json\n"
    "  umbrage stats out/statistics.json --compare before.json\n"
    "  umbrage bench configs/bench/laine.yaml --json laine.json\n"
    "  umbrage inspect scene.glb";

void addJob(CLI::App& app, JobOptions& o) {
    app.add_option("--frames", o.frames, "frames: 1-48, 1-100x2, 3,7,9-12; all: the whole first animation of a scene");
    app.add_option("--size", o.size, "picture size: WIDTHxHEIGHT");
    app.add_option("--camera", o.camera, "path or name of a camera in the scene");
    app.add_option("--set", o.set, "override a value: shadow.count=z-fail (repeatable)")->allow_extra_args(false);
}

/// An option that may be given several times.
/// @param form  such as NAME=VALUE
CLI::Option* addAssignments(CLI::App& app, const char* name, std::vector<std::string>& values, const char* doc,
                            const std::string& form, const char* example) {
    const auto check = [=](const std::string& text) {
        return text.find('=') == std::string::npos || text.front() == '='
                   ? fmt::format("\"{}\" is not {}, such as {}", text, form, example)
                   : std::string();
    };
    return app.add_option(name, values, doc)
        ->allow_extra_args(false)
        ->check(CLI::Validator(check, ""))
        ->option_text(form);
}

void addBudget(CLI::App& app, std::vector<std::string>& budgets) {
    addAssignments(app, "--budget", budgets,
                   "fail where a frame has more: overdraw.p95=6, edges.silhouette={min: 1} (repeatable)",
                   "FIGURE=LIMIT", "overdraw.p95=6");
}

/// An option whose value is one of a few names.
template <class T>
void addChoice(CLI::App& app, const char* name, T& value, const char* doc, const std::map<std::string, T>& choices) {
    app.add_option(name, value, doc)
        ->transform(CLI::Transformer(choices))
        ->transform(CLI::IsMember(choices))  // comes first, for its message
        ->option_text(" ");
}

void addRun(CLI::App& app, std::string& device, ProgressKind& progress, bool& allowExternalFiles) {
    app.add_option("--device", device, "OpenGL device: index or part of its name, see umbrage devices")
        ->capture_default_str();
    addChoice(app, "--progress", progress, "auto, bar, lines or none",
              {{"auto", ProgressKind::Auto},
               {"bar", ProgressKind::Bar},
               {"lines", ProgressKind::Lines},
               {"none", ProgressKind::None}});
    app.add_flag("--allow-external-files", allowExternalFiles, "let scenes name files outside their folder");
}

/// How a sequence is rendered, but for which.
void addRendering(CLI::App& app, RenderOptions& o) {
    addJob(app, o.job);
    addBudget(app, o.job.budgets);
    app.add_option("--out", o.out, "folder for the files instead of the sequence's");
    app.add_option("--ocio", o.ocio, "OpenColorIO configuration; wins over the sequence's and $OCIO");
    app.add_option("--workers", o.workers, "threads that write files; 0 chooses")
        ->capture_default_str()
        ->check(CLI::Range(0, 256))
        ->option_text("INT [0]");
    addRun(app, o.device, o.progress, o.allowExternalFiles);
}

void addRender(CLI::App& app, RenderOptions& o) {
    app.add_option("input", o.input, "sequence (.yaml) or scene (.gltf, .glb)")->required();
    addRendering(app, o);
    std::string aovs;
    for (const AovInfo& aov : kAovs) aovs += fmt::format(" {}", aov.name);
    app.footer("AOVs, for --set output.aovs.NAME=exr (docs/aovs.md):" + aovs);
    app.add_flag("--only-diagnostics", o.onlyDiagnostics,
                 "shade nothing: overlays, data AOVs and statistics alone (diagnostics.only)");
    CLI::Option* dryRun =
        app.add_flag("--dry-run", o.dryRun, "check everything, print the files that would be written, render nothing");
    app.add_flag("--explain", o.explain,
                 "print what each frame left out and why, and what each of its lights cost; counting takes time")
        ->excludes(dryRun);
}

void addGoldenInputs(CLI::App& app, std::vector<std::string>& inputs) {
    app.add_option(
           "inputs", inputs,
           "GOLDEN OUT: two folders or two pictures; or a sequence (.yaml), which is rendered and compared with "
           "the goldens it names (golden.path)")
        ->required()
        ->expected(1, 2);
}

void addCompare(CLI::App& app, CompareCommandOptions& o) {
    addGoldenInputs(app, o.inputs);
    app.add_option("--rules", o.rules, "file of rules (.yaml, docs/compare.md) instead of the sequence's");
    app.add_flag("--other-device", o.otherDevice,
                 "compare with goldens of another device, too, by the rules of that pair (golden.devices)");
    app.add_flag("--all", o.all, "a line for each picture, not only for those that differ");
    app.add_option("--json", o.json, "file for programs, of which all other reports are views");
    app.add_option("--junit", o.junit, "JUnit XML for CI");
    app.add_option("--csv", o.csv, "a line for each picture");
    app.add_option("--html", o.html, "a page to look at, in one file that opens offline");
    app.add_option("--markdown", o.markdown, "a summary for documents and CI pages");
    app.add_flag("--annotations", o.annotations, "print ::error and ::warning lines, as GitHub shows them");
    addRendering(app, o.render);
}

void addAccept(CLI::App& app, AcceptCommandOptions& o) {
    addGoldenInputs(app, o.inputs);
    app.add_flag("--yes", o.yes, "do it without asking");
    app.add_flag("--statistics", o.statistics, "statistics.json of the output becomes golden, too");
    app.add_flag("--force-device", o.force, "replace goldens of another device");
    addRendering(app, o.render);
}

void addVerify(CLI::App& app, VerifyCommandOptions& o) {
    CLI::Option* inputs = app.add_option("inputs", o.inputs, "sequences (.yaml) or scenes (.gltf, .glb)");
    CLI::Option* random =
        app.add_option("--random", o.random, "judge N random scenes instead, by all techniques where none are named")
            ->check(CLI::PositiveNumber)
            ->option_text("N")
            ->excludes(inputs);
    app.add_option("--seed", o.seed, "of the first random scene; scene i has seed + i - 1")
        ->option_text("S (1)")
        ->needs(random);
    app.callback([inputs, random] {
        if (inputs->empty() && random->empty()) throw CLI::RequiredError("a sequence, a scene or --random N");
    });
    addJob(app, o.job);
    app.add_option("--techniques", o.techniques,
                   "all, or silhouette:count,silhouette:count,...; otherwise what the sequence says");
    app.add_option("--others-every", o.othersEvery, "techniques after the first judge only every n-th frame")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000))
        ->option_text("INT [1]");
    app.add_flag("--counts", o.counts, "judge integer counts, too: takes a second picture of every frame");
    app.add_option("--max-hard", o.maxHard, "hard errors that pass, summed over techniques that claim exactness")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber)
        ->option_text("INT [0]");
    app.add_flag("--per-frame", o.perFrame, "a row for each frame in tables; all frames in JSON, not only wrong ones");
    app.add_flag("--per-light", o.perLight, "a row for each light in tables");
    app.add_flag("--summary", o.summary, "techniques alone in tables, over all sequences");
    app.add_option("--json", o.json, "file for programs: figures of sequences, techniques and wrong frames");
    app.add_option("--csv", o.csv, "file for programs: a line for each sequence, frame, technique and light");
    app.add_option("--markdown", o.markdown, "file for documents: the tables and how they were made");
    app.add_option("--out", o.out, "folder for pictures of what is wrong: SEQUENCE/TECHNIQUE.FRAME.png")
        ->capture_default_str();
    addChoice(app, "--pictures", o.pictures, "which frames get one: all, failed (default) or none",
              {{"all", Pictures::All}, {"failed", Pictures::Failed}, {"none", Pictures::None}});
    std::vector<std::string> faults;
    std::string doc = "plant a mistake, to see it caught";
    for (const NamedFault& fault : kFaults) {
        faults.emplace_back(fault.name);
        doc += fmt::format("; {}: {}", fault.name, fault.doc);
    }
    app.add_option("--fault", o.fault, doc)->check(CLI::IsMember(faults))->option_text("NAME");
    addRun(app, o.device, o.progress, o.allowExternalFiles);
}

void addBench(CLI::App& app, BenchCommandOptions& o) {
    app.add_option("file", o.file, "what to measure (.yaml, docs/bench.md)")->required();
    app.add_option("--rounds", o.rounds, "how often everything is timed, instead of what the file says")
        ->check(CLI::Range(1, 1000))
        ->option_text("INT");
    app.add_option("--out", o.out, "folder for plots and pictures")->capture_default_str();
    app.add_option("--json", o.json, "file for programs: the tables");
    app.add_option("--csv", o.csv, "file for programs: a line for each number");
    app.add_option("--markdown", o.markdown, "file for documents: the tables and how they were made");
    addRun(app, o.device, o.progress, o.allowExternalFiles);
}

CLI::Validator endingWith(const std::vector<std::string>& endings) {
    const std::string what = fmt::format("{}", fmt::join(endings, " or "));
    return CLI::Validator(
        [=](const std::string& file) {
            const auto ends = [&](const std::string& ending) { return file.ends_with(ending); };
            return std::any_of(endings.begin(), endings.end(), ends)
                       ? std::string()
                       : fmt::format("{} does not end with {}", file, what);
        },
        "");
}

void addStats(CLI::App& app, StatsOptions& o) {
    app.add_option("inputs", o.inputs,
                   "statistics files (.json); several are parts of one sequence where a file is made")
        ->required();
    app.add_option("--frames", o.frames, "only these frames: 1-48, 1-100x2, 3,7,9-12");
    app.add_option("--light", o.light, "only lights whose id this glob matches");
    CLI::Option* counter =
        app.add_option("--counter", o.counter, "only counters that this glob matches; with --plot, the one to plot");
    CLI::Option* compare = app.add_option("--compare", o.compare, "print what is different in this statistics file");
    addAssignments(app, "--tolerance", o.tolerances,
                   "with --compare: fail where a column is off by more than this share, such as 'overdraw.*=0.01' or "
                   "'memory.*=skip'; others must be equal, but times are skipped (repeatable)",
                   "GLOB=SHARE", "overdraw.*=0.01")
        ->needs(compare);
    addBudget(app, o.budgets);
    app.add_option("--merge", o.merge, "write all inputs as one statistics file")->check(endingWith({".json"}));
    app.add_option("--csv", o.csv, "write them as a table for spreadsheets, pandas and R");
    app.add_option("--html", o.html,
                   "write them as a page to look at, with thumbnails of beauty.FRAME.png beside them");
    app.add_option("--plot", o.plot, "write a curve over the frames, a line for each light: .svg or .png")
        ->check(endingWith({".svg", ".png"}))
        ->needs(counter);
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> optionsOf(const CLI::App& app, const std::vector<CLI::App*>& commands) {
    std::vector<std::string> names;
    std::vector<const CLI::App*> owners(commands.begin(), commands.end());
    owners.push_back(&app);
    for (const CLI::App* owner : owners) {
        for (const CLI::Option* option : owner->get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
    }
    return names;
}

/// What is wrong with the command line; the nearest name for a command or an option that does not exist.
std::string usageMessage(const CLI::App* app, const CLI::Error& error) {
    const auto unknown = [](const char* what, const std::string& name, const std::vector<std::string>& known) {
        return fmt::format("there is no {} '{}' ({})", what, name, hintForName(name, known));
    };
    const std::vector<CLI::App*> given = app->get_subcommands();
    const std::vector<std::string> words = app->remaining(true);
    const auto option =
        std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with('-'); });
    std::string message = error.what();
    if (option != words.end()) {
        message = unknown("option", *option, optionsOf(*app, given));
    } else if (given.empty()) {
        message = words.empty() ? fmt::format("a command is missing ({})", hintForName("", commandsOf(*app)))
                                : unknown("command", words.front(), commandsOf(*app));
    }
    return fmt::format("umbrage: error: {}\numbrage {}--help says more\n", message,
                       given.empty() ? "" : given.front()->get_name() + " ");
}

}  // namespace

std::optional<Options> parseOptions(int argc, char** argv, int& exitCode) {
    Options options;
    RenderOptions render;
    CompareCommandOptions compare;
    AcceptCommandOptions accept;
    VerifyCommandOptions verify;
    BenchCommandOptions bench;
    InspectOptions inspect;
    StatsOptions stats;
    SchemaOptions schema;
    CLI::App app{"umbrage: batch renderer with pixel-exact shadow volumes", "umbrage"};
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("umbrage ") + kVersion);
    app.require_subcommand(1);
    app.add_flag("-q,--quiet", options.quiet, "only errors");
    app.fallthrough();
    app.failure_message(usageMessage);
    CLI::App* renderCommand = app.add_subcommand("render", "render a sequence or a scene");
    addRender(*renderCommand, render);
    CLI::App* compareCommand = app.add_subcommand("compare", "compare output with golden frames");
    addCompare(*compareCommand, compare);
    CLI::App* acceptCommand = app.add_subcommand("accept", "make output the golden frames");
    addAccept(*acceptCommand, accept);
    CLI::App* verifyCommand = app.add_subcommand("verify", "judge shadows against the exact answer");
    addVerify(*verifyCommand, verify);
    CLI::App* benchCommand = app.add_subcommand("bench", "measure what a bench file asks for");
    addBench(*benchCommand, bench);
    CLI::App* inspectCommand = app.add_subcommand("inspect", "say what is in a scene");
    inspectCommand->add_option("scene", inspect.scene, "scene (.gltf, .glb)")->required();
    inspectCommand->add_flag("--allow-external-files", inspect.allowExternalFiles,
                             "let the scene name files outside its folder");
    CLI::App* statsCommand = app.add_subcommand("stats", "print, merge, compare and plot statistics");
    addStats(*statsCommand, stats);
    CLI::App* devicesCommand = app.add_subcommand("devices", "list OpenGL devices for --device");
    CLI::App* schemaCommand = app.add_subcommand("schema", "print the JSON Schema of sequence files");
    schemaCommand->add_flag("--markdown", schema.markdown, "the reference page instead");
    schemaCommand->add_flag("--statistics", schema.statistics, "of statistics files instead");
    schemaCommand->add_flag("--bench", schema.bench, "of bench files instead; with --markdown their reference page");
    schemaCommand->add_flag("--comparison", schema.comparison, "of comparisons (compare --json) instead");
    schemaCommand->add_flag("--aovs", schema.aovs, "the reference page of the AOVs instead");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        exitCode = app.exit(error, std::cout, std::cerr) == 0 ? kOk : kUsage;
        return std::nullopt;
    }
    if (*renderCommand) options.render = render;
    if (*compareCommand) options.compare = compare;
    if (*acceptCommand) options.accept = accept;
    if (*verifyCommand) {
        verify.commandLine = commandLine(argc, argv);
        options.verify = verify;
    }
    if (*benchCommand) {
        bench.commandLine = commandLine(argc, argv);
        options.bench = bench;
    }
    if (*inspectCommand) options.inspect = inspect;
    if (*statsCommand) options.stats = stats;
    if (*schemaCommand) options.schema = schema;
    options.devices = bool(*devicesCommand);
    return options;
}

}  // namespace umbrage
