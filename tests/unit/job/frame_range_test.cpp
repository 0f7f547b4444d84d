// SPDX-License-Identifier: Apache-2.0
#include "job/frame_range.h"

#include <numeric>
#include <random>
#include <set>

#include "expect_error.h"

namespace umbrage {
namespace {

using Frames = std::vector<int>;

Frames framesOf(const std::string& text) {
    return FrameRange::parse(text, "--frames").frames();
}

void expectRefusedRange(const std::string& text, const std::string& message, const std::string& hint = "") {
    SCOPED_TRACE(text);
    expectError([&] { framesOf(text); }, {"--frames", message, hint});
}

TEST(FrameRange, ReadsFramesRangesStepsAndLists) {
    EXPECT_EQ(framesOf("7"), (Frames{7}));
    EXPECT_EQ(framesOf("1-4"), (Frames{1, 2, 3, 4}));
    EXPECT_EQ(framesOf("1-10x4"), (Frames{1, 5, 9}));
    EXPECT_EQ(framesOf("1-9x4"), (Frames{1, 5, 9}));
    EXPECT_EQ(framesOf("5-5"), (Frames{5}));
    EXPECT_EQ(framesOf("30-31, 1-3 ,20"), (Frames{1, 2, 3, 20, 30, 31}));
}

TEST(FrameRange, NumbersMayBeNegative) {
    EXPECT_EQ(framesOf("-2"), (Frames{-2}));
    EXPECT_EQ(framesOf("-2-1"), (Frames{-2, -1, 0, 1}));
    EXPECT_EQ(framesOf("-5--3"), (Frames{-5, -4, -3}));
    EXPECT_EQ(framesOf("-5--1x2"), (Frames{-5, -3, -1}));
}

TEST(FrameRange, LeadingZerosAreDecimal) {
    EXPECT_EQ(framesOf("0008-0010"), (Frames{8, 9, 10}));
    EXPECT_EQ(framesOf("0019"), (Frames{19}));
    EXPECT_EQ(framesOf("-007"), (Frames{-7}));
}

TEST(FrameRange, TermsThatInterleaveWithoutACommonFrameAreNoOverlap) {
    EXPECT_EQ(framesOf("1-5x2,2-6x2"), (Frames{1, 2, 3, 4, 5, 6}));
}

TEST(FrameRange, OverlapsNameBothTermsAndTheFrame) {
    expectRefusedRange("1-10,20,5-15", "\"1-10\" and \"5-15\" both have frame 5");
    expectRefusedRange("3,3", "\"3\" and \"3\" both have frame 3");
    expectRefusedRange("1-9x2,2-20x7", "\"1-9x2\" and \"2-20x7\" both have frame 9");
}

TEST(FrameRange, RefusesColonsAndSaysWhy) {
    for (const char* text : {"1:10", "1-10:2", ":", "1-3,5:7"}) {
        expectRefusedRange(text, "has a ':'", "stagger in fileseq and OpenCue");
        expectRefusedRange(text, "has a ':'", "between first and last in usdrecord");
        expectRefusedRange(text, "has a ':'", "step in OpenJobDescription and Slurm");
        expectRefusedRange(text, "has a ':'", "1-10x2");
    }
}

TEST(FrameRange, RefusesWhatIsNoRange) {
    for (const char* text : {"a", "1-", "-", "--1", "1--", "1..5", "1-5y2", "1x2", "1-5x", "1-5x2x2", "+3", "1.5",
                             "1 2", "1 -5", "####", "0x10", "1-5x2-3", "1e3"})
        expectRefusedRange(text, "is not a frame range", "A-BxS");
    expectRefusedRange("", "is empty", "A-BxS");
    expectRefusedRange("  ", "is empty");
    expectRefusedRange("1,,2", "has an empty term");
    expectRefusedRange("1,", "has an empty term");
}

TEST(FrameRange, RefusesReversedRangesAndStepsBelowOne) {
    expectRefusedRange("10-1", "\"10-1\" runs backwards", "write 1-10");
    expectRefusedRange("-1--5", "runs backwards", "write -5--1");
    expectRefusedRange("1-5x0", "zero", "1 or more");
    expectRefusedRange("1-5x-1", "negative", "1 or more");
}

TEST(FrameRange, EndsAtAMillionFramesAndAtTheLimitsOfInt) {
    EXPECT_EQ(framesOf("1-1000000").size(), 1'000'000u);
    expectRefusedRange("0-1000000", "more than 1000000 frames");
    expectRefusedRange("1-600000,600001-1200000", "more than 1000000 frames");
    expectRefusedRange("-2147483648-2147483647", "more than 1000000 frames");
    EXPECT_EQ(framesOf("-2147483648-2147483647x2147483647"), (Frames{-2147483647 - 1, -1, 2147483646}));
    expectRefusedRange("99999999999", "too large");
    expectRefusedRange("1-5x99999999999", "too large");
}

TEST(FrameRange, SingleIsOneFrame) {
    EXPECT_EQ(FrameRange::single(-3).frames(), (Frames{-3}));
    EXPECT_EQ(FrameRange::single(-3).text(), "-3");
}

TEST(FrameRange, TextIsShort) {
    EXPECT_EQ(FrameRange::textOf({}), "");
    EXPECT_EQ(FrameRange::textOf({1}), "1");
    EXPECT_EQ(FrameRange::textOf({1, 2}), "1,2");
    EXPECT_EQ(FrameRange::textOf({1, 2, 3}), "1-3");
    EXPECT_EQ(FrameRange::textOf({1, 3, 5}), "1-5x2");
    EXPECT_EQ(FrameRange::textOf({1, 3, 5, 7}), "1-7x2");
    EXPECT_EQ(FrameRange::textOf({-5, -4, -3, 10}), "-5--3,10");
    EXPECT_EQ(FrameRange::textOf({1, 2, 3, 4, 5, 7, 9, 11, 13}), "1-5,7-13x2");
    EXPECT_EQ(FrameRange::textOf({100, 200, 201, 202, 203}), "100,200-203");
}

Frames randomFrames(std::mt19937& random, int count, int most) {
    std::set<int> frames;
    while (frames.size() < static_cast<std::size_t>(count)) {
        const int first = static_cast<int>(random() % static_cast<unsigned>(2 * most)) - most;
        const int step = 1 + static_cast<int>(random() % 3u);
        for (int i = 0, length = 1 + static_cast<int>(random() % 6u); i < length; ++i) frames.insert(first + i * step);
    }
    return {frames.begin(), frames.end()};
}

TEST(FrameRange, TextReadsBackAsTheSameFrames) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        const Frames frames = randomFrames(random, 1 + round % 60, 10 + round);
        const std::string text = FrameRange::textOf(frames);
        ASSERT_EQ(framesOf(text), frames) << text;
    }
}

// Every way to cut the frames into terms in order.
std::size_t shortestLength(const Frames& frames, std::size_t begin, std::vector<std::size_t>& known) {
    if (begin == frames.size()) return 0;
    if (known[begin] != 0) return known[begin];
    std::size_t best = std::string::npos;
    for (std::size_t end = begin + 1; end <= frames.size(); ++end) {
        const int step = end - begin > 1 ? frames[begin + 1] - frames[begin] : 1;
        if (end - begin > 1 && frames[end - 1] - frames[end - 2] != step) break;
        std::string term = std::to_string(frames[begin]);
        if (end - begin > 1) term.append("-").append(std::to_string(frames[end - 1]));
        if (step > 1) term.append("x").append(std::to_string(step));
        const std::size_t rest = shortestLength(frames, end, known);
        best = std::min(best, term.size() + (rest > 0 ? 1 + rest : 0));
    }
    return known[begin] = best;
}

TEST(FrameRange, NoTextOfTermsInOrderIsShorter) {
    std::mt19937 random(2);
    for (int round = 0; round < 2000; ++round) {
        const Frames frames = randomFrames(random, 1 + round % 15, 5 + round % 120);
        std::vector<std::size_t> known(frames.size(), 0);
        ASSERT_EQ(FrameRange::textOf(frames).size(), shortestLength(frames, 0, known)) << FrameRange::textOf(frames);
    }
}

TEST(FrameRange, TextOfAMillionFramesIsFound) {
    Frames frames(1'000'000);
    std::iota(frames.begin(), frames.end(), -500'000);
    EXPECT_EQ(FrameRange::textOf(frames), "-500000-499999");
}

}  // namespace
}  // namespace umbrage
