// SPDX-License-Identifier: Apache-2.0
#include "job/aovs.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <set>

namespace umbrage {
namespace {

using testing::ElementsAre;

const AovInfo& aov(std::string_view name) {
    return *std::find_if(kAovs.begin(), kAovs.end(), [&](const AovInfo& info) { return info.name == name; });
}

TEST(AovTable, NamesAndChannelsAreUnique) {
    std::set<std::string> names, channels;
    for (const AovInfo& info : kAovs) {
        EXPECT_TRUE(names.insert(std::string(info.name)).second) << info.name;
        const std::vector<std::string> own = channelNames(info, {"Lamp"});
        EXPECT_EQ(own.size(), std::size_t(info.channelCount())) << info.name;
        for (const std::string& channel : own) EXPECT_TRUE(channels.insert(channel).second) << channel;
    }
}

TEST(AovTable, AChannelIsThereForEachLight) {
    EXPECT_THAT(channelNames(aov("shadow"), {"A", "B.001"}), ElementsAre("shadow.A", "shadow.B.001"));
    EXPECT_THAT(channelNames(aov("light"), {"A", "B"}),
                ElementsAre("light.A.R", "light.A.G", "light.A.B", "light.B.R", "light.B.G", "light.B.B"));
    EXPECT_THAT(channelNames(aov("light"), {}), ElementsAre());
    EXPECT_THAT(channelNames(aov("depth"), {"A", "B"}), ElementsAre("Z"));
}

TEST(AovTable, DataIsNeverAveraged) {
    for (const AovInfo& info : kAovs) {
        if (info.format == AovFormat::UInt) {
            EXPECT_EQ(info.sampling, AovSampling::First) << info.name;
        }
    }
    for (const char* name : {"depth", "normal", "geometricNormal", "position", "motion"}) {
        EXPECT_EQ(aov(name).sampling, AovSampling::First) << name;
    }
}

TEST(AovTable, TheReferenceInTheRepositoryIsTheOneOfTheTable) {
    std::ifstream file(UMBRAGE_SOURCE_DIR "/docs/aovs.md", std::ios::binary);
    const std::string written{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(written == aovReference()) << "run: umbrage schema --aovs > docs/aovs.md";
}

}  // namespace
}  // namespace umbrage
