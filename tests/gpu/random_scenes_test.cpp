// SPDX-License-Identifier: Apache-2.0
// Random scenes that a mistake of ours got wrong once, by every technique: `umbrage verify --random 1 --seed S`.
#include "subjects.h"

namespace umbrage::test {
namespace {

class Judged : public VerifyObserver {
public:
    void note(const std::string&) override {}
    void started(std::size_t) override {}
    void judged(const FrameVerdict& verdict, const VerdictPlanes&, const std::vector<float>&) override {
        ++verdicts;
        for (const LightVerdict& light : verdict.lights) litFacing += light.litFacing;
        const std::string count = Technique::named(verdict.technique).count;
        const auto* row = std::find_if(kCounts.begin(), kCounts.end(), [&](const auto& c) { return c.name == count; });
        if (row->exact != Exact::Never) {
            EXPECT_EQ(verdict.hard(), 0u) << verdict.technique;
        }
    }
    std::size_t verdicts = 0;
    std::uint64_t litFacing = 0;
};

class OnceWrong : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, OnceWrong,
                         testing::Values(1226, 1629, 1844, 2017, 2030, 2087, 2089, 2168, 2233, 2300, 2446, 2491, 2498,
                                         50111, 50128, 50469, 50931, 50954, 60755, 60979, 72681, 100284, 101287, 102022,
                                         200010, 210400, 301216, 1000470, 1002660, 1005205, 2001810, 4000495, 4008314,
                                         12000909, 12001443, 12001646, 12001831, 12002556, 12002671, 30001016, 30008401,
                                         30008694));

TEST_P(OnceWrong, IsRight) {
    VerifyOptions options;
    options.techniques = allTechniques();
    Judged judged;
    const std::atomic<bool> interrupted{false};
    const auto display = codec().displayTransform({"", "sRGB", "ACES SDR", 0.0});
    verifyRandom(GetParam(), 1, context(), *display, options, judged, interrupted);
    EXPECT_EQ(judged.verdicts, options.techniques.size());
    EXPECT_GT(judged.litFacing, 0u);
}

}  // namespace
}  // namespace umbrage::test
