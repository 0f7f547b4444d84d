// SPDX-License-Identifier: Apache-2.0
// compare and accept as CI uses them: every outcome in every form of the report, exit codes, devices, budgets.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "workspace.h"

namespace umbrage::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Into out/, compared with golden/.
const std::string kGolden = "output: {path: \"out/{aov}.{frame:04}.{ext}\"}\ngolden: {path: golden}\n";

class Compare : public Workspace {
protected:
    /// seq.yaml rendered into out/, and accepted as golden/.
    void SetUp() override {
        Workspace::SetUp();
        writeSequence(kGolden);
        const Result accepted = umbrage({"accept", "seq.yaml", "--yes"});
        ASSERT_EQ(accepted.exitCode, 0) << accepted.err;
    }
    void change(const std::string& name, const std::string& by) const {
        const fs::path file = folder() / "out" / name;
        const fs::path changed = folder() / ("changed" + file.extension().string());
        const std::string command = "oiiotool " + file.string() + " " + by + " -o " + changed.string();
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        fs::rename(changed, file);
    }
    nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(contentsOf(folder() / name)); }
};

TEST_F(Compare, WhatWasAcceptedPassesAndIsNotTouchedAgain) {
    EXPECT_TRUE(fs::exists(folder() / "golden/manifest.json"));
    const auto before = fs::last_write_time(folder() / "golden/beauty.0001.png");
    const Result again = umbrage({"accept", "seq.yaml"});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("3 stay"));
    EXPECT_EQ(fs::last_write_time(folder() / "golden/beauty.0001.png"), before);
    const Result compared = umbrage({"compare", "seq.yaml"});
    EXPECT_EQ(compared.exitCode, 0) << compared.err;
    EXPECT_EQ(compared.out, "3 pass\n");
    EXPECT_THAT(umbrage({"compare", "golden", "out", "--all"}).out, HasSubstr("pass             beauty.0002.png"));
}

TEST_F(Compare, EveryOutcomeIsReportedInEveryForm) {
    writeSequence("output: {path: \"out/{aov}.{frame:04}.{ext}\", aovs: {beauty: png, depth: exr}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1-10", "--out", "out"}).exitCode, 0);
    ASSERT_EQ(umbrage({"accept", "golden", "out", "--yes"}).exitCode, 0);
    change("beauty.0001.png", "--fill:color=1,0,1 4x4+10+10");                  // a corrupted spot
    change("beauty.0002.png", "--addc 0.004");                                  // within the warning
    change("beauty.0003.png", "--resize 65x48");                                // a pixel wider
    change("beauty.0004.png", "--ch R,G");                                      // a channel less
    change("beauty.0005.png", "--ch B,G,R");                                    // swapped channels, expected
    fs::remove(folder() / "out/beauty.0006.png");                               // a missing frame
    fs::remove(folder() / "golden/beauty.0007.png");                            // a missing golden
    fs::copy(folder() / "out/beauty.0008.png", folder() / "out/old.0008.png");  // an extra one
    change("beauty.0009.png", "--fill:color=1,0,1 4x4+10+10");                  // skipped
    writeFile("out/beauty.0010.png", "no picture");
    change("depth.0001.exr", "--fill:color=-1 2x2+3+3 --powc 0.5 -d float");  // roots of -1 are no numbers
    writeFile("rules.yaml", R"(
rules:
  default: {tolerance: 0.01, all: {close: {metric: max-abs, fail: 0.02, warn: 0.001}}}
  "beauty.0005.*": {expectFailure: channels are swapped}
  "beauty.0008.*": {expectFailure: was wrong once}
  "beauty.0009.*": {skip: flickers}
)");
    const Result result =
        umbrage({"compare", "golden", "out", "--rules", "rules.yaml", "--json", "r.json", "--junit", "r.xml", "--csv",
                 "r.csv", "--html", "r.html", "--markdown", "r.md", "--annotations"});
    EXPECT_EQ(result.exitCode, 1) << result.err;
    const std::map<std::string, std::string> wanted{{"beauty.0001.png", "fail"},
                                                    {"beauty.0002.png", "warn"},
                                                    {"beauty.0003.png", "size-mismatch"},
                                                    {"beauty.0004.png", "channel-mismatch"},
                                                    {"beauty.0005.png", "expected-failure"},
                                                    {"beauty.0006.png", "missing-output"},
                                                    {"beauty.0007.png", "missing-golden"},
                                                    {"beauty.0008.png", "unexpected-pass"},
                                                    {"beauty.0009.png", "skipped"},
                                                    {"beauty.0010.png", "unreadable"},
                                                    {"depth.0001.exr", "non-finite"},
                                                    {"old.0008.png", "extra-output"}};
    std::map<std::string, std::string> found;
    const nlohmann::json report = json("r.json");
    for (const auto& image : report["images"]) {
        if (image["outcome"] != "pass") found[image["name"]] = image["outcome"];
    }
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(report["images"].size(), wanted.size() + 9) << "of depth, nine pass";
    const std::string xml = contentsOf(folder() / "r.xml"), csv = contentsOf(folder() / "r.csv"),
                      html = contentsOf(folder() / "r.html"), markdown = contentsOf(folder() / "r.md");
    for (const auto& [name, outcome] : wanted) {
        EXPECT_THAT(csv, HasSubstr(name)) << "csv";
        EXPECT_THAT(csv, HasSubstr(outcome)) << "csv";
        EXPECT_THAT(html, HasSubstr(name)) << "html";
        EXPECT_THAT(xml, HasSubstr(name)) << "junit";
        EXPECT_THAT(result.out, HasSubstr(outcome)) << "text";
        EXPECT_THAT(markdown, HasSubstr(outcome)) << "markdown";
    }
    EXPECT_THAT(xml, HasSubstr("flickers"));
    EXPECT_THAT(result.out, HasSubstr("::error file="));
    EXPECT_THAT(result.out, HasSubstr("::warning file="));
    EXPECT_THAT(html, Not(HasSubstr("src=\"http")));
    EXPECT_TRUE(fs::exists(folder() / "out/beauty.0007.png")) << "the candidate stays";
}

TEST_F(Compare, AShadowsEdgeMovedByAPixelFails) {
    fs::remove_all(folder() / "out");
    writeSequence("output: {path: \"out/{aov}.{frame:04}.{ext}\", aovs: {shadow: exr}}\ngolden: {path: masks}\n");
    ASSERT_EQ(umbrage({"accept", "seq.yaml", "--yes"}).exitCode, 0);
    change("shadow.0002.exr", "--cshift +1+0");
    const Result moved = umbrage({"compare", "masks", "out"});
    EXPECT_EQ(moved.exitCode, 1) << moved.err;
    EXPECT_THAT(moved.out, HasSubstr("fail             shadow.0002.exr: "));
    EXPECT_THAT(moved.out, HasSubstr("1 fail, 2 pass\n"));
}

TEST_F(Compare, AnotherLightIsSeenAndAcceptedOnlyWhenThatIsSaid) {
    writeSequence(kGolden + "lights: [{type: point, name: New, position: [1, 2, 1], intensity: 30}]\n");
    const Result failed = umbrage({"compare", "seq.yaml"});
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.err, HasSubstr("made of another job"));
    const Result unasked = umbrage({"accept", "seq.yaml"});
    EXPECT_EQ(unasked.exitCode, 2);
    EXPECT_THAT(unasked.out, HasSubstr("changed  beauty.0001.png: max-abs"));
    EXPECT_THAT(unasked.err, HasSubstr("--yes"));
    EXPECT_EQ(umbrage({"compare", "seq.yaml"}).exitCode, 1) << "nothing was changed";
    EXPECT_EQ(umbrage({"accept", "seq.yaml", "--yes"}).exitCode, 0);
    EXPECT_EQ(umbrage({"compare", "seq.yaml"}).exitCode, 0);
}

TEST_F(Compare, OnATerminalAcceptAsks) {
    writeSequence(kGolden + "lights: [{type: point, name: New, position: [1, 2, 1], intensity: 30}]\n");
    const auto answered = [&](const char* answer) {
        const std::string command = "cd '" + folder().string() + "' && printf '" + answer + "\\n' | script -qec '" +
                                    UMBRAGE_PROGRAM + " accept seq.yaml' /dev/null > said.txt";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        return contentsOf(folder() / "said.txt");
    };
    EXPECT_THAT(answered("n"), testing::AllOf(HasSubstr("[y/N]"), HasSubstr("nothing was changed")));
    EXPECT_EQ(umbrage({"compare", "seq.yaml"}).exitCode, 1);
    EXPECT_THAT(answered("y"), HasSubstr("is up to date"));
    EXPECT_EQ(umbrage({"compare", "seq.yaml"}).exitCode, 0);
}

TEST_F(Compare, OtherFramesThanTheGoldensAreSkipped) {
    const Result one = umbrage({"compare", "seq.yaml", "--frames", "2", "--out", "other"});
    EXPECT_EQ(one.exitCode, 0) << one.err;
    EXPECT_THAT(one.out, HasSubstr("1 pass"));
    EXPECT_THAT(one.out, HasSubstr("2 skipped"));
}

TEST_F(Compare, AnotherDeviceIsRefusedUnlessAllowed) {
    nlohmann::json manifest = json("golden/manifest.json");
    manifest["device"]["version"] = "another";
    writeFile("golden/manifest.json", manifest.dump());
    const Result refused = umbrage({"compare", "golden", "out"});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_THAT(refused.err, HasSubstr("--other-device"));
    EXPECT_EQ(umbrage({"compare", "golden", "out", "--other-device"}).exitCode, 0);
    const Result kept = umbrage({"accept", "golden", "out", "--yes"});
    EXPECT_EQ(kept.exitCode, 3);
    EXPECT_THAT(kept.err, HasSubstr("--force-device"));
    EXPECT_EQ(umbrage({"accept", "golden", "out", "--yes", "--force-device"}).exitCode, 0);
}

TEST_F(Compare, StatisticsAndBudgetsFailItToo) {
    writeSequence(kGolden + "statistics: {path: out/statistics.json}\n");
    EXPECT_EQ(umbrage({"accept", "seq.yaml", "--yes", "--statistics"}).exitCode, 0);
    EXPECT_EQ(umbrage({"compare", "seq.yaml"}).exitCode, 0) << "what is measured is skipped";
    nlohmann::json statistics = json("golden/statistics.json");
    nlohmann::json& fragments = statistics["frames"][0]["values"]["overdraw.fragments"];
    ASSERT_TRUE(fragments.is_number());
    fragments = fragments.get<double>() + 1.0;
    writeFile("golden/statistics.json", statistics.dump());
    const Result other = umbrage({"compare", "seq.yaml", "--json", "r.json"});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_THAT(other.out, HasSubstr("overdraw.fragments"));
    fs::remove(folder() / "golden/statistics.json");
    const Result over = umbrage({"compare", "seq.yaml", "--budget", "overdraw.max=0.5"});
    EXPECT_EQ(over.exitCode, 1);
    EXPECT_THAT(over.err, HasSubstr("over budget: overdraw.max"));
}

TEST_F(Compare, WhatIsNotThereIsAnErrorWithAWayOn) {
    EXPECT_EQ(umbrage({"compare", "none", "out"}).exitCode, 3);
    EXPECT_THAT(umbrage({"compare", "none", "out"}).err, HasSubstr("umbrage accept makes goldens"));
    EXPECT_EQ(umbrage({"compare", "golden", "out/beauty.0001.png"}).exitCode, 2);
    EXPECT_EQ(umbrage({"compare", "golden/beauty.0001.png", "out/beauty.0001.png"}).exitCode, 0);
    writeSequence();
    const Result unnamed = umbrage({"compare", "seq.yaml"});
    EXPECT_EQ(unnamed.exitCode, 2);
    EXPECT_THAT(unnamed.err, HasSubstr("golden: {path: FOLDER}"));
    EXPECT_EQ(umbrage({"compare"}).exitCode, 2);
    EXPECT_EQ(umbrage({"compare", "golden", "out", "--rules", "seq.yaml"}).exitCode, 3);
}

}  // namespace
}  // namespace umbrage::cli
