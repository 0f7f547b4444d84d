// SPDX-License-Identifier: Apache-2.0
// The page as text; what it does in a browser is tests/cli/page_test.cpp's.
#include "report/statistics_page.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "../diagnostics/runs.h"

namespace umbrage {
namespace {

using testing::HasSubstr;
using testing::Not;

nlohmann::json dataOf(const std::string& page) {
    const std::string open = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(StatisticsPage, HoldsItsNumbersAndThumbnails) {
    const std::string page = statisticsPage(twoFramesFile(), {{2, "PNG!"}});
    EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
    const nlohmann::json data = dataOf(page);
    EXPECT_EQ(data["file"]["frames"][1]["lights"]["Lamp"]["values"]["overdraw.fragments"], 2010);
    EXPECT_EQ(data["file"]["frames"][0]["values"]["overdraw.fragments"], 1015);
    EXPECT_EQ(data["file"]["summary"]["topCasters"][0]["caster"], "/Tree");
    EXPECT_EQ(data["thumbnails"], nlohmann::json::parse(R"({"2": "data:image/png;base64,UE5HIQ=="})"));
}

TEST(StatisticsPage, WritesBase64OfAnyLength) {
    const auto encoded = [](const std::string& bytes) {
        return dataOf(statisticsPage(twoFramesFile(), {{1, bytes}}))["thumbnails"]["1"].get<std::string>().substr(22);
    };
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foo"), "Zm9v");
    EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

TEST(StatisticsPage, NamesNoFileOrHostOutside) {
    const std::string page = statisticsPage(twoFramesFile(), {});
    std::string withoutNamespace = page;
    const std::string svg = "http://www.w3.org/2000/svg";
    while (withoutNamespace.find(svg) != std::string::npos) {
        withoutNamespace.replace(withoutNamespace.find(svg), svg.size(), "");
    }
    EXPECT_EQ(withoutNamespace.find("://"), std::string::npos);
    for (const char* attribute : {"src=\"", "href=\""}) {
        for (std::size_t at = page.find(attribute); at != std::string::npos; at = page.find(attribute, at + 1)) {
            EXPECT_EQ(page.substr(page.find('"', at) + 1, 5), "data:");
        }
    }
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(StatisticsPage, NamesCannotEndTheScript) {
    Statistics s;
    s.record(1, {.light = "</script><b>%TITLE%"}, "quads", 4);
    const std::string page = statisticsPage(s.file({{"sequence", "<i>&.yaml"}}), {});
    EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
    EXPECT_THAT(page, HasSubstr("<title>Statistics of &lt;i&gt;&amp;.yaml</title>"));
    EXPECT_TRUE(dataOf(page)["file"]["frames"][0]["lights"].contains("</script><b>%TITLE%"));
}

}  // namespace
}  // namespace umbrage
