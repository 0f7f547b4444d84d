// SPDX-License-Identifier: Apache-2.0
#include "golden/compare_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "diagnostics/statistics_format.h"
#include "job/glob.h"
#include "report/statistics_compare.h"
#include "report/statistics_table.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

using Column = std::pair<StatisticsPlace, std::string>;

std::string columnText(const Column& column) {
    const std::string place = placeText(column.first);
    return place.empty() ? column.second : fmt::format("{}, {}", column.second, place);
}

/// How far a column may be off, or why it is not compared.
struct Allowed {
    std::optional<double> share{};
    std::string reason{};
};

Allowed allowedFor(const std::string& name, const StatisticsFile& golden, const StatisticsFile& output,
                   const std::vector<StatisticsTolerance>& tolerances) {
    const auto rule = std::find_if(tolerances.rbegin(), tolerances.rend(),
                                   [&](const auto& tolerance) { return matchesGlob(tolerance.glob, name); });
    if (rule != tolerances.rend() && !rule->share) return {{}, fmt::format("{} is skipped by a rule", rule->glob)};
    const std::optional<std::string> before = unitOfFigure(golden, name), after = unitOfFigure(output, name);
    if (!before) return {{}, "the golden is older than this number"};
    if (rule != tolerances.rend()) return {rule->share};
    if (isMeasured(*before) || (after && isMeasured(*after))) return {{}, "measured, so it differs from run to run"};
    return {0.0};
}

/// In relation to the golden's value.
double shareOf(double golden, double output) {
    if (golden == output) return 0.0;
    return golden == 0.0 ? std::numeric_limits<double>::infinity() : std::abs(output - golden) / std::abs(golden);
}

/// One column, frame after frame.
class Judgement {
public:
    Judgement(const Column& column, Allowed allowed) : allowed_(std::move(allowed)) {
        result_.column = columnText(column);
        result_.tolerance = allowed_.share.value_or(0.0);
    }

    void frame(int frame, const double* golden, const double* output) {
        if (golden && output) {
            const double share = shareOf(*golden, *output);
            if (share <= worst_) return;
            worst_ = share;
            result_.frame = frame;
            result_.golden = *golden;
            result_.output = *output;
        } else if (!missing_) {
            missing_ = true;
            missingFrame_ = frame;
            inOutput_ = output;
        }
    }

    StatisticsResult result() const {
        StatisticsResult result = result_;
        if (!allowed_.share) {
            result.outcome = Outcome::Skipped;
            result.reason = allowed_.reason;
        } else if (missing_) {
            result.outcome = inOutput_ ? Outcome::MissingGolden : Outcome::MissingOutput;
            result.frame = missingFrame_;
            result.reason =
                fmt::format("the {} has no such number in frame {}", inOutput_ ? "golden" : "output", missingFrame_);
        } else if (worst_ > *allowed_.share) {
            result.outcome = Outcome::Fail;
            result.reason = std::isinf(worst_) ? std::string("the golden has 0")
                                               : fmt::format("{:.3g} % off, {:.3g} % is allowed", 100.0 * worst_,
                                                             100.0 * *allowed_.share);
        }
        return result;
    }

private:
    Allowed allowed_;
    StatisticsResult result_;
    double worst_ = -1.0;  // below any share, so that the first frame counts
    bool missing_ = false, inOutput_ = false;
    int missingFrame_ = 0;
};

using Places = NamedFrames::mapped_type;

const double* valueIn(const Places& places, const Column& column) {
    const auto place = places.find(column.first);
    if (place == places.end()) return nullptr;
    const auto value = place->second.find(column.second);
    return value == place->second.end() ? nullptr : &value->second;
}

/// Frames that only one of them has.
void addFrames(const NamedFrames& frames, const NamedFrames& others, Outcome outcome, const char* lacking,
               std::vector<StatisticsResult>& results) {
    std::size_t count = 0;
    int first = 0;
    for (const auto& [frame, places] : frames) {
        if (others.contains(frame)) continue;
        if (count++ == 0) first = frame;
    }
    if (count == 0) return;
    StatisticsResult result{.column = "frames", .frame = first, .outcome = outcome};
    result.reason = count == 1 ? fmt::format("frame {} is not in the {}", first, lacking)
                               : fmt::format("{} frames are not in the {}, the first is {}", count, lacking, first);
    results.push_back(std::move(result));
}

}  // namespace

std::vector<StatisticsResult> compareWithin(const StatisticsFile& golden, const StatisticsFile& output,
                                            const std::vector<StatisticsTolerance>& tolerances) {
    const NamedFrames goldens = namedFrames(golden), outputs = namedFrames(output);
    std::vector<StatisticsResult> results;
    addFrames(goldens, outputs, Outcome::MissingOutput, "output", results);
    addFrames(outputs, goldens, Outcome::MissingGolden, "golden", results);

    std::set<Column> columns;
    const auto addColumns = [&](const Places& places) {
        for (const auto& [place, values] : places) {
            for (const auto& [name, value] : values) columns.emplace(place, name);
        }
    };
    for (const auto& [frame, places] : goldens) {
        if (!outputs.contains(frame)) continue;
        addColumns(places);
        addColumns(outputs.at(frame));
    }
    for (const Column& column : columns) {
        Judgement judgement(column, allowedFor(column.second, golden, output, tolerances));
        for (const auto& [frame, places] : goldens) {
            const auto other = outputs.find(frame);
            if (other == outputs.end()) continue;
            const double* one = valueIn(places, column);
            const double* two = valueIn(other->second, column);
            if (one || two) judgement.frame(frame, one, two);
        }
        results.push_back(judgement.result());
    }
    return results;
}

std::string withinTable(const std::vector<StatisticsResult>& results) {
    std::vector<std::vector<std::string>> rows{{"column", "frame", "golden", "output", "outcome", ""}};
    std::map<Outcome, std::size_t> counts;
    for (const StatisticsResult& result : results) {
        ++counts[result.outcome];
        const OutcomeInfo& info = infoOf(result.outcome);
        if (info.passes) continue;
        const bool hasNumbers = result.outcome == Outcome::Fail;
        rows.push_back({result.column, std::to_string(result.frame), hasNumbers ? readableNumber(result.golden) : "",
                        hasNumbers ? readableNumber(result.output) : "", std::string(info.name), result.reason});
    }
    std::string text = rows.size() > 1 ? alignedTable(rows, {true, false, false, false, true, true}) : "";
    std::string separator = rows.size() > 1 ? "\n" : "";
    for (const auto& [outcome, count] : counts) {
        text += fmt::format("{}{} {}", std::exchange(separator, ", "), count, infoOf(outcome).name);
    }
    return text + "\n";
}

}  // namespace umbrage
