// SPDX-License-Identifier: Apache-2.0
// One table in four forms.
#include "bench/bench_table.h"

#include <gmock/gmock.h>

#include "bench/laine_table.h"

namespace umbrage {
namespace {

using testing::HasSubstr;

BenchTable table() {
    BenchTable made{"speed", "Speed", {}, {}, {"a remark"}};
    made.columns = {{"name", "name", "", -1}, {"a.ms", "a", "time of a, ms", 1}, {"b.ms", "b", "", 2}};
    made.rows = {{"one, two", 1.25, 3.0}, {"three", 10.0, {}}};
    return made;
}

TEST(BenchTable, PrintsNumbersWithTheirDecimalsAndGapsAsDashes) {
    EXPECT_EQ(table().text(),
              "Speed\n"
              "name         a     b\n"
              "one, two   1.2  3.00\n"
              "three     10.0     -\n"
              "a remark\n");
}

TEST(BenchTable, MarkdownSaysWhatColumnsMean) {
    const std::string text = table().markdown();
    EXPECT_THAT(text, HasSubstr("## Speed\n"));
    EXPECT_THAT(text, HasSubstr("| three | 10.0 | - |\n"));
    EXPECT_THAT(text, HasSubstr("- a: time of a, ms\n"));
}

TEST(BenchTable, CsvHasALineForEachNumberInFullPrecision) {
    EXPECT_EQ(BenchTable::csvHead() + table().csv(),
              "measurement,row,column,value\n"
              "speed,\"one, two\",a.ms,1.25\n"
              "speed,\"one, two\",b.ms,3\n"
              "speed,three,a.ms,10\n");
}

TEST(BenchTable, JsonLeavesOutWhatIsNotKnown) {
    const nlohmann::ordered_json json = table().json();
    EXPECT_EQ(json["measurement"], "speed");
    EXPECT_EQ(json["rows"][0]["a.ms"], 1.25);
    EXPECT_EQ(json["rows"][1]["name"], "three");
    EXPECT_FALSE(json["rows"][1].contains("b.ms"));
    EXPECT_EQ(json["columns"]["a.ms"], "time of a, ms");
}

/// The printed ratios, as far as counts with one decimal give them, but for the slip.
TEST(LaineTable, CountsGiveThePrintedRatios) {
    const auto expect = [](const PrintedFigures& figures, const PrintedFigures& base, double tiles, double pixels,
                           double updates) {
        EXPECT_NEAR(figures.tiles / base.tiles, tiles, 0.01 * tiles);
        EXPECT_NEAR(figures.pixels / base.pixels, pixels, 0.01 * pixels);
        EXPECT_NEAR(figures.updates / base.updates, updates, 0.01 * updates);
    };
    expect(kPrintedRows[0].zPass, kPrintedRows[0].splitPlane, 2.87, 3.00, 3.51);
    expect(kPrintedRows[0].zFail, kPrintedRows[0].splitPlane, 2.70, 2.88, 3.42);
    expect(kPrintedRows[1].zPass, kPrintedRows[1].splitPlane, 2.49, 2.93, 3.43);
    expect(kPrintedRows[1].zFail, kPrintedRows[1].splitPlane, 2.18, 2.35, 2.63);
    expect(kPrintedRows[2].zPass, kPrintedRows[2].splitPlane, 2.44, 2.76, 3.27);
    expect(kPrintedRows[2].zFail, kPrintedRows[2].splitPlane, 1.83, 1.87, 2.07);
    expect(kPrintedRows[3].zPass, kPrintedRows[3].splitPlane, 3.78, 5.26, 14.09);
    expect(kPrintedRows[3].zFail, kPrintedRows[3].splitPlane, 3.73, 4.79, 12.30);
}

}  // namespace
}  // namespace umbrage
