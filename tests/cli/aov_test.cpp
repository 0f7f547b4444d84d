// SPDX-License-Identifier: Apache-2.0
// AOV files as others read them: OpenEXR's and OpenImageIO's own tools say what is in them.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Expected {
    std::vector<std::string> channels;
    std::string type;  // half or float: those that output.exrHalf changes are half here
};

/// Of the lantern, which has two lights.
const std::map<std::string, Expected>& expectedAovs() {
    const auto ofLights = [](const std::string& name, const std::vector<std::string>& parts = {""}) {
        std::vector<std::string> channels;
        for (const char* light : {"Box_BoxLight", "Cage_CageLight"}) {
            for (const std::string& part : parts) channels.push_back(name + "." + light + part);
        }
        return channels;
    };
    static const std::map<std::string, Expected> table = {
        {"beauty", {{"R", "G", "B"}, "half"}},
        {"depth", {{"Z"}, "float"}},
        {"normal", {{"N.X", "N.Y", "N.Z"}, "half"}},
        {"geometricNormal", {{"Ng.X", "Ng.Y", "Ng.Z"}, "half"}},
        {"position", {{"P.X", "P.Y", "P.Z"}, "float"}},
        {"albedo", {{"albedo.R", "albedo.G", "albedo.B"}, "half"}},
        {"surface", {{"surface.roughness", "surface.metallic"}, "half"}},
        {"light", {ofLights("light", {".R", ".G", ".B"}), "half"}},
        {"ambient", {{"ambient.R", "ambient.G", "ambient.B"}, "half"}},
        {"emissive", {{"emissive.R", "emissive.G", "emissive.B"}, "half"}},
        {"ids", {{"objectId", "materialId", "primitiveId"}, "uint"}},
        {"motion", {{"motion.X", "motion.Y"}, "float"}},
        {"shadow", {ofLights("shadow"), "half"}},
        {"stencil", {ofLights("stencil"), "uint"}},
        {"silhouette", {ofLights("silhouette"), "half"}},
        {"contour", {{"contour"}, "half"}},
        {"cost", {ofLights("cost"), "float"}},
        {"overdraw", {{"overdraw.fragments", "overdraw.updates"}, "float"}},
        {"scene", {{"scene.fragments", "scene.shaded"}, "float"}},
    };
    return table;
}

std::map<std::string, std::string> typesOf(const Expected& expected) {
    std::map<std::string, std::string> types;
    for (const std::string& channel : expected.channels) types[channel] = expected.type;
    return types;
}

/// A part of an EXR as a tool lists it.
struct Listed {
    std::map<std::string, std::string> types;  // by channel
    std::map<std::string, std::string> texts;  // string attributes
};

std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
    return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

class AovFiles : public Workspace {
protected:
    /// output: with all of them as exr, and `more`.
    void writeEveryAov(const std::string& more = "") const {
        std::string aovs;
        for (const auto& [name, expected] : expectedAovs()) aovs += (aovs.empty() ? "" : ", ") + name + ": exr";
        writeSequence("output:\n  path: \"out/{aov}.{frame:04}.{ext}\"\n  aovs: {" + aovs + "}\n" + more);
    }
    std::filesystem::path fileOf(const std::string& aov) const { return folder() / "out" / (aov + ".0001.exr"); }

    /// What a program that Debian has says; empty with a skip where there is none.
    static std::string tool(const std::string& name, std::vector<std::string> arguments) {
        Launch launch;
        launch.program = "/usr/bin/" + name;
        const Result result = run(launch, arguments);
        EXPECT_EQ(result.exitCode, 0) << name << ": " << result.err;
        return result.out;
    }
    static bool toolsAreThere() {
        for (const char* name : {"exrheader", "exrinfo", "oiiotool"}) {
            if (!std::filesystem::exists(std::string("/usr/bin/") + name)) return false;
        }
        return true;
    }
    static Listed exrheader(const std::filesystem::path& file) {
        const std::map<std::string, std::string> names = {
            {"16-bit floating-point", "half"}, {"32-bit floating-point", "float"}, {"32-bit unsigned integer", "uint"}};
        const std::string text = tool("exrheader", {file.string()});
        Listed listed;
        for (const auto& m : matches(text, std::regex("\n    ([^ ,]+), ([^,\n]+), sampling 1 1"))) {
            listed.types[m[1]] = names.at(m[2]);
        }
        for (const auto& m : matches(text, std::regex("\n([^ ]+) \\(type string\\): \"(.*)\"(?=\n)")))
            listed.texts[m[1]] = m[2];
        return listed;
    }
    /// Of one channel, bit by bit: EXR's types fit into 32.
    static std::vector<std::uint32_t> channelOf(const std::filesystem::path& file, const std::string& channel) {
        const auto input = OIIO::ImageInput::open(file.string());
        EXPECT_TRUE(input) << OIIO::geterror();
        if (!input) return {};
        const int index = input->spec().channelindex(channel);
        const bool integer = input->spec().channelformat(index) == OIIO::TypeDesc::UINT;
        std::vector<std::uint32_t> values(std::size_t(input->spec().width) * std::size_t(input->spec().height));
        EXPECT_TRUE(input->read_image(0, 0, index, index + 1, integer ? OIIO::TypeDesc::UINT : OIIO::TypeDesc::FLOAT,
                                      values.data()));
        return values;
    }
};

TEST_F(AovFiles, OtherToolsReadEveryOneWithItsNamesTypesAndMeaning) {
    if (!toolsAreThere()) GTEST_SKIP() << "exrheader, exrinfo or oiiotool is missing (packages.txt)";
    writeEveryAov();
    const Result result = umbrage({"render", "seq.yaml", "--frames", "1"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(filesIn("out").size(), expectedAovs().size());
    for (const auto& [name, expected] : expectedAovs()) {
        SCOPED_TRACE(name);
        const Listed header = exrheader(fileOf(name));
        EXPECT_EQ(header.types, typesOf(expected));
        EXPECT_THAT(header.texts.at("umbrage:aovs"), testing::StartsWith(name + ": "));
        const bool colour = expected.channels.front().ends_with("R");
        EXPECT_EQ(header.texts.at("colorInteropID"), colour ? "lin_rec709_scene" : "data");

        std::map<std::string, std::string> summary;
        const std::string lines = tool("exrinfo", {"-s", fileOf(name).string()});
        for (const auto& m : matches(lines, std::regex("'([^']+)': (half|float|uint) samp 1 1"))) summary[m[1]] = m[2];
        EXPECT_EQ(summary, typesOf(expected));

        const std::string info = tool("oiiotool", {"--info", "-v", fileOf(name).string()});
        EXPECT_THAT(info, HasSubstr("  64 x   48, " + std::to_string(expected.channels.size()) + " channel, " +
                                    expected.type + " openexr"));
        for (const std::string& channel : expected.channels) EXPECT_THAT(info, HasSubstr(channel));
    }
}

TEST_F(AovFiles, WithoutHalvesColoursAndNormalsAreFloats) {
    writeEveryAov("  exrHalf: off\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const std::set<std::string> masks = {"surface", "shadow", "silhouette", "contour"};
    for (const auto& [name, expected] : expectedAovs()) {
        const auto input = OIIO::ImageInput::open(fileOf(name).string());
        ASSERT_TRUE(input);
        const std::string type = expected.type == "half" && !masks.contains(name) ? "float" : expected.type;
        EXPECT_EQ(input->spec().format.c_str(), type) << name;
    }
}

TEST_F(AovFiles, ValuesAreFiniteButForDepthAndSomethingIsInEachOfThem) {
    writeEveryAov();
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "2", "--set", "image.background=[.1, .2, .3]", "--set",
                       "image.ambient=[.1, .1, .1]"})
                  .exitCode,
              0);
    for (const auto& [name, expected] : expectedAovs()) {
        const std::vector<double> values = valuesOf(folder() / "out" / (name + ".0002.exr"));
        bool differ = false;
        for (const double value : values) {
            ASSERT_TRUE(std::isfinite(value) || name == "depth") << name;
            differ = differ || value != values[0];
        }
        EXPECT_TRUE(differ || name == "emissive") << name << " is the same everywhere";  // a room of dull walls
    }
}

TEST_F(AovFiles, EveryNumberInIdsHasAName) {
    writeEveryAov();
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const auto input = OIIO::ImageInput::open(fileOf("ids").string());
    for (const auto& [channel, attribute] :
         {std::pair("objectId", "umbrage:objects"), {"materialId", "umbrage:materials"}}) {
        const auto names = nlohmann::json::parse(std::string(input->spec().get_string_attribute(attribute)));
        std::set<std::string> seen;
        for (const std::uint32_t id : channelOf(fileOf("ids"), channel)) {
            if (id != 0) seen.insert(names.at(std::to_string(id)).get<std::string>());
        }
        EXPECT_GE(seen.size(), 2u);
        if (std::string(channel) == "objectId") {
            EXPECT_THAT(seen, testing::Each(testing::StartsWith("/")));
        }
    }
}

TEST_F(AovFiles, LayersAreOneFileWithTheChannelsOfAll) {
    writeEveryAov();
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const Result result = umbrage({"render", "seq.yaml", "--frames", "1", "--out", "layered", "--set",
                                   "output.layers=all/{scene}.{frame:04}.exr", "--set", "output.aovs.beauty=png",
                                   "--set", "diagnostics.overlays=[stencil]"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(filesIn("layered"), ElementsAre("beauty.0001.png", "overlay-stencil.0001.png", "seq.0001.exr"));

    const std::filesystem::path file = folder() / "layered/seq.0001.exr";
    std::map<std::string, std::string> types;
    for (const auto& [name, expected] : expectedAovs()) {
        if (name == "beauty") continue;
        types.merge(typesOf(expected));
        for (const std::string& channel : expected.channels) {
            EXPECT_TRUE(channelOf(file, channel) == channelOf(fileOf(name), channel)) << channel;
        }
    }
    if (!toolsAreThere()) GTEST_SKIP() << "exrheader, exrinfo or oiiotool is missing (packages.txt)";
    const Listed header = exrheader(file);
    EXPECT_EQ(header.types, types);
    EXPECT_EQ(header.texts.count("umbrage:objects"), 1u);
    EXPECT_THAT(tool("oiiotool", {"--info", file.string()}),
                HasSubstr("  64 x   48, " + std::to_string(types.size()) + " channel, "));
}

TEST_F(AovFiles, LayersThatCannotBeAreRefused) {
    writeEveryAov();
    const auto refused = [&](const std::string& path, const std::string& message,
                             const std::string& also = "image.samples=1") {
        const Result result = umbrage({"render", "seq.yaml", "--set", "output.layers=" + path, "--set", also});
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_THAT(result.err, HasSubstr(message));
    };
    refused("out/layers.exr", "the output path has no {frame}, but 3 frames would have this name");
    refused("out/layers.{frame}.tif", "only EXR files have layers");
    refused("out/{aov}.{frame}.exr", "the file of all AOVs has no {aov}");
    refused("out/layers.{frame}.exr", "there is no AOV for this file", "output.aovs={beauty: png}");
}

TEST_F(AovFiles, MotionIsTheSameWhateverFramesAreRendered) {
    writeFile("walk.yaml", "umbrage: 1\nscene: [{gltf: \"" + sceneFile("courtyard") +
                               "\"}]\ncamera: /Dolly\ntime: {frames: 1-3}\nimage: {size: [96, 72]}\n"
                               "output: {path: \"{aov}.{frame:04}.{ext}\", aovs: {motion: exr}}\n");
    ASSERT_EQ(umbrage({"render", "walk.yaml", "--out", "all"}).exitCode, 0);
    ASSERT_EQ(umbrage({"render", "walk.yaml", "--out", "last", "--frames", "3"}).exitCode, 0);
    const std::string last = "motion.0003.exr", first = "motion.0001.exr";
    EXPECT_EQ(contentsOf(folder() / "all" / last), contentsOf(folder() / "last" / last));
    EXPECT_THAT(valuesOf(folder() / "all" / first), testing::Contains(testing::Not(0.0))) << "there is a frame 0";
}

TEST_F(AovFiles, AMisspeltOneIsAnErrorThatNamesTheNearest) {
    writeSequence();
    const Result result = umbrage({"render", "seq.yaml", "--set", "output.aovs.motoin=exr"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err, HasSubstr("motion"));
    const Result picture = umbrage({"render", "seq.yaml", "--set", "output.aovs.motion=png"});
    EXPECT_EQ(picture.exitCode, 3);
    EXPECT_THAT(picture.err, HasSubstr("motion is data, which PNG would cut to [0, 1] (write exr)"));
    EXPECT_THAT(umbrage({"render", "--help"}).out, HasSubstr(" geometricNormal position albedo "));
}

}  // namespace
}  // namespace umbrage::cli
