// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_error.h"

#include <gmock/gmock.h>

namespace umbrage {
namespace {

using testing::ElementsAre;

TEST(ParetoFront, HoldsWhatNothingIsBetterThan) {
    EXPECT_THAT(onFront({{1, 9}, {2, 9}, {3, 1}, {4, 0}, {5, 0}, {0.5, 20}}),
                ElementsAre(true, false, true, true, false, true));
}

TEST(ParetoFront, HoldsAllThatAreAlike) {
    EXPECT_THAT(onFront({{1, 1}, {1, 1}, {1, 2}}), ElementsAre(true, true, false));
    EXPECT_TRUE(onFront({}).empty());
}

}  // namespace
}  // namespace umbrage
