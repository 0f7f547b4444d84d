// SPDX-License-Identifier: Apache-2.0
// What a run of `umbrage verify` found, and its forms: a table for people, Markdown for documents, JSON and CSV for
// programs. The same verdicts give the same bytes; only times differ from run to run.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "judge/tolerance.h"
#include "judge/verdict.h"

namespace umbrage {

/// What the verdicts hang on.
struct VerifyHeader {
    std::string version, device, driver;
    std::string command;  // that makes this report, for documents
    std::string fault;    // planted on purpose; empty: none
    Tolerance tolerance;
    std::uint64_t maxHard = 0;  // errors a technique that claims exactness may have in all
};

/// Verdicts of several frames or lights taken together.
struct VerifySum {
    std::string sequence, technique, light;  // an empty light stands for all
    int frame = 0;                           // of the first verdict
    bool claimsExact = true;
    std::size_t frames = 0;
    LightVerdict lights;     // figures added up, extents the largest
    RadianceError radiance;  // of whole frames, also where the row is one light's
    double medianRenderMilliseconds = 0.0, medianOracleMilliseconds = 0.0;
};

/// Which rows a table has, beside those of sequence and technique.
struct VerifyDetail {
    bool frames = false, lights = false;
    bool summary = false;  // instead, techniques alone, over all sequences
};

class VerifyReport {
public:
    explicit VerifyReport(VerifyHeader header) : header_(std::move(header)) {}

    /// @param sequence  its name, the same for all its verdicts
    /// @param claimsExact  whether hard errors of this technique fail the run
    void add(const std::string& sequence, bool claimsExact, const FrameVerdict& verdict);
    /// A sequence that could not be judged, or not to its end.
    void addProblem(const std::string& sequence, const std::string& message);

    /// One for each sequence and technique in the order of their first verdict; with more detail, one for each frame
    /// or light of these.
    std::vector<VerifySum> sums(const VerifyDetail& detail = {}) const;
    /// One for each technique, over all sequences.
    std::vector<VerifySum> techniqueSums() const;

    /// Hard errors of masks and counts by techniques that claim exactness.
    std::uint64_t errors() const;
    bool anyProblem() const { return !problems_.empty(); }
    bool passed() const { return problems_.empty() && errors() <= header_.maxHard; }

    std::string table(const VerifyDetail& detail) const;
    std::string markdown(const VerifyDetail& detail) const;
    /// Sums, and the frames that have errors; all frames with detail.frames.
    std::string json(const VerifyDetail& detail) const;
    /// Tidy: a line for each sequence, frame, technique and light. Fields are quoted as RFC 4180 has it.
    std::string csv() const;

private:
    struct Entry {
        std::string sequence;
        bool claimsExact;
        FrameVerdict verdict;
    };
    struct Problem {
        std::string sequence, message;
    };

    VerifyHeader header_;
    std::vector<Entry> entries_;
    std::vector<Problem> problems_;
};

}  // namespace umbrage
