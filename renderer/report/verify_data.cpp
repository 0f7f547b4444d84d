// SPDX-License-Identifier: Apache-2.0
// The two forms that programs read.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "diagnostics/csv_field.h"
#include "report/verify_report.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

/// Names of figures, the same in JSON and CSV.
struct Figure {
    const char* name;
    Json (*of)(const LightVerdict&);
};

constexpr Figure kFigures[] = {
    {"litFacing", [](const LightVerdict& v) -> Json { return v.litFacing; }},
    {"exactDark", [](const LightVerdict& v) -> Json { return v.exactDark; }},
    {"hard", [](const LightVerdict& v) -> Json { return v.hard(); }},
    {"hardFalseDark", [](const LightVerdict& v) -> Json { return v.hardFalseDark; }},
    {"hardFalseLit", [](const LightVerdict& v) -> Json { return v.hardFalseLit; }},
    {"band", [](const LightVerdict& v) -> Json { return v.band(); }},
    {"primary", [](const LightVerdict& v) -> Json { return v.primary; }},
    {"grazing", [](const LightVerdict& v) -> Json { return v.grazing; }},
    {"boundary", [](const LightVerdict& v) -> Json { return v.boundary; }},
    {"bandFalseDark", [](const LightVerdict& v) -> Json { return v.bandFalseDark; }},
    {"bandFalseLit", [](const LightVerdict& v) -> Json { return v.bandFalseLit; }},
    {"bandPopulation", [](const LightVerdict& v) -> Json { return v.bandPopulation; }},
    {"bandRate", [](const LightVerdict& v) -> Json { return v.bandRate(); }},
    {"boundaryLengthPixels", [](const LightVerdict& v) -> Json { return v.boundaryLength; }},
    {"signedBiasPixels", [](const LightVerdict& v) -> Json { return v.signedBias(); }},
    {"largestComponent", [](const LightVerdict& v) -> Json { return v.largestComponent; }},
    {"largestExtentPixels", [](const LightVerdict& v) -> Json { return v.largestExtent; }},
    {"countsJudged", [](const LightVerdict& v) -> Json { return v.countsJudged; }},
    {"countErrors", [](const LightVerdict& v) -> Json { return v.countErrors; }},
    {"hardCountErrors", [](const LightVerdict& v) -> Json { return v.hardCountErrors; }},
    {"largestCountError", [](const LightVerdict& v) -> Json { return v.largestCountError; }},
    {"excessToggles", [](const LightVerdict& v) -> Json { return v.excessToggles; }},
};

/// JSON has no infinity and no NaN: a figure that is neither is null there and empty in CSV.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Figures of whole frames.
std::vector<std::pair<const char*, Json>> frameFigures(const RadianceError& radiance, double renderMilliseconds,
                                                       double oracleMilliseconds) {
    return {{"radianceLargest", finite(radiance.largest)}, {"radianceRms", finite(radiance.rms)},
            {"codeLargest", radiance.largestCode},         {"codeRms", finite(radiance.rmsCode)},
            {"renderMilliseconds", renderMilliseconds},    {"oracleMilliseconds", oracleMilliseconds}};
}

Json rowOf(const VerifySum& sum) {
    Json row = Json::object();
    if (!sum.sequence.empty()) row["sequence"] = sum.sequence;
    row["technique"] = sum.technique;
    row["claimsExact"] = sum.claimsExact;
    row["frames"] = sum.frames;
    for (const Figure& figure : kFigures) row[figure.name] = figure.of(sum.lights);
    for (auto& [name, value] : frameFigures(sum.radiance, sum.medianRenderMilliseconds, sum.medianOracleMilliseconds)) {
        row[name] = std::move(value);
    }
    return row;
}

Json rowOf(const std::string& sequence, const FrameVerdict& verdict) {
    Json row{{"sequence", sequence}, {"frame", verdict.frame}, {"technique", verdict.technique}};
    for (auto& [name, value] : frameFigures(verdict.radiance, verdict.renderMilliseconds, verdict.oracleMilliseconds)) {
        row[name] = std::move(value);
    }
    Json& lights = row["lights"] = Json::array();
    for (const LightVerdict& light : verdict.lights) {
        Json& one = lights.emplace_back(Json{{"light", light.light}});
        for (const Figure& figure : kFigures) one[figure.name] = figure.of(light);
    }
    return row;
}

/// Names are whatever a scene says: bytes that are not UTF-8 become U+FFFD rather than an exception.
std::string textOf(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A row a line, so that versions of a report can be compared by eye.
std::string member(const char* name, const std::vector<Json>& rows) {
    std::string text = fmt::format(",\n  \"{}\": [", name);
    for (std::size_t i = 0; i < rows.size(); ++i) text += (i > 0 ? ",\n    " : "\n    ") + textOf(rows[i]);
    return text + (rows.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string VerifyReport::json(const VerifyDetail& detail) const {
    const Json header{
        {"report", "umbrage verify 1"},
        {"version", header_.version},
        {"device", header_.device},
        {"driver", header_.driver},
        {"command", header_.command},
        {"fault", header_.fault.empty() ? Json(nullptr) : Json(header_.fault)},
        {"tolerance",
         {{"lateralPixels", header_.tolerance.lateralPixels},
          {"depth", header_.tolerance.depth},
          {"position", header_.tolerance.position},
          {"grazing", header_.tolerance.grazing}}},
        {"maxHard", header_.maxHard},
        {"hardErrors", errors()},
        {"passed", passed()},
    };
    std::vector<Json> totals, sequences, frames, problems;
    for (const VerifySum& sum : techniqueSums()) totals.push_back(rowOf(sum));
    for (const VerifySum& sum : sums()) sequences.push_back(rowOf(sum));
    for (const Entry& entry : entries_) {
        const bool wrong = entry.verdict.hard() + entry.verdict.hardCounts() > 0;
        if (wrong || detail.frames) frames.push_back(rowOf(entry.sequence, entry.verdict));
    }
    for (const Problem& problem : problems_) {
        problems.push_back({{"sequence", problem.sequence}, {"message", problem.message}});
    }
    std::string text = "{";
    for (const auto& [name, value] : header.items()) {
        text += fmt::format("{}\n  \"{}\": {}", text.size() > 1 ? "," : "", name, textOf(value));
    }
    return text + member("totals", totals) + member("sequences", sequences) + member("frames", frames) +
           member("problems", problems) + "\n}\n";
}

std::string VerifyReport::csv() const {
    std::string text = "sequence,frame,technique,light";
    for (const Figure& figure : kFigures) text += fmt::format(",{}", figure.name);
    for (const auto& [name, value] : frameFigures({}, 0.0, 0.0)) text += fmt::format(",{}", name);
    text += "\n";
    for (const Entry& entry : entries_) {
        const FrameVerdict& verdict = entry.verdict;
        std::string frameFields;
        for (const auto& [name, value] :
             frameFigures(verdict.radiance, verdict.renderMilliseconds, verdict.oracleMilliseconds)) {
            frameFields += ',';
            if (!value.is_null()) frameFields += value.dump();
        }
        for (const LightVerdict& light : verdict.lights) {
            text += fmt::format("{},{},{},{}", csvField(entry.sequence), verdict.frame, verdict.technique,
                                csvField(light.light));
            for (const Figure& figure : kFigures) text.append(",").append(figure.of(light).dump());
            text += frameFields + "\n";
        }
    }
    return text;
}

}  // namespace umbrage
