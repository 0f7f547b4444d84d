// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "golden/reports.h"
#include "golden/result_text.h"
#include "report/markup.h"

namespace umbrage {
namespace {

/// XML has only valid UTF-8; names of files need not be.
std::string attribute(const std::string& text) {
    using Json = nlohmann::json;
    const std::string valid = Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
    return escapedMarkup(valid);
}

struct Suite {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    std::string cases;

    void add(const std::string& suiteName, const std::string& name, Outcome outcome, const std::string& why) {
        const OutcomeInfo& info = infoOf(outcome);
        const std::string because = attribute(fmt::format("{}: {}", info.name, why));
        ++tests;
        std::string inside;
        if (outcome == Outcome::Skipped || outcome == Outcome::ExpectedFailure) {
            ++skipped;
            inside = fmt::format("<skipped message=\"{}\"/>", because);
        } else if (outcome == Outcome::Unreadable) {
            ++errors;
            inside = fmt::format("<error type=\"{}\" message=\"{}\"/>", info.name, because);
        } else if (!info.passes) {
            ++failures;
            inside = fmt::format("<failure type=\"{}\" message=\"{}\"/>", info.name, because);
        } else if (outcome == Outcome::Warn) {
            inside = fmt::format("<system-out>{}</system-out>", because);
        }
        cases +=
            fmt::format("    <testcase classname=\"golden.{}\" name=\"{}\"", attribute(suiteName), attribute(name));
        cases += inside.empty() ? "/>\n" : fmt::format(">{}</testcase>\n", inside);
    }
};

}  // namespace

std::string comparisonJunit(const Comparison& comparison) {
    std::map<std::string, Suite> suites;
    for (const ImageResult& image : comparison.images) {
        const std::string name = image.aov.empty() ? "images" : image.aov;
        suites[name].add(name, image.name, image.outcome, explanation(image));
    }
    for (const StatisticsResult& column : comparison.statistics) {
        const std::string place = column.frame > 0 ? fmt::format(" frame {}", column.frame) : "";
        suites["statistics"].add("statistics", column.column + place, column.outcome, explanation(column));
    }
    for (const BudgetResult& budget : comparison.budgets) {
        suites["budgets"].add("budgets", fmt::format("{} {}", budget.name, boundName(budget)), outcomeOf(budget),
                              explanation(budget));
    }
    Suite all;
    std::string body;
    for (const auto& [name, suite] : suites) {
        all.tests += suite.tests;
        all.failures += suite.failures;
        all.errors += suite.errors;
        body += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n",
            attribute(name), suite.tests, suite.failures, suite.errors, suite.skipped, suite.cases);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"umbrage compare\" tests=\"{}\" failures=\"{}\" "
        "errors=\"{}\">\n{}</testsuites>\n",
        all.tests, all.failures, all.errors, body);
}

}  // namespace umbrage
