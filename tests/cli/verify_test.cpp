// SPDX-License-Identifier: Apache-2.0
// umbrage verify: what it says and writes, and how it ends.
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::json;

class Verify : public Workspace {
protected:
    void expectUsageError(const std::vector<std::string>& arguments, const std::string& message) const {
        SCOPED_TRACE(message);
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, HasSubstr(message));
    }

    /// The eye is inside shadow volumes: the textbook's z-pass is wrong there.
    void writeNested(const std::string& more = "") const {
        writeFile("nested.yaml", "umbrage: 1\nscene: [{gltf: \"" + sceneFile("nested") +
                                     "\"}]\ntime: {frames: 1-2}\nimage: {size: [64, 48]}\n" + more);
    }

    Json json(const std::string& name) const { return Json::parse(contentsOf(folder() / name)); }
};

TEST_F(Verify, RefusesWhatItDoesNotKnow) {
    writeSequence();
    expectUsageError({"verify"}, "a sequence, a scene or --random N is required");
    expectUsageError({"verify", "seq.yaml", "--random", "2"}, "excludes --random");
    expectUsageError({"verify", "--seed", "4"}, "--seed requires --random");
    expectUsageError({"verify", "--random", "0"}, "--random");
    expectUsageError({"verify", "seq.yaml", "--techniques", "z-pass"},
                     "--techniques: there is no technique \"z-pass\"");
    expectUsageError({"verify", "seq.yaml", "--others-every", "0"}, "--others-every");
    expectUsageError({"verify", "seq.yaml", "--max-hard", "-1"}, "--max-hard");
    expectUsageError({"verify", "seq.yaml", "--pictures", "some"}, "--pictures: some not in {all,failed,none}");
    expectUsageError({"verify", "seq.yaml", "--fault", "typo"}, "--fault: typo not in {no-eye-constant,");
    expectUsageError({"verify", "seq.yaml", "--size", "64"}, "--size: \"64\" is not WIDTHxHEIGHT");
    expectUsageError({"verify", "seq.yaml", "--per-fram"}, "did you mean \"--per-frame\"?");
    EXPECT_THAT(umbrage({"verify", "--help"}).out, HasSubstr("one silhouette edge in 64 is lost"));
}

TEST_F(Verify, JudgesRandomScenesByAllTechniquesAndNamesTheSeedOfAWrongOne) {
    const Result right = umbrage({"verify", "--random", "6", "--seed", "10", "--csv", "made/numbers.csv"});
    EXPECT_EQ(right.exitCode, 0) << right.err;
    EXPECT_THAT(right.out, HasSubstr("cpu:z-fail"));
    EXPECT_THAT(right.out, HasSubstr("0 hard errors"));
    const Result wrong =
        umbrage({"verify", "--random", "6", "--seed", "10", "--fault", "wrong-facing", "--pictures", "none"});
    EXPECT_EQ(wrong.exitCode, 1);
    EXPECT_THAT(wrong.err, HasSubstr("again: umbrage verify --random 1 --seed "));
}

TEST_F(Verify, JudgesEveryFrameByEveryTechnique) {
    writeSequence();
    const Result result = umbrage({"verify", "seq.yaml", "--techniques", "all", "--json", "made/numbers.json", "--csv",
                                   "made/numbers.csv", "--markdown", "made/page.md", "--per-frame"});
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("\n0 hard errors in "));
    EXPECT_THAT(filesIn("."), testing::ElementsAre("made/numbers.csv", "made/numbers.json", "made/page.md", "seq.yaml"))
        << "whole files, and no pictures where nothing is wrong";

    const Json report = json("made/numbers.json");
    EXPECT_EQ(report["passed"], true);
    EXPECT_EQ(report["fault"], nullptr);
    EXPECT_THAT(report["device"].get<std::string>(), Not(IsEmpty()));
    EXPECT_EQ(report["command"].get<std::string>().rfind("umbrage verify seq.yaml --techniques all", 0), 0u);
    const std::size_t techniques = report["sequences"].size(), verdicts = 3 * techniques;
    EXPECT_GE(techniques, 12u);
    EXPECT_EQ(report["frames"].size(), verdicts);
    EXPECT_THAT(result.err, HasSubstr("seq frame 3, cpu:z-fail: 0 hard ("));
    EXPECT_THAT(result.err,
                HasSubstr(": 0 hard (" + std::to_string(verdicts) + " of " + std::to_string(verdicts) + ")\n"));
    EXPECT_EQ(report["frames"][0]["lights"].size(), 2u);
    EXPECT_GT(report["totals"][0]["exactDark"], 100);
    EXPECT_LT(report["totals"][0]["exactDark"], report["totals"][0]["litFacing"]);

    const std::string csv = contentsOf(folder() / "made/numbers.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), std::ptrdiff_t(1 + verdicts * 2));
    const std::string page = contentsOf(folder() / "made/page.md");
    EXPECT_THAT(page, HasSubstr("\n    umbrage verify seq.yaml --techniques all --json"));
    EXPECT_THAT(page, HasSubstr("| seq | compute:z-pass | 1 |"));
}

TEST_F(Verify, WithoutTechniquesJudgesTheSequencesOwn) {
    writeSequence("shadow: {count: z-fail, silhouette: cpu}\n");
    EXPECT_THAT(umbrage({"verify", "seq.yaml", "--frames", "1"}).out, HasSubstr("\nseq       cpu:z-fail "));
    writeSequence();
    // What is fastest on the device.
    EXPECT_THAT(umbrage({"verify", "seq.yaml", "--frames", "1"}).out,
                testing::AnyOf(HasSubstr("\nseq       compute:z-pass "), HasSubstr("\nseq       cpu:tiles ")));
}

TEST_F(Verify, OtherTechniquesCanJudgeFewerFrames) {
    writeSequence();
    const Result result = umbrage({"verify", "seq.yaml", "--frames", "1-5", "--techniques", "cpu:z-pass,cpu:z-fail",
                                   "--others-every", "2", "--json", "numbers.json"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr("(8 of 8)"));
    EXPECT_EQ(json("numbers.json")["sequences"][0]["frames"], 5);
    EXPECT_EQ(json("numbers.json")["sequences"][1]["frames"], 3);
}

TEST_F(Verify, OnlyTimesDifferFromRunToRun) {
    writeSequence();
    Json first, second;
    for (Json* report : {&first, &second}) {
        ASSERT_EQ(umbrage({"verify", "seq.yaml", "--per-frame", "--json", "numbers.json"}).exitCode, 0);
        *report = json("numbers.json");
        for (const char* list : {"totals", "sequences", "frames"}) {
            for (Json& row : (*report)[list]) {
                EXPECT_EQ(row.erase("renderMilliseconds") + row.erase("oracleMilliseconds"), 2u);
            }
        }
    }
    EXPECT_EQ(first, second);
}

TEST_F(Verify, CountsAreJudgedWhereAskedTo) {
    writeSequence();
    umbrage({"verify", "seq.yaml", "--frames", "1", "--json", "without.json"});
    umbrage({"verify", "seq.yaml", "--frames", "1", "--counts", "--json", "with.json"});
    EXPECT_EQ(json("without.json")["totals"][0]["countsJudged"], 0);
    EXPECT_GE(json("with.json")["totals"][0]["countsJudged"], json("with.json")["totals"][0]["litFacing"]);
}

TEST_F(Verify, ShowsWhereTheTextbookFailsAndWhoClaimsNothingFailsNothing) {
    writeNested("shadow: {eyeConstant: false}\n");
    const Result result = umbrage({"verify", "nested.yaml", "--techniques", "compute:z-pass,compute:z-fail", "--json",
                                   "numbers.json", "--out", "wrong"});
    EXPECT_EQ(result.exitCode, 0) << result.out;
    EXPECT_THAT(result.out, HasSubstr("by compute:z-pass (claims no exactness)\n"));
    EXPECT_THAT(filesIn("wrong"),
                testing::ElementsAre("nested/compute-z-pass.0001.png", "nested/compute-z-pass.0002.png"));
    EXPECT_THAT(result.err, HasSubstr("picture: wrong/nested/compute-z-pass.0001.png\n"));
    EXPECT_GT(valuesOf(folder() / "wrong/nested/compute-z-pass.0001.png").size(), 3u * 64u * 48u);
    const Json report = json("numbers.json");
    EXPECT_EQ(report["sequences"][0]["claimsExact"], false);
    EXPECT_GT(report["sequences"][0]["hard"], 500);
    EXPECT_EQ(report["sequences"][1]["claimsExact"], true);
    EXPECT_EQ(report["sequences"][1]["hard"], 0);
    EXPECT_EQ(report["frames"].size(), 2u);
}

TEST_F(Verify, APlantedFaultFailsTheRunUnlessItsErrorsAreAllowed) {
    writeNested();
    const std::vector<std::string> arguments{"verify", "nested.yaml", "--fault", "no-eye-constant", "--json", "n.json"};
    const Result result = umbrage(arguments);
    EXPECT_EQ(result.exitCode, 1) << result.out;
    EXPECT_THAT(result.out, HasSubstr("; with the fault no-eye-constant\n"));
    EXPECT_EQ(json("n.json")["fault"], "no-eye-constant");
    const auto errors = json("n.json")["hardErrors"].get<int>();
    EXPECT_GT(errors, 500);
    const auto allowing = [&](int most) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"--max-hard", std::to_string(most)});
        return umbrage(all).exitCode;
    };
    EXPECT_EQ(allowing(errors), 0);
    EXPECT_EQ(allowing(errors - 1), 1);
}

TEST_F(Verify, PicturesAreOfTheFramesThatAreWantedAndNeverOld) {
    writeNested();
    const std::vector<std::string> wrong{"verify", "nested.yaml", "--set", "shadow.eyeConstant=false"};
    const std::vector<std::string> right{"verify", "nested.yaml"};
    const auto with = [&](std::vector<std::string> arguments, const char* pictures) {
        arguments.insert(arguments.end(), {"--pictures", pictures});
        umbrage(arguments);
        return filesIn("out/verify/nested").size();
    };
    EXPECT_EQ(with(wrong, "none"), 0u);
    EXPECT_EQ(with(wrong, "failed"), 2u);
    EXPECT_EQ(with(right, "failed"), 0u) << "what is right now has no picture of when it was wrong";
    EXPECT_EQ(with(right, "all"), 2u);
}

TEST_F(Verify, ASequenceThatCannotBeReadKeepsNoneOfTheOthersFromBeingJudged) {
    writeSequence();
    writeFile("typo.yaml", "umbrage: 1\nscene: [{gltf: \"" + sceneFile("lantern") + "\"}]\nimge: {size: [64, 48]}\n");
    writeFile("noscene.yaml", "umbrage: 1\nscene: [{gltf: nowhere.glb}]\n");
    const Result result =
        umbrage({"verify", "nowhere.yaml", "typo.yaml", "noscene.yaml", "seq.yaml", "--json", "numbers.json"});
    EXPECT_EQ(result.exitCode, 3);
    for (const char* message :
         {"nowhere.yaml: there is no such file", "typo.yaml:3:1: ", "did you mean \"image\"?", "nowhere.glb"}) {
        EXPECT_THAT(result.err, HasSubstr(message));
    }
    EXPECT_THAT(result.out, HasSubstr("not judged: typo: typo.yaml:3:1: "));
    const Json report = json("numbers.json");
    EXPECT_EQ(report["passed"], false);
    EXPECT_EQ(report["problems"].size(), 3u);
    ASSERT_EQ(report["sequences"].size(), 1u);
    EXPECT_EQ(report["sequences"][0]["frames"], 3);
}

TEST_F(Verify, TakesBareScenesAndTellsEqualNamesApart) {
    writeSequence();
    std::filesystem::create_directory(folder() / "other");
    std::filesystem::copy_file(folder() / "seq.yaml", folder() / "other/seq.yaml");
    const Result result = umbrage({"verify", "seq.yaml", "other/seq.yaml", sceneFile("lantern"), "--size", "32x24",
                                   "--frames", "1", "--json", "numbers.json"});
    EXPECT_EQ(result.exitCode, 0) << result.out;
    const Json rows = json("numbers.json")["sequences"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["sequence"], "seq");
    EXPECT_EQ(rows[1]["sequence"], "seq-2");
    EXPECT_EQ(rows[2]["sequence"], "lantern");
}

TEST_F(Verify, ItsReportsNameAllSequencesOfAFolderTheShortWay) {
    std::filesystem::create_directory(folder() / "my cases");
    writeSequence();
    for (const char* name : {"A1.yaml", "A2.yaml"}) {
        std::filesystem::copy_file(folder() / "seq.yaml", folder() / "my cases" / name);
    }
    umbrage({"verify", "my cases/A1.yaml", "my cases/A2.yaml", "--frames", "1", "--json", "numbers.json"});
    EXPECT_EQ(json("numbers.json")["command"], "umbrage verify 'my cases/'*.yaml --frames 1 --json numbers.json");
    umbrage({"verify", "my cases/A1.yaml", "--frames", "1", "--json", "numbers.json"});
    EXPECT_EQ(json("numbers.json")["command"], "umbrage verify 'my cases/A1.yaml' --frames 1 --json numbers.json");
}

TEST_F(Verify, InterruptingKeepsWhatWasJudged) {
    writeSequence();
    const Result result = umbrage(
        Launch{.signal = [](const std::string& err) { return err.find("(3 of 400)") != err.npos ? SIGINT : 0; }},
        {"verify", "seq.yaml", "--frames", "1-400", "--json", "numbers.json"});
    EXPECT_EQ(result.exitCode, 130);
    EXPECT_THAT(result.out, HasSubstr("not judged: the rest: interrupted\n"));
    const Json report = json("numbers.json");
    EXPECT_EQ(report["passed"], false);
    EXPECT_GE(report["sequences"][0]["frames"], 3);
    EXPECT_LT(report["sequences"][0]["frames"], 400);
}

TEST_F(Verify, NoDeviceAndNoRoomHaveTheirOwnExitCodes) {
    writeSequence();
    EXPECT_EQ(umbrage({"verify", "seq.yaml", "--device", "99"}).exitCode, 4);
    writeFile("file", "");
    const Result result = umbrage({"verify", "seq.yaml", "--frames", "1", "--json", "file/numbers.json"});
    EXPECT_EQ(result.exitCode, 5);
    EXPECT_THAT(result.out, HasSubstr("\n0 hard errors in ")) << "what was judged is still said";
    EXPECT_EQ(umbrage(Launch{.standardOutput = "/dev/full"}, {"verify", "seq.yaml", "--frames", "1"}).exitCode, 5);
}

TEST_F(Verify, QuietSaysNothingButTheTable) {
    writeSequence();
    const Result result = umbrage({"-q", "verify", "seq.yaml", "--frames", "1"});
    EXPECT_THAT(result.err, IsEmpty());
    EXPECT_THAT(result.out, testing::StartsWith("sequence"));
}

TEST_F(Verify, ProgressIsABarOnATerminal) {
    writeSequence();
    const Result result = umbrage(Launch{.terminal = true}, {"verify", "seq.yaml"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr("seq [..............................] 0/3"));
    EXPECT_THAT(result.err, HasSubstr("seq [##############################] 3/3"));
}

}  // namespace
}  // namespace umbrage::cli
