// SPDX-License-Identifier: Apache-2.0
#include "counter_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>

namespace umbrage::test {
namespace {

struct Compared {
    std::size_t numbers = 0, different = 0;
    double ours = 0, theirs = 0, largest = 0;
};

/// Writes the table when all tests have run.
class Table : public testing::Environment {
public:
    static Table& instance() {
        static Table* const table = new Table;  // gtest deletes it
        return *table;
    }

    void add(std::size_t counter, const std::string& against, double ours, double theirs) {
        Compared& row = rows_[{counter, against}];
        ++row.numbers;
        row.different += ours != theirs;
        row.ours += ours;
        row.theirs += theirs;
        row.largest = std::max(row.largest, std::abs(ours - theirs));
    }

    void TearDown() override {
        const char* path = std::getenv("UMBRAGE_COUNTER_TABLE");
        if (!path) return;
        std::ofstream file(path);
        file << "# Counters against independent counts\n\n"
                "This page is written by the tests that compare:\n\n"
                "    UMBRAGE_COUNTER_TABLE=docs/counter-checks.md build/test_gpu \\\n"
                "        --gtest_filter='*Fill*:*Sums*:*Overdraw*:*Counters*'\n\n"
                "A number is a counter of one light, or of one frame. *Ours* and *theirs* are the sums of all numbers "
                "compared;\nthe largest difference is that of one number. Against view rays, numbers differ by the "
                "rasteriser's rounding of\ncorners to 1/256 pixel (a fragment more or less along an edge): the tests "
                "hold every pixel to that. `count.net` differs\nwhere such rounding counts -1, which the buffer shows "
                "as 1. Silhouettes are those of meshes whose edges have at\nmost two triangles; edges with more are "
                "counted in pairs of triangles, each for itself.\n\n"
                "Not in the table: `overdraw.queried`, which is the device's count beside `overdraw.fragments`; "
                "`memory.peak`, which\nis the system's; `frames.reused` and `channels.idle`, which "
                "tests/cli/reuse_test.cpp compares; and `time.*`, which\nhave nothing to be compared with (the "
                "passes are tested to take no longer than the frame).\n\n"
                "| counter | against | numbers | of them different | ours | theirs | largest difference |\n"
                "|---|---|--:|--:|--:|--:|--:|\n";
        for (const auto& [key, row] : rows_) {
            file << fmt::format("| `{}` | {} | {} | {} | {:.10g} | {:.10g} | {:.6g} |\n", kCounters[key.first].name,
                                key.second, row.numbers, row.different, row.ours, row.theirs, row.largest);
        }
    }

private:
    std::map<std::pair<std::size_t, std::string>, Compared> rows_;  // in the order of kCounters
};

testing::Environment* const kRegistered = testing::AddGlobalTestEnvironment(&Table::instance());

}  // namespace

void expectCounter(const Counter& counter, const std::string& against, double ours, double theirs, double tolerance) {
    Table::instance().add(counter.index(), against, ours, theirs);
    EXPECT_NEAR(ours, theirs, tolerance) << counter.info().name << " against " << against;
}

}  // namespace umbrage::test
