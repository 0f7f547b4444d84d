// SPDX-License-Identifier: Apache-2.0
#include "golden/compare_images.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "job/glob.h"

namespace umbrage {
namespace {

std::vector<std::string> channelNames(const StoredImage& image) {
    std::vector<std::string> names;
    for (const StoredChannel& channel : image.channels) names.push_back(channel.name);
    return names;
}

const char* nameOf(PixelType type) {
    switch (type) {
        case PixelType::UInt8:
            return "8 bits";
        case PixelType::UInt16:
            return "16 bits";
        case PixelType::UInt32:
            return "32-bit integers";
        case PixelType::Half:
            return "half floats";
        default:
            return "floats";
    }
}

std::string textOf(const PixelWindow& window) {
    return fmt::format("{} x {} at ({}, {})", window.width, window.height, window.x, window.y);
}

/// Closed gates: an outcome and the reason.
struct Gate {
    Outcome outcome;
    std::string reason;
};

std::optional<Gate> sizeGate(const StoredImage& golden, const StoredImage& output) {
    if (golden.data == output.data && golden.display == output.display) return std::nullopt;
    const bool data = golden.data != output.data;
    return Gate{Outcome::SizeMismatch,
                fmt::format("the {} is {}, the golden's {}", data ? "picture" : "display window",
                            textOf(data ? output.data : output.display), textOf(data ? golden.data : golden.display))};
}

std::optional<Gate> channelGate(const StoredImage& golden, const StoredImage& output) {
    const std::vector<std::string> theirs = channelNames(golden), ours = channelNames(output);
    if (theirs != ours) {
        return Gate{Outcome::ChannelMismatch,
                    fmt::format("the channels are {}, the golden's {}", fmt::join(ours, " "), fmt::join(theirs, " "))};
    }
    for (std::size_t k = 0; k < golden.channels.size(); ++k) {
        const PixelType theirType = golden.channels[k].type, type = output.channels[k].type;
        if (theirType == type) continue;
        return Gate{Outcome::ChannelMismatch,
                    fmt::format("channel {} holds {}, the golden's {}", ours[k], nameOf(type), nameOf(theirType))};
    }
    return std::nullopt;
}

std::optional<Gate> finiteGate(const StoredImage& golden, const StoredImage& output) {
    for (std::size_t k = 0; k < golden.channels.size(); ++k) {
        const std::vector<float>* theirs = golden.floats(golden.channels[k].name);
        const std::vector<float>* ours = output.floats(golden.channels[k].name);
        if (!theirs || !ours) continue;
        std::size_t count = 0, first = 0;
        bool ofGolden = false;
        for (std::size_t i = 0; i < theirs->size(); ++i) {
            const float a = (*theirs)[i], b = (*ours)[i];
            if (std::isfinite(a) && std::isfinite(b)) continue;
            if (std::isinf(a) && a == b) continue;
            if (count++ == 0) first = i, ofGolden = std::isfinite(b);
        }
        if (count == 0) continue;
        const std::size_t width = std::size_t(golden.data.width);
        return Gate{Outcome::NonFinite,
                    fmt::format("{} value{} of channel {} {} no number{}, first at ({}, {})", count,
                                count == 1 ? "" : "s", golden.channels[k].name, count == 1 ? "is" : "are",
                                ofGolden ? " in the golden" : "", first % width, first / width)};
    }
    return std::nullopt;
}

bool hasIntegers(const StoredImage& image) {
    return std::ranges::any_of(image.channels, [](const StoredChannel& c) { return c.type == PixelType::UInt32; });
}

/// Those that say something about the picture.
std::vector<GoldenLimit> applying(const std::vector<GoldenLimit>& limits, const StoredImage& image) {
    std::vector<GoldenLimit> applying;
    for (const GoldenLimit& limit : limits) {
        if (applies(limit.metric, image)) applying.push_back(limit);
    }
    return applying;
}

struct Verdict {
    Outcome outcome = Outcome::Pass;
    double severity = -1.0;  // the larger the nearer to the limit; above 1: over it
    Decision decision;
};

double severityOf(double value, double limit, bool largerIsWorse) {
    if (!largerIsWorse) return std::isinf(value) ? 0.0 : limit / std::max(value, 1e-300);
    if (value <= limit) return limit > 0.0 ? value / limit : 0.0;
    return limit > 0.0 ? value / limit : std::numeric_limits<double>::max();
}

Verdict judge(const GoldenLimit& limit, const std::vector<Figure>& figures) {
    const auto at = std::ranges::find(figures, limit.metric, &Figure::metric);
    const double value = at->value;
    const bool largerIsWorse = findMetric(limit.metric)->largerIsWorse;
    const auto isOver = [&](const std::optional<double>& most) {
        return most && (largerIsWorse ? value > *most : value < *most);
    };
    const double decisive = isOver(limit.fail) || !limit.warn ? *limit.fail : *limit.warn;
    Verdict verdict{
        Outcome::Pass, severityOf(value, decisive, largerIsWorse), {limit.name, limit.metric, decisive, value}};
    if (isOver(limit.fail)) {
        verdict.outcome = Outcome::Fail;
    } else if (isOver(limit.warn)) {
        verdict.outcome = Outcome::Warn;
    }
    return verdict;
}

int rank(Outcome outcome) {
    return outcome == Outcome::Fail ? 2 : outcome == Outcome::Warn ? 1 : 0;
}

/// The worst of the limits, or the best of them; empty: none.
std::optional<Verdict> verdictOf(const std::vector<GoldenLimit>& limits, const std::vector<Figure>& figures,
                                 bool worst) {
    std::optional<Verdict> chosen;
    for (const GoldenLimit& limit : limits) {
        const Verdict verdict = judge(limit, figures);
        const auto key = [](const Verdict& v) { return std::pair(rank(v.outcome), v.severity); };
        if (!chosen || (worst ? key(verdict) > key(*chosen) : key(verdict) < key(*chosen))) chosen = verdict;
    }
    return chosen;
}

void decide(ImageResult& result, const std::vector<GoldenLimit>& all, const std::vector<GoldenLimit>& any) {
    std::optional<Verdict> verdict = verdictOf(all, result.figures, true);
    if (const std::optional<Verdict> best = verdictOf(any, result.figures, false)) {
        if (!verdict || rank(best->outcome) > rank(verdict->outcome)) verdict = best;
    }
    if (!verdict) return;
    result.outcome = verdict->outcome;
    result.decision = verdict->decision;
}

std::vector<std::string> wantedMetrics(const std::vector<GoldenLimit>& all, const std::vector<GoldenLimit>& any,
                                       const StoredImage& image) {
    std::set<std::string_view> wanted{"max-abs", "mean-abs", "rmse", "psnr", "fraction", "densest", "uint-different"};
    for (const std::vector<GoldenLimit>* limits : {&all, &any}) {
        for (const GoldenLimit& limit : *limits) wanted.insert(limit.metric);
    }
    std::vector<std::string> ordered;
    for (const MetricInfo& metric : kMetrics) {
        if (wanted.contains(metric.name) && applies(metric.name, image)) ordered.emplace_back(metric.name);
    }
    return ordered;
}

std::vector<Figure> figuresOfEqual(const std::vector<std::string>& wanted) {
    std::vector<Figure> figures;
    for (const std::string& metric : wanted) {
        figures.push_back({metric, findMetric(metric)->largerIsWorse ? 0.0 : std::numeric_limits<double>::infinity()});
    }
    return figures;
}

void expectFailure(ImageResult& result, const std::string& why) {
    if (result.outcome == Outcome::Pass || result.outcome == Outcome::Warn) {
        result.outcome = Outcome::UnexpectedPass;
        result.reason = "it passes, though it was expected to fail: " + why;
    } else {
        result.outcome = Outcome::ExpectedFailure;
        result.reason = fmt::format("as expected: {}{}{}", why, result.reason.empty() ? "" : "; ", result.reason);
    }
}

void measureAndDecide(ImageResult& result, const StoredImage& golden, const StoredImage& output,
                      const ImageRules& rules, bool equalFiles) {
    std::vector<GoldenLimit> all = applying(rules.all, golden);
    const std::vector<GoldenLimit> any = applying(rules.any, golden);
    if (all.empty() && any.empty()) all = applying({{"equal", "max-abs", 0.0, {}}}, golden);
    const auto isOfIntegers = [](const GoldenLimit& limit) { return limit.metric == "uint-different"; };
    if (hasIntegers(golden) && std::ranges::none_of(all, isOfIntegers) && std::ranges::none_of(any, isOfIntegers)) {
        all.push_back({"integers", "uint-different", 0.0, {}});
    }
    const std::vector<std::string> wanted = wantedMetrics(all, any, golden);
    if (equalFiles) {
        result.figures = figuresOfEqual(wanted);
    } else {
        Measured measured = measure(golden, output, rules.measure, wanted);
        result.figures = std::move(measured.figures);
        result.worst = measured.worst;
    }
    decide(result, all, any);
}

}  // namespace

ImageRules rulesFor(std::span<const GoldenRule> rules, const std::string& name, const std::string& aov) {
    ImageRules found;
    const std::string file = name.substr(name.rfind('/') + 1);
    for (const GoldenRule& rule : rules) {
        const bool matches = rule.pattern == "default" || rule.pattern == aov || matchesGlob(rule.pattern, name) ||
                             matchesGlob(rule.pattern, file);
        if (!matches) continue;
        if (rule.tolerance) found.measure.tolerance = *rule.tolerance;
        if (rule.window) found.measure.window = *rule.window;
        if (rule.all) found.all = *rule.all;
        if (rule.any) found.any = *rule.any;
        if (!rule.skip.empty()) found.skip = rule.skip;
        if (!rule.expectFailure.empty()) found.expectFailure = rule.expectFailure;
    }
    return found;
}

std::vector<GoldenRule> rulesOfOtherDevices() {
    // Between llvmpipe with 8 and with 4 lanes the worst of our own goldens has 0.00008 and 0.025; the rest is room for
    // devices that nobody has measured yet.
    GoldenRule rule;
    rule.pattern = "default";
    rule.tolerance = 0.02;
    rule.all = {{"few pixels of another device", "fraction", 0.002, {}},
                {"no cluster of another device", "densest", 0.25, {}},
                {"integers of another device", "uint-different", {}, 0.0}};
    return {rule};
}

ImageResult compareImages(const StoredImage& golden, const StoredImage& output, const ImageRules& rules,
                          bool equalFiles) {
    ImageResult result;
    result.width = output.data.width;
    result.height = output.data.height;
    result.channels = channelNames(output);
    if (!rules.skip.empty()) {
        result.outcome = Outcome::Skipped;
        result.reason = rules.skip;
        return result;
    }
    std::optional<Gate> gate = sizeGate(golden, output);
    if (!gate) gate = channelGate(golden, output);
    if (!gate) gate = finiteGate(golden, output);
    if (gate) {
        result.outcome = gate->outcome;
        result.reason = gate->reason;
    } else {
        measureAndDecide(result, golden, output, rules, equalFiles);
    }
    if (!rules.expectFailure.empty()) expectFailure(result, rules.expectFailure);
    return result;
}

}  // namespace umbrage
