// SPDX-License-Identifier: Apache-2.0
// docs/benchmarks.sh: the page of benchmarks, of a template and what the bench finds.
#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class BenchmarksPage : public Workspace {
protected:
    void SetUp() override {
        Workspace::SetUp();
        namespace fs = std::filesystem;
        for (const char* made : {"docs", "build", "configs/bench"}) fs::create_directories(folder() / made);
        fs::copy_file(UMBRAGE_SOURCE_DIR "/docs/benchmarks.sh", folder() / "docs/benchmarks.sh");
        fs::create_symlink(UMBRAGE_PROGRAM, folder() / "build/umbrage");
        writeFile("seq.yaml",
                  "umbrage: 1\nscene: [{generated: {triangles: 200, columns: 4}}]\nimage: {size: [32, 24]}\n");
        writeFile("configs/bench/small.yaml",
                  "bench: 1\nrounds: 1\nmeasure: []\nsequences: [{file: ../../seq.yaml}]\ngrowth:\n"
                  "  - {name: edges, sequence: seq, set: scene.0.generated.triangles, values: [100, 200]}\n");
    }

    Result make(const std::string& template_, const std::vector<std::string>& names = {}) const {
        writeFile("docs/benchmarks.in.md", template_);
        std::vector<std::string> arguments{"docs/benchmarks.sh"};
        arguments.insert(arguments.end(), names.begin(), names.end());
        Launch launch;
        launch.program = "/bin/bash";
        launch.folder = folder();
        return run(launch, arguments);
    }
};

TEST_F(BenchmarksPage, IsTheTemplateWithWhatWasMeasured) {
    const std::string words =
        "# Page\n\n@machine@\n\n@command small@\n\n@table small How it grows@\n\n@notes small Growth@\n\n"
        "![edges](images/bench-small-growth-edges.svg)\n";
    const Result result = make(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const std::string page = contentsOf(folder() / "docs/benchmarks.md");
    EXPECT_THAT(page, testing::StartsWith("# Page\n\n"));
    EXPECT_THAT(page, HasSubstr(" processors; umbrage "));
    EXPECT_THAT(page, HasSubstr("\n    build/umbrage bench configs/bench/small.yaml --out out/bench/small"));
    EXPECT_THAT(page, HasSubstr("| edges | without shadows | 100.0 | 200.0 |"));
    EXPECT_THAT(page, HasSubstr("1 rounds, frames by the wall's clock."));
    EXPECT_THAT(page, Not(HasSubstr("| edges | without shadows | 100 |"))) << "of notes there is no table";
    EXPECT_THAT(page, Not(HasSubstr("@")));
    EXPECT_THAT(contentsOf(folder() / "docs/images/bench-small-growth-edges.svg"), HasSubstr("<svg"));

    const std::string measured = contentsOf(folder() / "out/bench/small.json");
    writeFile("configs/bench/other.yaml", contentsOf(folder() / "configs/bench/small.yaml"));
    EXPECT_EQ(make(words + "@command other@\n", {"other"}).exitCode, 0);
    EXPECT_EQ(contentsOf(folder() / "out/bench/small.json"), measured) << "what is not named is not measured again";
}

TEST_F(BenchmarksPage, ASlipInTheTemplateIsSaid) {
    for (const auto& [line, message] : {std::pair("@table small Grwth@", "no \"Grwth\""),
                                        {"@tabel small Growth@", "what is"},
                                        {"![](images/bench-small-nothing.svg)", "bench-small-nothing.svg"}}) {
        SCOPED_TRACE(line);
        const Result result = make(std::string("@command small@\n") + line + "\n");
        EXPECT_NE(result.exitCode, 0);
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_FALSE(std::filesystem::exists(folder() / "docs/benchmarks.md"));
    }
}

}  // namespace
}  // namespace umbrage::cli
