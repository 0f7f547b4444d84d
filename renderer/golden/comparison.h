// SPDX-License-Identifier: Apache-2.0
// What a comparison of output with golden frames found: the model that every report is a view of.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/budgets.h"

namespace umbrage {

enum class Outcome : std::uint8_t {  // in the order of kOutcomes
    Pass,
    Warn,
    Skipped,
    ExpectedFailure,
    Fail,
    UnexpectedPass,
    MissingOutput,
    MissingGolden,
    ExtraOutput,
    SizeMismatch,
    ChannelMismatch,
    NonFinite,
    Unreadable,
};

struct OutcomeInfo {
    std::string_view name;     // in files
    std::string_view meaning;  // for people
    bool passes;               // leaves the exit code at 0
};

inline constexpr std::array kOutcomes{
    OutcomeInfo{"pass", "within all limits", true},
    OutcomeInfo{"warn", "within all limits, but over one that warns", true},
    OutcomeInfo{"skipped", "not compared, for a reason", true},
    OutcomeInfo{"expected-failure", "differs, as expected", true},
    OutcomeInfo{"fail", "over a limit", false},
    OutcomeInfo{"unexpected-pass", "was expected to differ, and does not", false},
    OutcomeInfo{"missing-output", "a golden has no output", false},
    OutcomeInfo{"missing-golden", "an output has no golden, but its folder should have one", false},
    OutcomeInfo{"extra-output", "an output that nobody asked for", false},
    OutcomeInfo{"size-mismatch", "other size or data window", false},
    OutcomeInfo{"channel-mismatch", "other channels or pixel types", false},
    OutcomeInfo{"non-finite", "a NaN or infinity where the golden has none, or elsewhere", false},
    OutcomeInfo{"unreadable", "one of the files cannot be read", false},
};

constexpr const OutcomeInfo& infoOf(Outcome outcome) {
    return kOutcomes[std::size_t(outcome)];
}

/// A figure of a picture's difference, by its name in kMetrics (metrics.h).
struct Figure {
    std::string metric;
    double value = 0.0;
};

/// The limit that decided, or the one that came nearest to deciding.
struct Decision {
    std::string rule;    // the limit's own name
    std::string metric;  // of kMetrics
    double limit = 0.0, value = 0.0;
};

struct ImageResult {
    std::string name;  // of the file from either folder on, with '/'
    std::string aov;   // as the name says it; empty where it does not
    int frame = 0;     // the same; 0: no frame
    Outcome outcome = Outcome::Pass;
    std::string reason;  // a sentence; empty for a plain pass
    std::optional<Decision> decision{};
    std::vector<Figure> figures{};  // empty where a gate closed before anything was measured
    int width = 0, height = 0;      // pixels
    std::vector<std::string> channels{};
    std::pair<int, int> worst{-1, -1};  // the pixel that differs most, from the top left; -1: none
};

/// A column of the statistics against the golden's.
struct StatisticsResult {
    std::string column;  // counter or figure, with its light, caster or material
    int frame = 0;       // the one that differs most; 0: of the whole sequence
    Outcome outcome = Outcome::Pass;
    double golden = 0.0, output = 0.0;
    double tolerance = 0.0;  // share of the golden's value
    std::string reason{};
};

/// What made a set of pictures: from manifest.json beside them.
struct Provenance {
    std::string renderer, version;  // GL_RENDERER, GL_VERSION
    std::string processor;          // vector and FMA flags that a software device compiles for: "avx2 fma"
    std::string tool;               // umbrage's version
    std::string job;                // fingerprint of what shaped the pictures

    /// Whether the same bytes may be expected of both.
    bool sameDevice(const Provenance& other) const {
        return renderer == other.renderer && version == other.version && processor == other.processor;
    }
};

struct Comparison {
    std::string golden, output;  // folders, or files
    std::optional<Provenance> goldenFrom{}, outputFrom{};
    bool foreignDevice = false;  // allowed, and judged by the tolerance of that pair
    std::vector<std::string> notes{};
    std::vector<ImageResult> images{};  // by name
    std::vector<StatisticsResult> statistics{};
    std::vector<BudgetResult> budgets{};       // of the output's statistics
    std::string renderCommand, acceptCommand;  // to make the output again, and to make it the golden

    /// Whether the exit code is 0.
    bool passes() const;
};

/// A picture's file at Comparison::golden or output, which are folders, or that file.
std::string fileAt(const std::string& place, const ImageResult& image);

}  // namespace umbrage
