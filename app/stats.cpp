// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "budgets.h"
#include "commands.h"
#include "diagnostics/statistics_merge.h"
#include "error.h"
#include "exit_codes.h"
#include "golden/compare_statistics.h"
#include "image/thumbnail.h"
#include "job/frame_range.h"
#include "job/glob.h"
#include "job/job.h"
#include "job/nearest.h"
#include "job/yaml_tree.h"
#include "report/statistics_compare.h"
#include "report/statistics_page.h"
#include "report/statistics_plot.h"
#include "report/statistics_table.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

StatisticsSelection selectionOf(const StatsOptions& options) {
    StatisticsSelection selection;
    if (!options.frames.empty()) {
        const std::vector<int> list = FrameRange::parse(options.frames, "--frames").frames();
        selection.frame = [frames = std::set<int>(list.begin(), list.end())](int f) { return frames.contains(f); };
    }
    const auto matching = [](const std::string& glob) {
        return [glob](const std::string& name) { return matchesGlob(glob, name); };
    };
    if (!options.light.empty()) selection.light = matching(options.light);
    // A plot takes its one counter from all of them, so that a misspelt one gets an answer.
    if (!options.counter.empty() && options.plot.empty()) selection.name = matching(options.counter);
    return selection;
}

/// @throws Error(Usage)
std::vector<StatisticsTolerance> tolerancesOf(const std::vector<std::string>& assignments) {
    std::vector<StatisticsTolerance> tolerances;
    for (const std::string& text : assignments) {
        const std::size_t equals = text.rfind('=');
        const YamlNode value{.kind = YamlNode::Kind::Scalar, .plain = true, .scalar = text.substr(equals + 1)};
        StatisticsTolerance& tolerance = tolerances.emplace_back(StatisticsTolerance{text.substr(0, equals)});
        if (value.scalar == "skip") continue;
        tolerance.share = numberOf(value);
        if (!tolerance.share || *tolerance.share < 0.0) {
            throw Error(ErrorKind::Usage, "--tolerance", fmt::format("\"{}\" is no share of at least 0", value.scalar),
                        "a number such as 0.01, or skip");
        }
    }
    return tolerances;
}

/// @return  the exit code that the differences ask for
ExitCode printComparison(const StatisticsFile& before, const StatisticsFile& after,
                         const std::vector<StatisticsTolerance>& tolerances) {
    if (tolerances.empty()) {
        fmt::print("{}", comparisonTable(before, after));
        return kOk;
    }
    const std::vector<StatisticsResult> results = compareWithin(before, after, tolerances);
    fmt::print("{}", withinTable(results));
    const auto passes = [](const StatisticsResult& result) { return infoOf(result.outcome).passes; };
    return std::ranges::all_of(results, passes) ? kOk : kFramesFailed;
}

/// @param budgets  besides those of the file, or instead of those on the same figures
/// @throws Error(Input)
NamedStatistics selectedFrom(const std::string& name, const StatisticsSelection& selection,
                             const std::vector<Budget>& budgets) {
    StatisticsFile file = readStatistics(name);
    std::erase_if(file.budgets, [&](const BudgetResult& old) {
        return std::ranges::find(budgets, old.name, &Budget::name) != budgets.end();
    });
    for (const BudgetResult& result : checkBudgets(file, budgets)) file.budgets.push_back(result);
    return {name, selectedStatistics(file, selection)};
}

/// Of the pictures beauty.FRAME.png that lie beside the file.
std::map<int, std::string> thumbnailsBeside(const fs::path& statistics, const StatisticsFile& file) {
    std::map<int, std::string> thumbnails;
    for (const auto& [frame, figures] : file.frames) {
        const fs::path picture = statistics.parent_path() / fmt::format("beauty.{:04}.png", frame);
        std::ifstream stream(picture, std::ios::binary);
        if (!stream) continue;
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        const auto encoded = std::as_bytes(std::span(bytes));
        thumbnails[frame] = thumbnailOf(codec().decode(encoded, picture.string())).png();
    }
    return thumbnails;
}

void writePlot(const fs::path& file, const Plot& plot) {
    const Drawing drawing = layOut(plot);
    if (file.extension() == ".svg") {
        writeWhole(file, svgOf(drawing));
    } else {
        codec().write(file, pictureOf(drawing).file({}));
    }
}

}  // namespace

int runStats(const StatsOptions& options) {
    const StatisticsSelection selection = selectionOf(options);
    std::vector<NamedStatistics> files;
    const std::vector<StatisticsTolerance> tolerances = tolerancesOf(options.tolerances);
    const std::vector<Budget> budgets = parseBudgets(options.budgets);
    for (const std::string& input : options.inputs) files.push_back(selectedFrom(input, selection, budgets));
    const bool makesFiles =
        !options.merge.empty() || !options.csv.empty() || !options.html.empty() || !options.plot.empty();
    if (!makesFiles && options.compare.empty()) {
        ExitCode exitCode = kOk;
        for (std::size_t i = 0; i < files.size(); ++i) {
            fmt::print("{}{}", i > 0 ? "\n" : "", statisticsTable(files[i].file));
            exitCode = std::max(exitCode, sayBudgets(files[i].file.budgets, files.size() > 1 ? files[i].name : ""));
        }
        return exitCode;
    }
    const StatisticsFile all = mergedStatistics(files);
    if (!options.merge.empty()) writeWhole(options.merge, all.json());
    if (!options.csv.empty()) writeWhole(options.csv, all.csv());
    if (!options.html.empty()) {
        writeWhole(options.html, statisticsPage(all, thumbnailsBeside(options.inputs.front(), all)));
    }
    if (!options.plot.empty()) writePlot(options.plot, statisticsPlot(all, options.counter));
    ExitCode exitCode = sayBudgets(all.budgets, "");
    if (!options.compare.empty()) {
        const StatisticsFile after = selectedFrom(options.compare, selection, {}).file;
        exitCode = std::max(exitCode, printComparison(all, after, tolerances));
    }
    return exitCode;
}

}  // namespace umbrage
