// SPDX-License-Identifier: Apache-2.0
// Broken glTF files through the whole program: refused or rendered as their index demands, soon, in bounded memory, and
// in a build with sanitizers without a report. The folder lies beside the source tree; without it this is skipped.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "workspace.h"

namespace umbrage::cli {
namespace {

namespace fs = std::filesystem;

// Measured over the whole corpus: no file takes more than a valid scene does. The slack is for allocators.
constexpr double kSlackMebibytes = 32.0;
constexpr double kMostBytesPerFileByte = 64.0;

class Malformed : public Workspace {
protected:
    Result render(const fs::path& file) const {
        fs::remove_all(folder() / "out");
        return umbrage(Launch{.limitSeconds = 20.0},
                       {"render", file.string(), "--size", "32x24", "--out", "out", "--set",
                        "output.aovs={beauty: exr, depth: exr, normal: exr, shadow: exr}"});
    }

    void expectNoNan() const {
        EXPECT_EQ(filesIn("out").size(), 4u);
        for (const std::string& image : filesIn("out")) {
            for (const double value : valuesOf(folder() / "out" / image)) ASSERT_FALSE(std::isnan(value)) << image;
        }
    }
};

TEST_F(Malformed, EveryFileIsRefusedOrRenderedAsItsIndexSays) {
    const fs::path corpus = fs::path(UMBRAGE_ASSETS_DIR) / "assets-malformed";
    if (!fs::exists(corpus)) GTEST_SKIP() << "there is no " << corpus;
    const Result control = render(sceneFile("lantern"));
    ASSERT_EQ(control.exitCode, 0) << control.err;

    std::map<std::string, std::map<int, int>> counts;
    double longestSeconds = 0.0, largestMebibytes = 0.0;
    for (const nlohmann::json& entry : nlohmann::json::parse(contentsOf(corpus / "index.json"))) {
        const fs::path file = corpus / entry["file"].get<std::string>();
        const std::string expected = entry["expect"];
        SCOPED_TRACE(file.string() + " (" + expected + "): " + entry["what"].get<std::string>());
        double bytes = double(fs::file_size(file));
        for (const nlohmann::json& sidecar : entry["sidecars"]) {
            bytes += double(fs::file_size(corpus / sidecar.get<std::string>()));
        }

        const Result result = render(file);
        ++counts[expected][result.exitCode];
        longestSeconds = std::max(longestSeconds, result.seconds);
        largestMebibytes = std::max(largestMebibytes, result.peakMebibytes);
        const bool fits = expected == "reject" ? result.exitCode == 3
                          : expected == "load" ? result.exitCode == 0
                                               : result.exitCode == 0 || result.exitCode == 3;
        // Reports of sanitizers end the program with another code; what they say is on stderr.
        EXPECT_TRUE(fits) << "exit code " << result.exitCode << ": " << result.err.substr(0, 3000);
        if (result.exitCode == 0) expectNoNan();
        if (result.exitCode == 3) {
            EXPECT_THAT(result.err, testing::HasSubstr("umbrage: error: "));
            EXPECT_THAT(result.err, testing::HasSubstr(file.filename().string())) << "the message names the file";
            EXPECT_THAT(filesIn("out"), testing::IsEmpty());
        }
        EXPECT_LT(result.peakMebibytes,
                  control.peakMebibytes + kSlackMebibytes + kMostBytesPerFileByte * bytes / 1048576.0);
    }
    for (const auto& [expected, byCode] : counts) {
        for (const auto& [code, count] : byCode) std::printf("%s: exit code %d: %d\n", expected.c_str(), code, count);
    }
    std::printf("at most %.2f s and %.0f MiB (a valid scene: %.2f s and %.0f MiB)\n", longestSeconds, largestMebibytes,
                control.seconds, control.peakMebibytes);
}

}  // namespace
}  // namespace umbrage::cli
