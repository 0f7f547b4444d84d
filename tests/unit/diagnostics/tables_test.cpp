// SPDX-License-Identifier: Apache-2.0
// The tables of counters and quantities.
#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "diagnostics/statistics.h"
#include "diagnostics/statistics_format.h"

namespace umbrage {
namespace {

TEST(Counters, HaveUniqueNamesUnitsAndDocumentation) {
    std::set<std::string_view> names;
    for (const CounterInfo& counter : kCounters) {
        EXPECT_TRUE(names.insert(counter.name).second) << counter.name;
        EXPECT_FALSE(counter.unit.empty()) << counter.name;
        EXPECT_FALSE(counter.doc.empty()) << counter.name;
    }
}

TEST(Counters, AreFoundByNameWhileCompiling) {
    constexpr Counter counter = "overdraw.updates";
    static_assert(counter.info().name == "overdraw.updates");
    EXPECT_EQ(counter.info().unit, "count");
}

TEST(Counters, AreInTheTableOfIndependentCounts) {
    std::ifstream file(std::string(UMBRAGE_SOURCE_DIR) + "/docs/counter-checks.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const CounterInfo& counter : kCounters) {
        const bool isClock = counter.name.starts_with("time.") || counter.name == "memory.peak";
        const bool isReuse = counter.name == "frames.reused" || counter.name == "channels.idle";
        if (isClock || isReuse || counter.name == "overdraw.queried") continue;  // the page says why
        EXPECT_THAT(page, testing::HasSubstr("| `" + std::string(counter.name) + "` |"));
    }
}

TEST(Counters, RatiosNameTwoCountersThatAddUp) {
    for (const CounterInfo& ratio : kCounters) {
        EXPECT_EQ(ratio.numerator.empty(), ratio.denominator.empty()) << ratio.name;
        if (ratio.numerator.empty()) continue;
        EXPECT_EQ(ratio.combine, Combine::Mean) << ratio.name;
        for (const std::string_view part : {ratio.numerator, ratio.denominator}) {
            const auto isIt = [&](const CounterInfo& other) { return other.name == part; };
            const auto found = std::find_if(kCounters.begin(), kCounters.end(), isIt);
            ASSERT_NE(found, kCounters.end()) << ratio.name << ": " << part;
            EXPECT_EQ(found->combine, Combine::Sum) << part;
        }
    }
}

TEST(Counters, BelongToAGroup) {
    static_assert(groupOf(0).name == "scene");
    std::set<std::string_view> met;
    for (std::size_t i = 0; i < kCounters.size(); ++i) met.insert(groupOf(i).name);
    EXPECT_EQ(met.size(), kCounterGroups.size()) << "a group begins with a counter that is not there, or out of order";
    EXPECT_EQ(groupOf(Counter("time.frame").index()).name, "time");
    EXPECT_EQ(groupOf(Counter("overdraw.fragments").index()).name, "fill");
    EXPECT_EQ(groupOf(Counter("caps.dark").index()).name, "casters");
}

TEST(Quantities, HaveUniqueNamesThatNoCounterTakesInACsv) {
    std::set<std::string> names;
    for (const CounterInfo& counter : kCounters) names.emplace(counter.name);
    for (const QuantityInfo& quantity : kQuantities) {
        for (const DistributionFigure& figure : kDistributionFigures) {
            const std::string column = std::string(quantity.name) + "." + figure.name;
            EXPECT_TRUE(names.insert(column).second) << column;
        }
        EXPECT_FALSE(quantity.unit.empty() || quantity.doc.empty() || quantity.aov.empty()) << quantity.name;
    }
}

TEST(PeakMemory, CoversWhatWasTouched) {
    const std::vector<char> touched(64 << 20, 1);
    EXPECT_GE(peakHostMemoryMebibytes(), 64.0) << touched.back();
}

}  // namespace
}  // namespace umbrage
