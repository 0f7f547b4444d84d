// SPDX-License-Identifier: Apache-2.0
#include "scene/node_paths.h"

#include <gtest/gtest.h>

namespace umbrage {
namespace {

TEST(Glob, StarsStayWithinAPartAndDoubleStarsDoNot) {
    EXPECT_TRUE(matchesGlob("/A/Lamp*", "/A/Lamp"));
    EXPECT_TRUE(matchesGlob("/A/Lamp*", "/A/Lamp12"));
    EXPECT_FALSE(matchesGlob("/A/Lamp*", "/A/Lamp/Bulb"));
    EXPECT_TRUE(matchesGlob("/A/**", "/A/Lamp/Bulb"));
    EXPECT_TRUE(matchesGlob("/**/Bulb", "/A/Lamp/Bulb"));
    EXPECT_TRUE(matchesGlob("/*/*/Bulb", "/A/Lamp/Bulb"));
    EXPECT_FALSE(matchesGlob("/*/Bulb", "/A/Lamp/Bulb"));
    EXPECT_TRUE(matchesGlob("/A/L?mp", "/A/Lamp"));
    EXPECT_FALSE(matchesGlob("/A?Lamp", "/A/Lamp"));
    EXPECT_TRUE(matchesGlob("/A/[1]", "/A/[1]"));
    EXPECT_FALSE(matchesGlob("Lamp", "/A/Lamp"));
    EXPECT_TRUE(matchesGlob("", ""));
    EXPECT_FALSE(matchesGlob("", "/A"));
}

TEST(Glob, ManyStarsTakeNoExponentialTime) {
    std::string glob;
    for (int i = 0; i < 100; ++i) glob += "a*";
    EXPECT_FALSE(matchesGlob(glob + "b", std::string(1000, 'a')));
}

}  // namespace
}  // namespace umbrage
