// SPDX-License-Identifier: Apache-2.0
// Budgets of the shipped program: exit codes, messages, and what is written all the same.
#include <nlohmann/json.hpp>

#include "../unit/json_schema.h"
#include "workspace.h"

namespace umbrage::cli {
namespace {

using Json = nlohmann::ordered_json;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Budgets : public Workspace {
protected:
    /// The lines of stderr about budgets.
    static std::vector<std::string> linesOf(const Result& result) {
        std::vector<std::string> lines;
        std::istringstream text(result.err);
        for (std::string line; std::getline(text, line);) {
            if (line.starts_with("umbrage: over budget: ")) lines.push_back(line.substr(22));
        }
        return lines;
    }

    Json read(const std::string& file) { return Json::parse(contentsOf(folder() / file)); }

    /// What a frame of a file has.
    static double valueOf(const Json& statistics, std::size_t frame, const std::string& light, const char* counter) {
        return statistics["frames"][frame]["lights"][light]["values"][counter];
    }
};

TEST_F(Budgets, HeldByEveryFrameChangeNothing) {
    writeSequence("statistics: {path: out/n.json, budgets: {overdraw.p95: 1000, edges.silhouette: {min: 1}}}\n");
    const Result result = umbrage({"render", "seq.yaml", "-q"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, IsEmpty());
    const Json budgets = read("out/n.json")["budgets"];
    ASSERT_EQ(budgets.size(), 2u);
    EXPECT_EQ(budgets[0]["exceeded"], false);
    EXPECT_EQ(budgets[0]["max"], 1000);
    EXPECT_EQ(budgets[1]["min"], 1);
}

TEST_F(Budgets, OverAreSaidWithTheWorstFrameWhenAllIsWritten) {
    writeSequence(
        "statistics: {path: out/n.json, budgets: {edges.silhouette: 10, quads: 1e9}}\n"
        "output: {path: \"out/{aov}.{frame:04}.{ext}\"}\n");
    const Result result = umbrage({"render", "seq.yaml", "-q"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(filesIn("out"), ElementsAre("beauty.0001.png", "beauty.0002.png", "beauty.0003.png", "n.json"));
    const Json statistics = read("out/n.json");
    double most = 0.0;
    int worst = 0;
    for (std::size_t f = 0; f < 3; ++f) {
        const double both = valueOf(statistics, f, "Box_BoxLight", "edges.silhouette") +
                            valueOf(statistics, f, "Cage_CageLight", "edges.silhouette");
        if (both > most) most = both, worst = int(f) + 1;
    }
    ASSERT_GT(most, 10.0);
    EXPECT_THAT(linesOf(result),
                ElementsAre(testing::StartsWith("edges.silhouette is " + std::to_string(int(most)) + " in frame " +
                                                std::to_string(worst) + ", " + std::to_string(int(most) - 10) + " (")));
    EXPECT_THAT(result.err, HasSubstr(" %) over the budget of 10\n"));
    EXPECT_EQ(statistics["budgets"][0],
              Json({{"name", "edges.silhouette"}, {"max", 10}, {"value", most}, {"frame", worst}, {"exceeded", true}}));
    EXPECT_EQ(statistics["budgets"][1]["exceeded"], false);
    EXPECT_TRUE(validates(Json::parse(umbrage({"schema", "--statistics"}).out), statistics));
}

TEST_F(Budgets, OfTheCommandLineNeedNoFileAndReplaceTheSequences) {
    writeSequence("statistics: {budgets: {quads: 1}}\noutput: {path: \"out/{aov}.{frame:04}.{ext}\"}\n");
    const Result over =
        umbrage({"render", "seq.yaml", "--frames", "1", "--budget", "triangles=455", "--budget", "overdraw.max=0"});
    EXPECT_EQ(over.exitCode, 1);
    ASSERT_EQ(linesOf(over).size(), 3u) << over.err;
    EXPECT_THAT(linesOf(over)[0], testing::StartsWith("quads is "));
    EXPECT_EQ(linesOf(over)[1], "triangles is 456 in frame 1, 1 (0.2 %) over the budget of 455");
    EXPECT_THAT(
        linesOf(over)[2],
        ContainsRegex("^overdraw.max is ([0-9.]+) fragments/pixel in frame 1, ([0-9.]+) over the budget of 0$"));
    EXPECT_THAT(filesIn("out"), ElementsAre("beauty.0001.png"));
    const Result held = umbrage({"render", "seq.yaml", "--frames", "1", "--budget", "quads={min: 1}"});
    EXPECT_EQ(held.exitCode, 0) << held.err;
}

TEST_F(Budgets, OnWhatIsNotThereAreBroken) {
    writeSequence("shadow: {enabled: false}\n");
    const Result result = umbrage({"render", "seq.yaml", "--frames", "1", "-q", "--budget", "edges.silhouette=1e9"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.err,
              "umbrage: over budget: edges.silhouette has no value in any frame, so nothing says that it is at most "
              "1,000,000,000\n");
}

TEST_F(Budgets, OnTimesAreMeasuredWithTheProfile) {
    writeSequence("diagnostics: {profile: true}\nstatistics: {path: out/n.json}\noutput: {aovs: {}}\n");
    const Result over = umbrage({"render", "seq.yaml", "--frames", "1-2", "--budget", "time.frame.ratio={min: 0.001}",
                                 "--budget", "time.frame=0", "--budget", "memory.peak=1"});
    EXPECT_EQ(over.exitCode, 1);
    ASSERT_EQ(linesOf(over).size(), 2u) << over.err;
    EXPECT_THAT(linesOf(over)[0], ContainsRegex("^time.frame is [0-9.,]+ ms in frame [12], "));
    EXPECT_THAT(linesOf(over)[1], ContainsRegex("^memory.peak is [0-9.,]+ MiB in frame [12], "));
    for (const Json& frame : read("out/n.json")["frames"]) {
        const Json& values = frame["values"];
        EXPECT_GT(values["time.picture"], 0.0);
        EXPECT_GT(values["time.unshadowed"], 0.0);
        EXPECT_DOUBLE_EQ(values["time.frame.ratio"],
                         values["time.picture"].get<double>() / values["time.unshadowed"].get<double>());
    }
    // Nobody asked for it, so nobody paid.
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    EXPECT_FALSE(read("out/n.json")["frames"][0]["values"].contains("time.frame.ratio"));
}

TEST_F(Budgets, OnStencilCountsReadThemAndNameTheLight) {
    writeSequence("statistics: {path: n.json}\noutput: {aovs: {}}\n");
    const Result result = umbrage({"render", "seq.yaml", "--frames", "1", "--budget", "stencil.max=0"});
    EXPECT_EQ(result.exitCode, 1);
    ASSERT_EQ(linesOf(result).size(), 1u) << result.err;
    const Json lights = read("n.json")["frames"][0]["lights"];
    std::string worst;
    double most = 0.0;
    for (const auto& [light, figures] : lights.items()) {
        const double value = figures["distributions"]["stencil"]["max"];
        if (value > most) most = value, worst = light;
    }
    EXPECT_EQ(linesOf(result)[0], "stencil.max is " + std::to_string(int(most)) + " volumes/pixel in frame 1, light " +
                                      worst + ", " + std::to_string(int(most)) + " over the budget of 0");
    EXPECT_THAT(result.err, HasSubstr("counts are asked for, so the skips that change them are off"));
}

TEST_F(Budgets, OnMemoryNeedNoProfile) {
    writeSequence("output: {aovs: {}}\n");
    const Result result = umbrage({"render", "seq.yaml", "-q", "--frames", "1", "--budget", "memory.peak=1"});
    EXPECT_EQ(result.exitCode, 1);
    ASSERT_EQ(linesOf(result).size(), 1u) << result.err;
    EXPECT_THAT(linesOf(result)[0], testing::StartsWith("memory.peak is "));
}

TEST_F(Budgets, OfNonsenseAreRefusedBeforeAnythingIsRendered) {
    writeSequence();
    const auto refused = [&](const std::vector<std::string>& more, int exitCode, const std::string& message) {
        std::vector<std::string> arguments{"render", "seq.yaml", "--budget"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_FALSE(std::filesystem::exists(folder() / "out"));
    };
    refused({"overdraw.p95"}, 2, "\"overdraw.p95\" is not FIGURE=LIMIT, such as overdraw.p95=6");
    refused({"=6"}, 2, "\"=6\" is not FIGURE=LIMIT");
    refused({""}, 2, "is not FIGURE=LIMIT");
    refused({"overdraw.p59=6"}, 3, "--budget: unknown name \"overdraw.p59\" in budgets");
    refused({"overdraw.p96=6"}, 3, "did you mean \"overdraw.p95\"?");
    refused({"overdraw.p95=lots"}, 3, "--budget: overdraw.p95 must be a number of at least 0");
    refused({"time.frame=40"}, 3, "set diagnostics.profile to true");
    writeSequence("statistics:\n  budgets:\n    overdraw.p96: 6\n");
    refused({"quads=1"}, 3, "seq.yaml:7:5: unknown name \"overdraw.p96\" in budgets");
}

TEST_F(Budgets, OfAFileAreJudgedAgainByStats) {
    writeSequence("statistics: {path: a.json, budgets: {triangles: 455, edges.silhouette: 1e6}}\noutput: {aovs: {}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 1);
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "2-3", "--set", "statistics.path=b.json"}).exitCode, 1);

    const Result table = umbrage({"stats", "a.json"});
    EXPECT_EQ(table.exitCode, 1);
    EXPECT_EQ(table.err, "umbrage: over budget: triangles is 456 in frame 1, 1 (0.2 %) over the budget of 455\n");
    EXPECT_THAT(table.out, ContainsRegex("\n  triangles +at most 455 +456 +1  OVER by 1 \\(0.2 %\\)  count\n"));
    EXPECT_THAT(table.out, ContainsRegex("\n  edges.silhouette +at most 1,000,000 +[0-9,]+ +1  held +count\n"));

    const Result both = umbrage({"stats", "a.json", "b.json"});
    EXPECT_EQ(both.exitCode, 1);
    EXPECT_THAT(both.err, HasSubstr("over budget: a.json: triangles is 456 in frame 1"));
    EXPECT_THAT(both.err, HasSubstr("over budget: b.json: triangles is 456 in frame 2"));

    EXPECT_EQ(umbrage({"stats", "a.json", "--budget", "triangles=456"}).exitCode, 0);
    EXPECT_EQ(umbrage({"stats", "a.json", "--budget", "triangles=456", "--budget", "quads=1"}).exitCode, 1);
    EXPECT_EQ(umbrage({"stats", "a.json", "--counter", "quads", "--budget", "triangles=400"}).exitCode, 1)
        << "what is out of sight is judged all the same";

    const Result merged = umbrage({"stats", "a.json", "b.json", "--merge", "all.json", "--budget", "quads={min: 1}"});
    EXPECT_EQ(merged.exitCode, 1);
    EXPECT_EQ(linesOf(merged).size(), 1u);
    EXPECT_EQ(read("all.json")["frames"].size(), 3u);
    EXPECT_EQ(read("all.json")["budgets"].size(), 3u);
    EXPECT_EQ(umbrage({"stats", "all.json", "--budget", "triangles=456"}).exitCode, 0);
}

TEST_F(Budgets, OfStatsThatMakeNoSenseAreRefused) {
    writeSequence("statistics: {path: a.json}\noutput: {aovs: {}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const Result unknown = umbrage({"stats", "a.json", "--budget", "overdraw.p96=6"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean \"overdraw.p95\"?"));
    EXPECT_THAT(unknown.out, IsEmpty());
    EXPECT_EQ(umbrage({"stats", "a.json", "--budget", "quads"}).exitCode, 2);
    const Result unmeasured = umbrage({"stats", "a.json", "--budget", "time.frame=6"});
    EXPECT_EQ(unmeasured.exitCode, 1);
    EXPECT_THAT(unmeasured.err, HasSubstr("time.frame has no value in any frame"));
}

}  // namespace
}  // namespace umbrage::cli
