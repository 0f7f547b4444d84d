// SPDX-License-Identifier: Apache-2.0
#include "job/frame_range.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "error.h"

namespace umbrage {
namespace {

constexpr std::size_t kMostFrames = 1'000'000;
constexpr const char* kGrammar = "write A, A-B or A-BxS, several with commas between: 1-48 or 1-99x2,100";

struct Term {
    std::string_view text;
    int first = 0, last = 0, step = 1;  // last is reached exactly

    std::size_t count() const { return static_cast<std::size_t>((static_cast<long long>(last) - first) / step) + 1; }
};

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

class TermParser {
public:
    TermParser(std::string_view term, const std::string& where) : term_(term), rest_(term), where_(where) {}

    Term parse() {
        Term term{.text = term_};
        term.first = term.last = integer();
        if (rest_.empty()) return term;
        if (!take('-')) malformed();
        term.last = integer();
        if (term.last < term.first)
            fail(fmt::format("frame range \"{}\" runs backwards", term_),
                 fmt::format("write {}-{}; frames are rendered in ascending order", term.last, term.first));
        if (!rest_.empty()) {
            if (!take('x')) malformed();
            if (rest_.starts_with('-'))
                fail(fmt::format("the step of \"{}\" is negative", term_), "a step is 1 or more");
            term.step = integer();
            if (term.step == 0) fail(fmt::format("the step of \"{}\" is zero", term_), "a step is 1 or more");
            if (!rest_.empty()) malformed();
        }
        const long long span = static_cast<long long>(term.last) - term.first;
        term.last = static_cast<int>(term.last - span % term.step);
        if (term.count() > kMostFrames) tooMany(where_);
        return term;
    }

    [[noreturn]] static void tooMany(const std::string& where) {
        throw Error(ErrorKind::Input, where, fmt::format("the frame range has more than {} frames", kMostFrames),
                    "split it into several runs");
    }

private:
    [[noreturn]] void fail(const std::string& message, const std::string& hint) const {
        throw Error(ErrorKind::Input, where_, message, hint);
    }
    [[noreturn]] void malformed() const { fail(fmt::format("\"{}\" is not a frame range", term_), kGrammar); }

    bool take(char c) {
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    // Decimal whatever it begins with: 0010 is frame ten.
    int integer() {
        int value = 0;
        const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (status == std::errc::result_out_of_range)
            fail(fmt::format("a frame number in \"{}\" is too large", term_),
                 fmt::format("frames lie between {} and {}", std::numeric_limits<int>::min(),
                             std::numeric_limits<int>::max()));
        if (status != std::errc{}) malformed();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    std::string_view term_, rest_;
    const std::string& where_;
};

std::vector<Term> parseTerms(std::string_view text, const std::string& where) {
    std::vector<Term> terms;
    for (std::string_view rest = text;;) {
        const auto comma = rest.find(',');
        const std::string_view term = trimmed(rest.substr(0, comma));
        if (term.empty())
            throw Error(ErrorKind::Input, where,
                        trimmed(text).empty() ? "the frame range is empty"
                                              : fmt::format("frame range \"{}\" has an empty term", text),
                        kGrammar);
        terms.push_back(TermParser(term, where).parse());
        if (comma == std::string_view::npos) return terms;
        rest.remove_prefix(comma + 1);
    }
}

// The terms of textOf(): frames[begin] to frames[end - 1], an arithmetic progression.
std::string termText(const std::vector<int>& frames, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return std::to_string(frames[begin]);
    const long long step = static_cast<long long>(frames[begin + 1]) - frames[begin];
    return fmt::format("{}-{}{}", frames[begin], frames[end - 1], step == 1 ? "" : fmt::format("x{}", step));
}

}  // namespace

FrameRange FrameRange::single(int frame) {
    FrameRange range;
    range.frames_ = {frame};
    return range;
}

FrameRange FrameRange::parse(std::string_view text, const std::string& where) {
    if (text.find(':') != std::string_view::npos)
        throw Error(ErrorKind::Input, where, fmt::format("frame range \"{}\" has a ':'", text),
                    "tools disagree about it: a stagger in fileseq and OpenCue, between first and last in usdrecord, a "
                    "step in OpenJobDescription and Slurm; write 1-10 for a range and 1-10x2 for every second frame");

    const std::vector<Term> terms = parseTerms(text, where);
    std::vector<std::pair<int, std::size_t>> frameAndTerm;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        if (frameAndTerm.size() + terms[t].count() > kMostFrames) TermParser::tooMany(where);
        for (std::size_t i = 0; i < terms[t].count(); ++i)
            frameAndTerm.emplace_back(static_cast<int>(terms[t].first + static_cast<long long>(i) * terms[t].step), t);
    }
    std::sort(frameAndTerm.begin(), frameAndTerm.end());

    FrameRange range;
    range.frames_.reserve(frameAndTerm.size());
    for (std::size_t i = 0; i < frameAndTerm.size(); ++i) {
        const auto& [frame, term] = frameAndTerm[i];
        if (i > 0 && frame == frameAndTerm[i - 1].first)
            throw Error(ErrorKind::Input, where,
                        fmt::format("\"{}\" and \"{}\" both have frame {}", terms[frameAndTerm[i - 1].second].text,
                                    terms[term].text, frame),
                        "name every frame once");
        range.frames_.push_back(frame);
    }
    return range;
}

std::string FrameRange::text() const {
    return textOf(frames_);
}

// Shortest path over the sorted frames: bestLength[i] is the length of the best text of the first i frames. A term that
// ends at frame i - 1 begins at that frame, or at the start of the longest progression that ends there or up to two
// frames later (two progressions share at most one frame, and a term of two frames never wins). Linear in the frames.
std::string FrameRange::textOf(const std::vector<int>& frames) {
    const std::size_t count = frames.size();
    std::vector<std::size_t> bestLength(count + 1, 0), bestBegin(count + 1, 0);
    std::size_t progressionBegin = 0;
    for (std::size_t end = 1; end <= count; ++end) {
        if (end > 2 && static_cast<long long>(frames[end - 1]) - frames[end - 2] !=
                           static_cast<long long>(frames[end - 2]) - frames[end - 3])
            progressionBegin = end - 2;
        bestLength[end] = std::numeric_limits<std::size_t>::max();
        for (const std::size_t begin : {progressionBegin + 1, progressionBegin, progressionBegin + 2, end - 1}) {
            if (begin >= end) continue;
            const std::size_t length = bestLength[begin] + termText(frames, begin, end).size() + (begin > 0 ? 1 : 0);
            if (length >= bestLength[end]) continue;
            bestLength[end] = length;
            bestBegin[end] = begin;
        }
    }
    std::vector<std::string> terms;
    for (std::size_t end = count; end > 0; end = bestBegin[end]) terms.push_back(termText(frames, bestBegin[end], end));
    std::reverse(terms.begin(), terms.end());
    return fmt::format("{}", fmt::join(terms, ","));
}

}  // namespace umbrage
