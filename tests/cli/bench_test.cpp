// SPDX-License-Identifier: Apache-2.0
// umbrage bench: what it prints and writes, and how it ends.
#include <map>
#include <nlohmann/json.hpp>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using Json = nlohmann::json;

class BenchCommand : public Workspace {
protected:
    Json json(const std::string& name) const { return Json::parse(contentsOf(folder() / name)); }
};

TEST_F(BenchCommand, TimesEveryTechniqueOfEverySequence) {
    writeSequence();
    writeFile("bench.yaml",
              "bench: 1\nrounds: 1\ntechniques: [\"compute:z-pass\", \"cpu:z-fail\"]\n"
              "sequences: [{file: seq.yaml}, {name: unlit, file: seq.yaml, frames: 2}]\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "made/b.json", "--csv", "made/b.csv", "--markdown",
                                   "made/b.md", "--rounds", "2", "--out", "made"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("cpu:z-fail"));
    EXPECT_THAT(result.out, HasSubstr("2 rounds"));
    const Json table = json("made/b.json")["measurements"][0];
    EXPECT_EQ(table["measurement"], "times");
    ASSERT_THAT(table["rows"], SizeIs(4));
    for (const Json& row : table["rows"]) {
        for (const char* column : {"frame.ms", "unshadowed.ms", "time.gbuffer.ms", "frames.second", "cold.ms"}) {
            EXPECT_GT(row[column].get<double>(), 0.0) << column;
        }
    }
    EXPECT_THAT(contentsOf(folder() / "made/b.csv"), HasSubstr("times,unlit cpu:z-fail,frame.ms,"));
    EXPECT_THAT(contentsOf(folder() / "made/b.md"), HasSubstr("umbrage bench bench.yaml"));
}

TEST_F(BenchCommand, TimesTheTracerBesideTechniques) {
    writeSequence();
    writeFile("bench.yaml",
              "bench: 1\nrounds: 1\ntracer: true\ntechniques: [\"compute:z-pass\"]\n"
              "sequences: [{file: seq.yaml}, {name: alone, file: seq.yaml, tracer: false}]\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "b.json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Json rows = json("b.json")["measurements"][0]["rows"];
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_EQ(rows[1]["technique"], "tracer");
    for (const char* column : {"frame.ms", "unshadowed.ms", "cold.ms", "bvh.build.ms"}) {
        EXPECT_GT(rows[1][column].get<double>(), 0.0) << column;
    }
    EXPECT_FALSE(rows[1].contains("time.gbuffer.ms"));
    EXPECT_DOUBLE_EQ(rows[0]["frame.ratio"].get<double>(),
                     rows[0]["frame.ms"].get<double>() / rows[1]["frame.ms"].get<double>());
    EXPECT_FALSE(rows[2].contains("frame.ratio"));
}

TEST_F(BenchCommand, PlotsRunTimeAgainstError) {
    writeSequence();
    writeFile("bench.yaml",
              "bench: 1\nrounds: 1\ntracer: true\nmeasure: [error]\noffsets: [0, 1.0e-4]\nshadowMaps: [64]\n"
              "techniques: [\"compute:z-pass\"]\nsequences: [{file: seq.yaml}]\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "made/b.json", "--out", "made"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(filesIn("made"), testing::IsSupersetOf({"error-seq.png", "error-seq.svg"}));
    const Json file = json("made/b.json");
    const Json rows = file["measurements"][0]["rows"];
    ASSERT_THAT(rows, SizeIs(5));
    EXPECT_EQ(rows[0]["technique"], "compute:z-pass");
    EXPECT_EQ(rows[0]["hard"], 0.0);
    EXPECT_GT(rows[0]["lit"].get<double>(), 100.0);
    EXPECT_EQ(rows[1]["technique"], "shadow map 64 biased");
    EXPECT_EQ(rows[2]["technique"], "shadow map 64");
    EXPECT_GT(rows[2]["hard"].get<double>(), rows[1]["hard"].get<double>());
    EXPECT_EQ(rows[3]["technique"], "tracer 0");
    EXPECT_GT(rows[3]["hard"].get<double>(), 0.0);
    EXPECT_EQ(rows[4]["technique"], "tracer 0.0001");
    const Json plot = file["plots"]["error-seq"]["series"];
    EXPECT_EQ(plot["tracer 0"][0][1], rows[3]["wrong.million"]);
    EXPECT_FALSE(plot["Pareto front"].empty());
}

TEST_F(BenchCommand, PlotsAntialiasing) {
    writeSequence();
    writeFile("bench.yaml",
              "bench: 1\nrounds: 1\nmeasure: [antialiasing]\naccumulation: [1, 4, 16]\nreference: 64\n"
              "sequences: [{file: seq.yaml}]\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "made/b.json", "--out", "made"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(filesIn("made"), testing::IsSupersetOf({"antialiasing-seq.png", "antialiasing-seq.svg"}));
    const Json file = json("made/b.json");
    std::map<std::string, double> difference;
    for (const Json& row : file["measurements"][0]["rows"]) {
        EXPECT_GT(row["frame.ms"].get<double>(), 0.0);
        difference[row["way"]] = row["rmse"];
    }
    EXPECT_GT(difference.at("1 pictures"), 1.0);
    EXPECT_LT(difference.at("4 pictures"), 0.7 * difference.at("1 pictures"));
    EXPECT_LT(difference.at("16 pictures"), 0.5 * difference.at("4 pictures"));
    EXPECT_EQ(file["plots"]["antialiasing-seq"]["series"]["pictures"].size(), 3u);
}

TEST_F(BenchCommand, CountsTilesAndDrawsThem) {
    writeSequence();
    writeFile("bench.yaml",
              "bench: 1\nmeasure: [tiles]\nsize: [128, 96]\n"
              "sequences: [{file: seq.yaml, frames: 1-2, printed: KNIGHT}]\n"
              "pictures: [{name: processed, panels: [{sequence: seq, method: SPSV}]}]\n"
              "curves: [{name: updates, sequence: seq}]\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "made/b.json", "--out", "made"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("ZP+DB"));
    EXPECT_THAT(filesIn("made"), testing::IsSupersetOf({"b.json", "processed.png", "updates.png", "updates.svg",
                                                        "tiles-seq.png", "tiles-seq.svg"}));
    const Json file = json("made/b.json");
    double best = 0, split = 0;
    for (const Json& row : file["measurements"][0]["rows"]) {
        EXPECT_EQ(row["different"], 0.0);
        if (row["method"] == "best") best = row["pixels.thousand"];
        if (row["method"] == "SPSV") split = row["pixels.thousand"];
        if (row["method"] != "ZF+DB") continue;
        EXPECT_EQ(row["printed.pixels.thousand"], 490.8);
    }
    EXPECT_GT(best, 0.0);
    EXPECT_LE(best, split);
    EXPECT_THAT(file["plots"]["tiles-seq"]["series"]["SPSV"], SizeIs(2));
    EXPECT_EQ(valuesOf(folder() / "made/processed.png").size() % (128 * 96), 0u);
}

TEST_F(BenchCommand, PlotsHowCostGrows) {
    writeFile("seq.yaml",
              "umbrage: 1\nscene: [{generated: {triangles: 200, columns: 4, lights: 1}}]\nimage: {size: [64, 48]}\n");
    writeFile("bench.yaml",
              "bench: 1\nrounds: 1\ntracer: true\nmeasure: []\nsequences: [{file: seq.yaml}]\n"
              "techniques: [\"cpu:z-pass\", \"plain cpu:z-fail\"]\ngrowth:\n"
              "  - {name: triangles, sequence: seq, set: scene.0.generated.triangles, values: [100, 1000]}\n"
              "  - {name: size, sequence: seq, set: image.size, values: [[64, 48], [128, 96]], patience: 1.0e-6}\n"
              "  - {name: edges, sequence: seq, set: scene.0.generated.triangles, values: [100, 1000], by: edges}\n");
    const Result result = umbrage({"bench", "bench.yaml", "--json", "made/b.json", "--out", "made"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(filesIn("made"), testing::IsSupersetOf({"growth-triangles.svg", "growth-triangles-shadows.png",
                                                        "growth-size.svg", "growth-edges.png"}));
    const Json file = json("made/b.json");
    const auto rowsOf = [&](const Json& table, const std::string& growth) {
        std::vector<Json> rows;
        for (const Json& row : table["rows"]) {
            if (row["growth"] == growth) rows.push_back(row);
        }
        return rows;
    };
    const Json costs = file["measurements"][0], exponents = file["measurements"][1];
    const std::vector<Json> triangles = rowsOf(costs, "triangles");
    ASSERT_THAT(triangles, SizeIs(10)) << "two techniques, the tracer, and twice no shadows, at two values";
    EXPECT_EQ(triangles[1]["technique"], "plain cpu:z-fail");
    EXPECT_EQ(triangles[3]["technique"], "without shadows");
    EXPECT_EQ(triangles[7]["x"], 1000.0);
    EXPECT_DOUBLE_EQ(triangles[7]["shadows.ms"].get<double>(),
                     triangles[7]["frame.ms"].get<double>() - triangles[7]["unshadowed.ms"].get<double>());
    EXPECT_THAT(rowsOf(costs, "size"), SizeIs(5)) << "nobody has patience for the second value";
    EXPECT_THAT(costs["remarks"].dump(), HasSubstr("size: tracer took 0.0 s a frame at [64, 48]"));
    const std::vector<Json> edges = rowsOf(costs, "edges");
    ASSERT_THAT(edges, SizeIs(10));
    EXPECT_EQ(edges[0]["x"], 12 * (1 + 3 * 2 * 2) + 5.0) << "an octahedron, three of two cuts, and the ground";
    const std::vector<Json> grown = rowsOf(exponents, "triangles");
    ASSERT_THAT(grown, SizeIs(5));
    EXPECT_EQ(grown[0]["x.high"], 1000.0);
    EXPECT_THAT(file["plots"]["growth-triangles-shadows"]["series"]["tracer"], SizeIs(2));
}

TEST_F(BenchCommand, RefusesBadFilesAndOptions) {
    const Result missing = umbrage({"bench", "nowhere.yaml"});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_THAT(missing.err, HasSubstr("nowhere.yaml"));
    EXPECT_EQ(umbrage({"bench"}).exitCode, 2);
    writeSequence();
    writeFile("bench.yaml", "bench: 1\nsequences: [{file: sek.yaml}]\n");
    const Result gone = umbrage({"bench", "bench.yaml"});
    EXPECT_EQ(gone.exitCode, 3);
    EXPECT_THAT(gone.err, HasSubstr("sek.yaml"));
    writeFile("bench.yaml", "bench: 1\nsequences: [{file: seq.yaml, casters: [/Nobody]}]\nmeasure: [tiles]\n");
    const Result nobody = umbrage({"bench", "bench.yaml"});
    EXPECT_EQ(nobody.exitCode, 3);
    EXPECT_THAT(nobody.err, HasSubstr("bench.yaml:2:"));
    writeFile("bench.yaml",
              "bench: 1\nsequences: [{file: seq.yaml}, {file: seq.yaml, name: b, set: [\"image.size=[32, 32]\"]}]\n"
              "measure: []\npictures: [{name: p, panels: [{sequence: seq, method: ZP}, {sequence: b, method: ZP}]}]\n");
    const Result sizes = umbrage({"bench", "bench.yaml"});
    EXPECT_EQ(sizes.exitCode, 3);
    EXPECT_THAT(sizes.err, HasSubstr("bench.yaml:4:"));
    EXPECT_THAT(sizes.err, HasSubstr("another size"));
    EXPECT_THAT(sizes.out, IsEmpty());
    writeFile("bench.yaml",
              "bench: 1\nsequences: [{file: seq.yaml}]\nmeasure: []\n"
              "growth: [{name: g, sequence: seq, set: image.sise, values: [1]}]\n");
    const Result path = umbrage({"bench", "bench.yaml"});
    EXPECT_EQ(path.exitCode, 3);
    EXPECT_THAT(path.err, HasSubstr("--set image.sise"));
    writeFile("bench.yaml", "bench: 1\ntracer: true\nsequences: [{file: seq.yaml, set: [image.samples=4]}]\n");
    const Result samples = umbrage({"bench", "bench.yaml"});
    EXPECT_EQ(samples.exitCode, 3);
    EXPECT_THAT(samples.err, HasSubstr("bench.yaml:3:"));
    EXPECT_THAT(samples.err, HasSubstr("image.samples=1"));
}

TEST_F(BenchCommand, ItsPageIsWhatTheProgramWrites) {
    const Result page = umbrage({"schema", "--bench", "--markdown"});
    EXPECT_EQ(page.exitCode, 0);
    EXPECT_EQ(page.out, contentsOf(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "docs/bench.md"))
        << "umbrage schema --bench --markdown > docs/bench.md";
    EXPECT_TRUE(Json::parse(umbrage({"schema", "--bench"}).out)["properties"].contains("sequences"));
}

}  // namespace
}  // namespace umbrage::cli
