// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <array>

#include "commands.h"
#include "exit_codes.h"
#include "golden/compare_folders.h"
#include "golden_input.h"
#include "interrupt.h"
#include "progress.h"
#include "say.h"

namespace umbrage {
namespace {

void print(const Comparison& comparison, bool all) {
    std::array<std::size_t, kOutcomes.size()> counts{};
    for (const ImageResult& image : comparison.images) {
        ++counts[std::size_t(image.outcome)];
        if (!all && image.outcome == Outcome::Pass) continue;
        fmt::print("{:16} {}{}{}\n", infoOf(image.outcome).name, image.name, image.reason.empty() ? "" : ": ",
                   image.reason);
    }
    std::string sums;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] > 0) sums += fmt::format("{}{} {}", sums.empty() ? "" : ", ", counts[k], kOutcomes[k].name);
    }
    fmt::print("{} pictures: {}\n", comparison.images.size(), sums);
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
        Progress progress(options.render.progress, quiet);
        bool started = false;
        how.progress = [&](std::size_t, std::size_t count) {
            if (!started) progress.started(count, "comparing");
            started = true;
            progress.advanced("compared");
        };
        comparison = comparePictures(input.golden, input.output, how);
        for (const std::string& note : comparison.notes) progress.note(note);
    }
    comparison.renderCommand = input.renderCommand;
    comparison.acceptCommand = input.acceptCommand;
    print(comparison, options.all);
    return comparison.passes() ? kOk : kFramesFailed;
}

}  // namespace umbrage
