// SPDX-License-Identifier: Apache-2.0
// The two forms that people read.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "report/text_table.h"
#include "report/verify_report.h"

namespace umbrage {
namespace {

struct Column {
    std::string_view title, doc;
    bool isText;
    std::string (*text)(const VerifySum&);
};

std::string number(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "not finite";
}

/// A figure that says nothing where there is nothing to say it of.
std::string orDash(bool known, const std::string& text) {
    return known ? text : "-";
}

constexpr Column kSequence{"sequence", "", true, [](const VerifySum& s) { return s.sequence; }};
constexpr Column kTechnique{"technique", "silhouettes:count", true, [](const VerifySum& s) { return s.technique; }};
constexpr Column kFrame{"frame", "", false, [](const VerifySum& s) { return fmt::format("{}", s.frame); }};
constexpr Column kFrames{"frames", "judged", false, [](const VerifySum& s) { return fmt::format("{}", s.frames); }};
constexpr Column kLight{"light", "", true, [](const VerifySum& s) { return s.light; }};

constexpr Column kFigures[] = {
    {"light-facing", "samples of surfaces that are turned to the light, over all lights", false,
     [](const VerifySum& s) { return fmt::format("{}", s.lights.litFacing); }},
    {"hard", "samples that are wrong without excuse", false,
     [](const VerifySum& s) { return fmt::format("{}", s.lights.hard()); }},
    {"band", "samples that differ within what the rasteriser may round", false,
     [](const VerifySum& s) { return fmt::format("{}", s.lights.band()); }},
    {"band rate", "the same for each light-facing sample", false,
     [](const VerifySum& s) { return orDash(s.lights.litFacing > 0, number(s.lights.bandRate(), "{:.2g}")); }},
    {"bias px", "how far shadows reach too far on average, pixels", false,
     [](const VerifySum& s) {
         return orDash(s.lights.boundaryLength > 0.0, number(s.lights.signedBias(), "{:+.5f}"));
     }},
    {"largest", "most wrong pixels that hang together, and their longer side in pixels", false,
     [](const VerifySum& s) { return fmt::format("{} ({} px)", s.lights.largestComponent, s.lights.largestExtent); }},
    {"count errors", "integer counts that differ: hard / all", false,
     [](const VerifySum& s) {
         return orDash(s.lights.countsJudged > 0,
                       fmt::format("{} / {}", s.lights.hardCountErrors, s.lights.countErrors));
     }},
    {"radiance", "largest difference from the picture with exact shadows, linear", false,
     [](const VerifySum& s) { return number(s.radiance.largest, "{:.2g}"); }},
    {"codes", "the same in 8-bit display codes", false,
     [](const VerifySum& s) { return fmt::format("{}", s.radiance.largestCode); }},
    {"toggles", "changes from frame to frame that the exact shadow does not make", false,
     [](const VerifySum& s) { return fmt::format("{}", s.lights.excessToggles); }},
    {"ms", "a frame rendered and every sample read back; median; the first of a sequence sets up, too", false,
     [](const VerifySum& s) { return number(s.medianRenderMilliseconds, "{:.1f}"); }},
    {"oracle ms", "the exact answers of a frame, once for all techniques; median", false,
     [](const VerifySum& s) { return number(s.medianOracleMilliseconds, "{:.0f}"); }},
};

/// Of rows as sums() has them, or as techniqueSums().
std::vector<Column> columnsOf(const VerifyDetail& detail, bool sequences = true) {
    std::vector<Column> columns;
    if (sequences) columns.push_back(kSequence);
    columns.insert(columns.end(), {kTechnique, detail.frames ? kFrame : kFrames});
    if (detail.lights) columns.push_back(kLight);
    columns.insert(columns.end(), std::begin(kFigures), std::end(kFigures));
    return columns;
}

std::vector<std::string> titlesOf(const std::vector<Column>& columns) {
    std::vector<std::string> titles;
    for (const Column& column : columns) titles.emplace_back(column.title);
    return titles;
}

std::vector<std::string> cellsOf(const std::vector<Column>& columns, const VerifySum& sum) {
    std::vector<std::string> cells;
    for (const Column& column : columns) cells.push_back(column.text(sum));
    return cells;
}

/// With the titles in front.
std::vector<std::vector<std::string>> rowsOf(const std::vector<Column>& columns, const std::vector<VerifySum>& sums) {
    std::vector<std::vector<std::string>> rows{titlesOf(columns)};
    for (const VerifySum& sum : sums) rows.push_back(cellsOf(columns, sum));
    return rows;
}

std::vector<bool> areText(const std::vector<Column>& columns) {
    std::vector<bool> isText;
    for (const Column& column : columns) isText.push_back(column.isText);
    return isText;
}

std::string textTable(const std::vector<Column>& columns, const std::vector<VerifySum>& sums) {
    return alignedTable(rowsOf(columns, sums), areText(columns));
}

std::string sumsInMarkdown(const std::vector<Column>& columns, const std::vector<VerifySum>& sums) {
    return markdownTable(rowsOf(columns, sums), areText(columns));
}

struct WrongLight {
    std::uint64_t errors;
    bool claimsExact;
    std::string place, techniques, figures;
};

/// Frames and lights with hard errors, the worst ones first; techniques that err alike together.
std::vector<WrongLight> wrongLights(const VerifyReport& report) {
    std::map<std::tuple<std::string, std::string, bool>, std::size_t> known;
    std::vector<WrongLight> wrong;
    for (const VerifySum& sum : report.sums({.frames = true, .lights = true})) {
        const LightVerdict& light = sum.lights;
        if (light.hard() + light.hardCountErrors == 0) continue;
        const std::string place = fmt::format("{} frame {}, light {}", sum.sequence, sum.frame, sum.light);
        std::string figures = fmt::format("{} false dark, {} false lit", light.hardFalseDark, light.hardFalseLit);
        if (light.hardCountErrors > 0) figures += fmt::format(", {} wrong counts", light.hardCountErrors);
        const auto [found, isNew] = known.try_emplace({place, figures, sum.claimsExact}, wrong.size());
        if (isNew) {
            wrong.push_back({light.hard() + light.hardCountErrors, sum.claimsExact, place, sum.technique, figures});
        } else {
            wrong[found->second].techniques += " " + sum.technique;
        }
    }
    std::stable_sort(wrong.begin(), wrong.end(), [](const WrongLight& a, const WrongLight& b) {
        return std::pair(a.claimsExact, a.errors) > std::pair(b.claimsExact, b.errors);
    });
    return wrong;
}

std::vector<std::string> errorLines(const VerifyReport& report, std::size_t most) {
    const std::vector<WrongLight> wrong = wrongLights(report);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(most, wrong.size()); ++i) {
        const WrongLight& one = wrong[i];
        lines.push_back(printable(fmt::format("{}: {} by {}{}", one.place, one.figures, one.techniques,
                                              one.claimsExact ? "" : " (claims no exactness)")));
    }
    if (wrong.size() > most) lines.push_back(fmt::format("and {} lines more", wrong.size() - most));
    return lines;
}

std::string counted(std::uint64_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string conclusion(const VerifyReport& report, const VerifyHeader& header) {
    LightVerdict all;
    std::size_t frames = 0;
    std::uint64_t unclaimed = 0;
    for (const VerifySum& sum : report.sums()) {
        if (!sum.claimsExact) {
            unclaimed += sum.lights.hard() + sum.lights.hardCountErrors;
            continue;
        }
        all.litFacing += sum.lights.litFacing;
        all.hardFalseDark += sum.lights.hard();
        all.countsJudged += sum.lights.countsJudged;
        all.hardCountErrors += sum.lights.hardCountErrors;
        frames += sum.frames;
    }
    std::string text = fmt::format("{} in {} light-facing samples of {}", counted(all.hard(), "hard error"),
                                   all.litFacing, counted(frames, "frame"));
    if (all.countsJudged > 0) {
        text += fmt::format(", {} of {}", counted(all.hardCountErrors, "wrong count"), all.countsJudged);
    }
    if (unclaimed > 0) text += fmt::format("; {} where no exactness is claimed", unclaimed);
    if (header.maxHard > 0) text += fmt::format("; {} would pass", header.maxHard);
    if (!header.fault.empty()) text += fmt::format("; with the fault {}", header.fault);
    return text;
}

/// Hard errors of each silhouette technique (down) with each count (across); empty without several of both.
std::string matrixInMarkdown(const std::vector<VerifySum>& techniques) {
    std::vector<std::string> silhouettes, counts;
    std::map<std::string, std::string> cells;
    const auto addOnce = [](std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const VerifySum& sum : techniques) {
        const std::size_t colon = sum.technique.find(':');
        addOnce(silhouettes, sum.technique.substr(0, colon));
        addOnce(counts, sum.technique.substr(colon + 1));
        cells[sum.technique] = fmt::format("{}{}", sum.lights.hard(), sum.claimsExact ? "" : " (claims no exactness)");
    }
    if (silhouettes.size() < 2 || counts.size() < 2) return "";
    std::vector<std::vector<std::string>> rows{{"hard errors"}};
    rows[0].insert(rows[0].end(), counts.begin(), counts.end());
    for (const std::string& silhouette : silhouettes) {
        std::vector<std::string>& row = rows.emplace_back(std::vector<std::string>{silhouette});
        for (const std::string& count : counts) {
            const auto found = cells.find(silhouette + ":" + count);
            row.push_back(found == cells.end() ? "-" : found->second);
        }
    }
    std::vector<bool> isText(counts.size() + 1, false);
    isText[0] = true;
    return markdownTable(rows, isText) + "\n";
}

}  // namespace

std::string VerifyReport::table(const VerifyDetail& detail) const {
    std::string text;
    const std::vector<VerifySum> rows = detail.summary ? techniqueSums() : sums(detail);
    if (!rows.empty()) text += textTable(columnsOf(detail, !detail.summary), rows) + "\n";
    for (const std::string& line : errorLines(*this, 20)) text += "wrong: " + line + "\n";
    for (const Problem& problem : problems_) {
        text += printable(fmt::format("not judged: {}: {}", problem.sequence, problem.message)) + "\n";
    }
    return text + conclusion(*this, header_) + "\n";
}

std::string VerifyReport::markdown(const VerifyDetail& detail) const {
    std::string text = fmt::format(
        "# Shadows against the exact answer\n\nMade by this command; changes by hand are lost:\n\n    {}\n\n"
        "umbrage {} on {} ({}). Tolerance: {:g} px sideways, {:g} of the largest distance in depth, {:g} of the "
        "largest "
        "coordinate, {:g} from grazing.\n\n**{}**\n",
        printable(header_.command), header_.version, header_.device, header_.driver, header_.tolerance.lateralPixels,
        header_.tolerance.depth, header_.tolerance.position, header_.tolerance.grazing, conclusion(*this, header_));
    const std::vector<std::string> errors = errorLines(*this, 100);
    if (!errors.empty() || !problems_.empty()) text += "\n## What is wrong\n\n";
    for (const std::string& line : errors) text += "- " + markdownCell(line) + "\n";
    for (const Problem& problem : problems_) {
        text += fmt::format("- not judged: {}: {}\n", markdownCell(problem.sequence), markdownCell(problem.message));
    }
    const std::vector<VerifySum> techniques = techniqueSums();
    text += "\n## All sequences\n\n" + matrixInMarkdown(techniques) + sumsInMarkdown(columnsOf({}, false), techniques);
    if (!detail.summary) text += "\n## Each sequence\n\n" + sumsInMarkdown(columnsOf(detail), sums(detail));
    text += "\n## What the columns say\n\n";
    for (const Column& column : columnsOf({})) {
        if (!column.doc.empty()) text += fmt::format("- {}: {}\n", column.title, column.doc);
    }
    return text;
}

}  // namespace umbrage
