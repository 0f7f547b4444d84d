// SPDX-License-Identifier: Apache-2.0
// umbrage stats, and the files it works on.
#include <nlohmann/json.hpp>

#include "../unit/json_schema.h"
#include "workspace.h"

namespace umbrage::cli {
namespace {

using Json = nlohmann::ordered_json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Stats : public Workspace {
protected:
    /// Statistics of some frames of the lantern, profiled.
    void render(const std::string& frames, const std::string& file, const std::vector<std::string>& more = {}) {
        writeSequence("diagnostics: {profile: true}\noutput: {aovs: {}}\n");
        std::vector<std::string> arguments{"render", "seq.yaml", "--frames",
                                           frames,   "--set",    "statistics.path=" + file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = umbrage(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.err;
    }

    Json read(const std::string& file) { return Json::parse(contentsOf(folder() / file)); }

    void expectRefused(const std::vector<std::string>& arguments, int exitCode, const std::string& message) {
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, HasSubstr(message));
    }
};

TEST_F(Stats, PrintsGroupsAndLights) {
    render("1-2", "a.json");
    const Result result = umbrage({"stats", "a.json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, IsEmpty());
    EXPECT_THAT(result.out, StartsWith("sequence: seq.yaml; version: "));
    EXPECT_THAT(result.out, ContainsRegex("frames: 1,2\n"));
    EXPECT_THAT(result.out, ContainsRegex("\ncasters +total +mean"));
    EXPECT_THAT(result.out, ContainsRegex("\n  triangles +456 +456 +1  count\n"));
    EXPECT_THAT(result.out, ContainsRegex("\nlight Box_BoxLight +total"));
    EXPECT_THAT(result.out, ContainsRegex("\n  time.frame "));
}

TEST_F(Stats, FiltersFramesLightsAndCounters) {
    render("1-3", "a.json");
    const Result result = umbrage(
        {"stats", "a.json", "--frames", "2-3", "--light", "Cage*", "--counter", "edges.*", "--csv", "some.csv"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const std::string csv = contentsOf(folder() / "some.csv");
    EXPECT_THAT(csv,
                StartsWith("frame,light,caster,material,counter,unit,value\n2,Cage_CageLight,,,edges.silhouette,"));
    EXPECT_THAT(csv, Not(HasSubstr("\n1,")));
    EXPECT_THAT(csv, Not(HasSubstr("Box_BoxLight")));
    EXPECT_THAT(csv, Not(HasSubstr("quads")));
    const Result table = umbrage({"stats", "a.json", "--counter", "quads"});
    EXPECT_THAT(table.out, HasSubstr("quads"));
    EXPECT_THAT(table.out, Not(HasSubstr("triangles")));
}

TEST_F(Stats, MergesShards) {
    render("1-2", "a.json");
    render("3", "b.json");
    const Result result = umbrage({"stats", "b.json", "a.json", "--merge", "all.json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Json merged = read("all.json"), a = read("a.json"), b = read("b.json");
    ASSERT_EQ(merged["frames"].size(), 3u);
    EXPECT_EQ(merged["frames"][0], a["frames"][0]);
    EXPECT_EQ(merged["frames"][1], a["frames"][1]);
    EXPECT_EQ(merged["frames"][2], b["frames"][0]);
    EXPECT_EQ(merged["summary"]["frames"], 3);
    const Json alike = {a["summary"]["values"]["edges.silhouette"]["total"],
                        b["summary"]["values"]["edges.silhouette"]["total"]};
    EXPECT_EQ(merged["summary"]["values"]["edges.silhouette"]["total"],
              alike[0].get<double>() + alike[1].get<double>());

    Json other = a;
    other["frames"][0]["values"]["triangles"] = 7;
    writeFile("other.json", other.dump());
    expectRefused({"stats", "a.json", "other.json", "--merge", "no.json"}, 3,
                  "other.json: has another triangles for frame 1 than the files before");
    EXPECT_FALSE(std::filesystem::exists(folder() / "no.json"));
}

TEST_F(Stats, ComparesCountsExactlyAndEndsWell) {
    render("1-2", "a.json");
    render("1-2", "b.json");
    const Result same = umbrage({"stats", "a.json", "--compare", "b.json", "--counter", "overdraw.*"});
    EXPECT_EQ(same.exitCode, 0) << same.err;
    EXPECT_THAT(same.out, ContainsRegex("overdraw.fragments +[0-9,]+ +[0-9,]+ +0 +1\\.000 +count\n"));
    EXPECT_THAT(same.out, HasSubstr("2 of 2 and 2 frames are in both."));
    EXPECT_THAT(same.out, HasSubstr(" 0 changed"));

    render("1-2", "larger.json", {"--size", "128x96"});
    const Result changed = umbrage({"stats", "a.json", "--compare", "larger.json", "--counter", "overdraw.fragments"});
    EXPECT_EQ(changed.exitCode, 0);
    EXPECT_THAT(changed.out,
                ContainsRegex("\n +overdraw.fragments +[0-9,]+ +[0-9,]+ +[0-9,]+ +[34]\\.[0-9]+ +\\*  count\n"));
    EXPECT_THAT(changed.out, ContainsRegex("\nBox_BoxLight +overdraw.fragments "));
}

TEST_F(Stats, JudgesByTolerances) {
    render("1-2", "a.json");
    render("1-2", "b.json");
    Json other = read("b.json");
    Json& triangles = other["frames"][1]["values"]["triangles"];
    ASSERT_EQ(triangles, 456);
    triangles = 460;
    writeFile("b.json", other.dump());
    const Result within = umbrage({"stats", "a.json", "--compare", "b.json", "--tolerance", "triangles=0.01"});
    EXPECT_EQ(within.exitCode, 0) << within.out;
    EXPECT_THAT(within.out, ContainsRegex("^[0-9]+ pass, [0-9]+ skipped\n$"));
    const Result over = umbrage({"stats", "a.json", "--compare", "b.json", "--tolerance", "triangles=0.008"});
    EXPECT_EQ(over.exitCode, 1);
    EXPECT_THAT(over.out, ContainsRegex("\ntriangles +2 +456 +460 +fail +0.877 % off, 0.8 % is allowed\n"));
    EXPECT_EQ(umbrage({"stats", "a.json", "--compare", "b.json", "--tolerance", "edges=0"}).exitCode, 1)
        << "other counts must be equal";
    EXPECT_EQ(umbrage({"stats", "a.json", "--compare", "b.json", "--tolerance", "tri*=skip"}).exitCode, 0);
    expectRefused({"stats", "a.json", "--tolerance", "triangles=0"}, 2, "--compare");
    expectRefused({"stats", "a.json", "--compare", "b.json", "--tolerance", "triangles"}, 2, "is not GLOB=SHARE");
    expectRefused({"stats", "a.json", "--compare", "b.json", "--tolerance", "triangles=-1"}, 2,
                  "\"-1\" is no share of at least 0");
    expectRefused({"stats", "a.json", "--compare", "b.json", "--tolerance", "triangles=few"}, 2, "or skip");
}

TEST_F(Stats, PlotsAsSvgAndPng) {
    render("1-3", "a.json");
    const Result result = umbrage({"stats", "a.json", "--plot", "p.svg", "--counter", "edges.silhouette"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const std::string svg = contentsOf(folder() / "p.svg");
    EXPECT_THAT(svg, StartsWith("<svg "));
    EXPECT_THAT(svg, HasSubstr(">Box_BoxLight<"));
    EXPECT_THAT(svg, HasSubstr(">edges that become sides of a shadow volume (count)<"));
    ASSERT_EQ(umbrage({"stats", "a.json", "--plot", "p.png", "--counter", "edges.silhouette"}).exitCode, 0);
    EXPECT_EQ(channelsOf(folder() / "p.png"), (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_GT(valuesOf(folder() / "p.png").size(), 1000000u);
}

TEST_F(Stats, RefusesWhatIsWrong) {
    render("1", "a.json");
    expectRefused({"stats"}, 2, "inputs is required");
    expectRefused({"stats", "missing.json"}, 3, "missing.json: cannot be read");
    expectRefused({"stats", "seq.yaml"}, 3, "seq.yaml: is not JSON");
    expectRefused({"stats", "a.json", "--plot", "p.svg"}, 2, "--counter");
    expectRefused({"stats", "a.json", "--plot", "p.jpg", "--counter", "quads"}, 2, ".svg or .png");
    expectRefused({"stats", "a.json", "--plot", "p.svg", "--counter", "quad"}, 2, "did you mean \"quads\"?");
    expectRefused({"stats", "a.json", "--merge", "all.txt"}, 2, ".json");
    expectRefused({"stats", "a.json", "--frames", "3-1"}, 3, "--frames");
    expectRefused({"stats", "a.json", "--csv", "seq.yaml/a.csv"}, 5, "seq.yaml");
    Json bad = read("a.json");
    bad["frames"][0]["lights"]["Box_BoxLight"]["values"]["quads"] = "four";
    writeFile("bad.json", bad.dump());
    expectRefused({"stats", "bad.json"}, 3,
                  "bad.json: /frames/0/lights/Box_BoxLight/values/quads: must be a number, but is string");
}

TEST_F(Stats, TheSchemaAcceptsARealFile) {
    render("1-2", "a.json");
    const Result schema = umbrage({"schema", "--statistics"});
    EXPECT_EQ(schema.exitCode, 0);
    EXPECT_TRUE(validates(Json::parse(schema.out), read("a.json")));
}

TEST_F(Stats, ThePageComesWithThumbnailsAndWithoutTheOtherFile) {
    writeSequence("statistics: {page: out/numbers.html}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "2", "--out", "there"}).exitCode, 0);
    EXPECT_THAT(filesIn("there"), testing::ElementsAre("beauty.0002.png", "numbers.html"));
    const std::string page = contentsOf(folder() / "there/numbers.html");
    EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
    EXPECT_NE(page.find("\"thumbnails\":{\"2\":\"data:image/png;base64,iVBOR"), std::string::npos);
}

}  // namespace
}  // namespace umbrage::cli
