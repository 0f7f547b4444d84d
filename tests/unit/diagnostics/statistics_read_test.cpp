// SPDX-License-Identifier: Apache-2.0
// Statistics files that are read back.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "error.h"
#include "runs.h"

namespace umbrage {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::ordered_json;

TEST(StatisticsRead, GivesBackWhatWasWritten) {
    const StatisticsFile written = twoFramesFile();
    const StatisticsFile read = parseStatistics(written.json(), "a.json");
    EXPECT_EQ(read.header, written.header);
    EXPECT_EQ(read.counters, written.counters);
    EXPECT_EQ(read.quantities, written.quantities);
    EXPECT_EQ(read.frames, written.frames);
    EXPECT_EQ(read.json(), written.json());
    EXPECT_EQ(read.csv(), written.csv());
}

TEST(StatisticsRead, KnowsCountersOfOtherVersions) {
    const StatisticsFile file = parseStatistics(
        R"({"format": "umbrage statistics 1", "sequence": "s.yaml",
            "counters": {"flux": {"group": "odd", "unit": "Wb", "doc": "?", "combine": "largest"}}, "quantities": {},
            "frames": [{"frame": -3, "values": {"flux": 0.5}, "lights": {"A": {"values": {"flux": 2}}}}]})",
        "a.json");
    ASSERT_EQ(file.counters.size(), 1u);
    EXPECT_EQ(file.counters[0].name, "flux");
    EXPECT_EQ(file.counters[0].combine, Combine::Largest);
    EXPECT_EQ(file.frames.at(-3).at({}).values.at(0), 0.5);
    EXPECT_EQ(file.frames.at(-3).at({.light = "A"}).values.at(0), 2.0);
}

void expectRefused(const Json& document, const std::string& pointer, const std::string& message) {
    try {
        parseStatistics(document.dump(), "a.json");
        ADD_FAILURE() << "accepted: " << pointer;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_EQ(error.where(), pointer.empty() ? "a.json" : "a.json: " + pointer);
        EXPECT_THAT(error.message(), HasSubstr(message));
    }
}

TEST(StatisticsRead, SaysWhereTheFileIsWrong) {
    const Json good = Json::parse(twoFramesFile().json());
    const auto refused = [&](const char* changed, const Json& value, const char* pointer, const char* message) {
        Json bad = good;
        bad[Json::json_pointer(changed)] = value;
        expectRefused(bad, pointer, message);
    };
    const auto refusedThere = [&](const char* pointer, const Json& value, const char* message) {
        refused(pointer, value, pointer, message);
    };
    refusedThere("/frames", "none", "must be an array, but is string");
    refusedThere("/frames/0/frame", 1.5, "a whole number");
    refusedThere("/frames/0/frame", 3000000000, "too large");
    refused("/frames/1/frame", 1, "/frames/1", "frame 1 is there twice");
    refusedThere("/frames/0/values", Json::array(), "must be an object, but is array");
    refusedThere("/frames/0/values/triangles", "many", "must be a number, but is string");
    refusedThere("/frames/0/values/trinagles", 4, "is not explained under /counters");
    refusedThere("/frames/0/objects", Json::object(), "does not belong here");
    refusedThere("/frames/0/lights/Lamp/lights", Json::object(), "does not belong here");
    refused("/frames/0/lights/Lamp", {{"value", 3}}, "/frames/0/lights/Lamp", "\"values\" is missing");
    refused("/frames/0/lights/Lamp/casters/~1Box/values/quads", nullptr,
            "/frames/0/lights/Lamp/casters/~1Box/values/quads", "but is null");
    refused("/frames/0/distributions/overdraw/pixels", 7, "/frames/0/distributions/overdraw",
            "another number of pixels");
    refused("/frames/0/distributions/overdraw/histogram/1/0", 0, "/frames/0/distributions/overdraw", "ascending");
    refusedThere("/frames/0/distributions/overdraw/histogram/1", 0, "a pair");
    refusedThere("/frames/0/distributions/overdraw/histogram/1/1", -4, "whole number that is not negative");
    refusedThere("/counters/quads/combine", "product", "must be sum, largest, mean");
    refusedThere("/counters/quads/ratio", {"quads"}, "two counters");
    refusedThere("/clock", 3, "must be a string");
}

TEST(StatisticsRead, RefusesOtherFiles) {
    const auto refused = [](const char* text, const std::string& message) {
        try {
            parseStatistics(text, "a.json");
            ADD_FAILURE() << "accepted: " << text;
        } catch (const Error& error) {
            EXPECT_THAT(std::string(error.what()), AllOf(StartsWith("a.json: is no"), HasSubstr(message)));
        }
    };
    refused("", "is not JSON: parse error at line 1, column 1");
    refused("frame,light,counter", "is not JSON");
    refused("{\"format\": \"umbrage statistics 1\",", "is not JSON");
    refused("[]", "is no statistics file");
    refused("{}", "is no statistics file");
    refused("{\"format\": \"umbrage statistics 2\"}", "is no statistics file");
}

TEST(StatisticsRead, NamesAFileThatIsNotThere) {
    try {
        readStatistics("/no/such/file.json");
        ADD_FAILURE() << "read";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "/no/such/file.json: cannot be read");
    }
    EXPECT_THROW(readStatistics("/"), Error);
}

}  // namespace
}  // namespace umbrage
