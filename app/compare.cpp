// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <unistd.h>

#include "budgets.h"
#include "commands.h"
#include "exit_codes.h"
#include "golden/compare_folders.h"
#include "golden/compare_statistics.h"
#include "golden/comparison_page.h"
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
    if (!comparison.statistics.empty()) fmt::print("{}", withinTable(comparison.statistics));
    fmt::print("{}\n", countsText(comparison));
}

/// A picture as the page wants it; integers as floats, of which a page shows no more digits.
PagePicture pageOf(const StoredImage& image) {
    PagePicture page{image.data.width, image.data.height, {}, {}, image.displayEncoded};
    page.values.resize(image.pixelCount() * image.channels.size());
    for (std::size_t k = 0; k < image.channels.size(); ++k) {
        page.channels.push_back(image.channels[k].name);
        const auto spread = [&](const auto& values) {
            for (std::size_t i = 0; i < values.size(); ++i)
                page.values[i * image.channels.size() + k] = float(values[i]);
        };
        std::visit(spread, image.channels[k].values);
    }
    return page;
}

std::optional<PagePicture> pageOf(const std::filesystem::path& file) {
    try {
        return pageOf(codec().read(file));
    } catch (const Error&) {
        return std::nullopt;  // the result says so
    }
}

std::string pageOf(const Comparison& comparison) {
    return comparisonPage(comparison, [&](const ImageResult& image) -> std::optional<PagePictures> {
        const auto file = [&](const std::string& place) {
            const std::filesystem::path path = place;
            return std::filesystem::is_directory(path) ? path / image.name : path;
        };
        return PagePictures{pageOf(file(comparison.golden)), pageOf(file(comparison.output))};
    });
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
    if (!options.html.empty()) writeWhole(options.html, pageOf(comparison));
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
