// SPDX-License-Identifier: Apache-2.0
// GitHub's workflow commands ("Workflow commands for GitHub Actions: setting an error message"): what would end a
// command or a property is written as a percent code.
#include <fmt/format.h>

#include <string_view>

#include "golden/reports.h"
#include "golden/result_text.h"

namespace umbrage {
namespace {

std::string escaped(std::string_view text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        result += special.find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("%{:02X}", c);
    }
    return result;
}

/// @param file  empty: none
std::string command(const std::string& file, const std::string& title, Outcome outcome, const std::string& message) {
    const OutcomeInfo& info = infoOf(outcome);
    if (info.passes && outcome != Outcome::Warn) return {};
    constexpr std::string_view kInProperty = "%\r\n:,", kInMessage = "%\r\n";
    const std::string place = file.empty() ? "" : fmt::format("file={},", escaped(file, kInProperty));
    return fmt::format("::{} {}title={}::{}\n", info.passes ? "warning" : "error", place,
                       escaped(fmt::format("{}: {}", info.name, title), kInProperty), escaped(message, kInMessage));
}

}  // namespace

std::string comparisonAnnotations(const Comparison& comparison) {
    std::string text;
    for (const ImageResult& image : comparison.images) {
        // the golden is the file that the repository has
        text += command(fileAt(comparison.golden, image), image.name, image.outcome, explanation(image));
    }
    for (const StatisticsResult& column : comparison.statistics) {
        text += command("", column.column, column.outcome, explanation(column));
    }
    for (const BudgetResult& budget : comparison.budgets) {
        text += command("", "budget " + budget.name, outcomeOf(budget), explanation(budget));
    }
    return text;
}

}  // namespace umbrage
