// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "diagnostics/median.h"
#include "report/verify_report.h"

namespace umbrage {
namespace {

/// The larger one; what is not a number is larger still.
double worse(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

void addTo(LightVerdict& sum, const LightVerdict& light) {
    for (const auto figure :
         {&LightVerdict::litFacing, &LightVerdict::exactDark, &LightVerdict::hardFalseDark, &LightVerdict::hardFalseLit,
          &LightVerdict::primary, &LightVerdict::grazing, &LightVerdict::boundary, &LightVerdict::bandFalseDark,
          &LightVerdict::bandFalseLit, &LightVerdict::bandPopulation, &LightVerdict::countsJudged,
          &LightVerdict::countErrors, &LightVerdict::hardCountErrors, &LightVerdict::excessToggles}) {
        sum.*figure += light.*figure;
    }
    sum.samplesPerPixel = light.samplesPerPixel;
    sum.boundaryLength += light.boundaryLength;
    sum.largestComponent = std::max(sum.largestComponent, light.largestComponent);
    sum.largestExtent = std::max(sum.largestExtent, light.largestExtent);
    sum.largestCountError = std::max(sum.largestCountError, light.largestCountError);
}

/// Makes rows of verdicts that have the same sequence, technique, frame and light, as far as these are told apart.
class Rows {
public:
    void add(const std::string& sequence, const FrameVerdict& verdict, int frame, const std::string& light,
             bool claimsExact, const std::vector<const LightVerdict*>& lights) {
        const Key key{rankOf(sequences_, sequence), rankOf(techniques_, verdict.technique), frame,
                      rankOf(lights_, light)};
        auto [found, isNew] = rows_.try_emplace(key);
        Row& row = found->second;
        if (isNew) {
            row.sum.sequence = sequence;
            row.sum.technique = verdict.technique;
            row.sum.light = light;
            row.sum.frame = verdict.frame;
        }
        row.sum.claimsExact = row.sum.claimsExact && claimsExact;
        ++row.sum.frames;
        for (const LightVerdict* one : lights) addTo(row.sum.lights, *one);
        RadianceError& radiance = row.sum.radiance;
        radiance.largest = worse(radiance.largest, verdict.radiance.largest);
        radiance.largestCode = std::max(radiance.largestCode, verdict.radiance.largestCode);
        row.squares += verdict.radiance.rms * verdict.radiance.rms;
        row.codeSquares += verdict.radiance.rmsCode * verdict.radiance.rmsCode;
        row.renderMilliseconds.push_back(verdict.renderMilliseconds);
        row.oracleMilliseconds.push_back(verdict.oracleMilliseconds);
    }

    std::vector<VerifySum> take() && {
        std::vector<VerifySum> sums;
        for (auto& [key, row] : rows_) {
            row.sum.radiance.rms = std::sqrt(row.squares / double(row.sum.frames));
            row.sum.radiance.rmsCode = std::sqrt(row.codeSquares / double(row.sum.frames));
            row.sum.medianRenderMilliseconds = median(std::move(row.renderMilliseconds));
            row.sum.medianOracleMilliseconds = median(std::move(row.oracleMilliseconds));
            sums.push_back(std::move(row.sum));
        }
        return sums;
    }

private:
    using Key = std::tuple<std::size_t, std::size_t, int, std::size_t>;
    struct Row {
        VerifySum sum;
        double squares = 0.0, codeSquares = 0.0;
        std::vector<double> renderMilliseconds, oracleMilliseconds;
    };

    /// Names are ordered as they first come.
    static std::size_t rankOf(std::map<std::string, std::size_t>& ranks, const std::string& name) {
        return ranks.try_emplace(name, ranks.size()).first->second;
    }

    std::map<std::string, std::size_t> sequences_, techniques_, lights_;
    std::map<Key, Row> rows_;
};

std::vector<const LightVerdict*> allLights(const FrameVerdict& verdict) {
    std::vector<const LightVerdict*> lights;
    for (const LightVerdict& light : verdict.lights) lights.push_back(&light);
    return lights;
}

}  // namespace

void VerifyReport::add(const std::string& sequence, bool claimsExact, const FrameVerdict& verdict) {
    entries_.push_back({sequence, claimsExact, verdict});
}

void VerifyReport::addProblem(const std::string& sequence, const std::string& message) {
    problems_.push_back({sequence, message});
}

std::vector<VerifySum> VerifyReport::sums(const VerifyDetail& detail) const {
    Rows rows;
    for (const Entry& entry : entries_) {
        const int frame = detail.frames ? entry.verdict.frame : 0;
        if (!detail.lights) {
            rows.add(entry.sequence, entry.verdict, frame, "", entry.claimsExact, allLights(entry.verdict));
            continue;
        }
        for (const LightVerdict& light : entry.verdict.lights) {
            rows.add(entry.sequence, entry.verdict, frame, light.light, entry.claimsExact, {&light});
        }
    }
    return std::move(rows).take();
}

std::vector<VerifySum> VerifyReport::techniqueSums() const {
    Rows rows;
    for (const Entry& entry : entries_) {
        rows.add("", entry.verdict, 0, "", entry.claimsExact, allLights(entry.verdict));
    }
    return std::move(rows).take();
}

std::uint64_t VerifyReport::errors() const {
    std::uint64_t sum = 0;
    for (const Entry& entry : entries_) {
        if (entry.claimsExact) sum += entry.verdict.hard() + entry.verdict.hardCounts();
    }
    return sum;
}

}  // namespace umbrage
