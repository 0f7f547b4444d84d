// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>

#include "budgets.h"
#include "commands.h"
#include "exit_codes.h"
#include "golden/compare_folders.h"
#include "golden/compare_statistics.h"
#include "golden/comparison_page.h"
#include "golden/page_pictures.h"
#include "golden/reports.h"
#include "golden/result_text.h"
#include "golden_input.h"
#include "image/image.h"
#include "interrupt.h"
#include "progress.h"
#include "say.h"

namespace umbrage {
namespace {

void print(const Comparison& comparison, bool all) {
    for (const ImageResult& image : comparison.images) {
        if (!all && image.outcome == Outcome::Pass) continue;
        fmt::print("{:16} {}: {}\n", infoOf(image.outcome).name, image.name, explanation(image));
    }
    const auto fails = [](const StatisticsResult& column) { return !infoOf(column.outcome).passes; };
    if (std::ranges::any_of(comparison.statistics, fails)) fmt::print("{}", withinTable(comparison.statistics));
    if (!comparison.statistics.empty()) {
        fmt::print("{} pictures and {} columns of statistics: ", comparison.images.size(),
                   comparison.statistics.size());
    }
    fmt::print("{}\n", countsText(comparison));
}

void write(const Comparison& comparison, const CompareCommandOptions& options) {
    const auto as = [&](const std::string& file, const auto& textOf) {
        if (file.empty()) return;
        const std::filesystem::path folder = std::filesystem::path(file).parent_path();
        writeWhole(file, textOf(relativeTo(folder, comparison)));
    };
    as(options.json, comparisonJson);
    as(options.junit, comparisonJunit);
    as(options.csv, comparisonCsv);
    as(options.markdown, comparisonMarkdown);
    as(options.html, [&](const Comparison& seenFromThere) {
        return comparisonPage(seenFromThere, [&](const ImageResult& image) { return picturesOf(comparison, image); });
    });
    if (options.annotations) fmt::print("{}", comparisonAnnotations(comparison));
}

}  // namespace

int runCompare(const CompareCommandOptions& options, bool quiet) {
    const GoldenInput input = goldenInput(options.inputs, options.render, quiet);
    if (input.interrupted) return interruptExitCode();
    CompareOptions how;
    how.rules = options.rules.empty() ? input.rules : readGoldenRules(options.rules);
    how.otherDevice = options.otherDevice;
    how.asked = input.asked;
    Comparison comparison;
    {
        // A bar, but no line for each picture: what differs gets one at the end.
        const bool lines = options.render.progress == ProgressKind::Auto && isatty(STDERR_FILENO) == 0;
        Progress progress(lines ? ProgressKind::None : options.render.progress, quiet);
        bool started = false;
        how.progress = [&](std::size_t, std::size_t count) {
            if (!started) progress.started(count, "comparing");
            started = true;
            progress.advanced("compared");
        };
        comparison = comparePictures(input.golden, input.output, how);
        for (const std::string& note : comparison.notes) progress.note(note);
    }
    comparison.budgets = input.budgets;
    comparison.renderCommand = input.renderCommand;
    comparison.acceptCommand = input.acceptCommand;
    print(comparison, options.all);
    write(comparison, options);
    sayBudgets(comparison.budgets, "");
    return comparison.passes() ? kOk : kFramesFailed;
}

}  // namespace umbrage
