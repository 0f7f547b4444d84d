// SPDX-License-Identifier: Apache-2.0
// What a comparison with golden frames may differ by: golden: of the sequence file, or a file of rules.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrage {

/// A figure of how far two pictures differ.
struct MetricInfo {
    std::string_view name;     // in rules and reports
    std::string_view meaning;  // for people
    std::string_view unit;     // of the value; empty: a plain number
    bool largerIsWorse = true;
};

/// A sample is one channel's value of one pixel. Differences of integer channels count as numbers.
inline constexpr std::array kMetrics{
    MetricInfo{"max-abs", "largest difference of a sample", "value"},
    MetricInfo{"mean-abs", "mean difference over all samples", "value"},
    MetricInfo{"rmse", "root of the mean square difference over all samples", "value"},
    MetricInfo{"psnr", "peak signal to noise ratio; infinite for equal pictures", "dB", false},
    MetricInfo{"max-relative", "largest difference of a sample, in relation to the golden's", "ratio"},
    MetricInfo{"mean-relative", "mean over all samples of the difference in relation to the golden's", "ratio"},
    MetricInfo{"fraction", "share of pixels that differ by more than the tolerance", "share"},
    MetricInfo{"densest", "share of such pixels in the window that has most of them", "share"},
    MetricInfo{"uint-different", "samples of integer channels that are not equal", "samples"},
    MetricInfo{"flip", "mean of the FLIP error map, at one exposure", "[0, 1]"},
    MetricInfo{"flip-median", "weighted median of the FLIP error map: half of all error lies above", "[0, 1]"},
    MetricInfo{"flip-max", "largest value of the FLIP error map", "[0, 1]"},
    MetricInfo{"hdr-flip", "mean of the FLIP error map, the largest over all exposures at each pixel", "[0, 1]"},
    MetricInfo{"hdr-flip-max", "largest value of that map", "[0, 1]"},
    MetricInfo{"yee", "share of pixels that fail OpenImageIO's version of Yee's perceptual comparison", "share"},
};

/// Of one metric. At least one of the two is there.
struct GoldenLimit {
    std::string name;  // of its own, for reports
    std::string metric;
    std::optional<double> fail{}, warn{};
};

/// What holds for the pictures that a pattern matches.
struct GoldenRule {
    std::string pattern;                                   // default, an AOV, or a glob of file names
    std::optional<double> tolerance{};                     // of `fraction` and `densest`
    std::optional<int> window{};                           // of `densest`, pixels a side
    std::optional<std::vector<GoldenLimit>> all{}, any{};  // every one must hold; one of these suffices
    std::string skip, expectFailure;                       // the reason; empty: neither
};

/// What holds between goldens of one device and output of another. Globs of "renderer, version, processor".
struct GoldenPair {
    std::string golden, output;
    std::vector<GoldenRule> rules;
};

/// What columns of the statistics may be off by.
struct StatisticsTolerance {
    std::string glob;               // of counters and figures: "overdraw.*"
    std::optional<double> share{};  // of the golden's value, at least 0; none: not compared
};

struct GoldenRules {
    std::vector<GoldenRule> rules;  // later ones win
    std::vector<GoldenPair> devices;
    std::vector<StatisticsTolerance> statistics;  // later ones win
};

/// @throws Error(Input) with file:line:column
GoldenRules readGoldenRules(const std::filesystem::path& file);

}  // namespace umbrage
