// SPDX-License-Identifier: Apache-2.0
// shadow.parts and shadow.splitPlane in sequence files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expect_error.h"
#include "job/job.h"

namespace umbrage {
namespace {

JobParts partsOf(const std::string& shadow) {
    return parseJob("umbrage: 1\nscene: [{gltf: a.glb}]\nshadow: " + shadow + "\n", "a.yaml", ".").shadow.parts;
}

TEST(JobParts, AutomaticUnlessSaidOtherwise) {
    const JobParts parts = partsOf("{}");
    EXPECT_TRUE(parts.automatic);
    EXPECT_TRUE(parts.globs.empty());
    EXPECT_EQ(parts.splitPlane, "auto");
    EXPECT_TRUE(partsOf("{parts: auto}").automatic);
    EXPECT_FALSE(partsOf("{parts: instances}").automatic);
}

TEST(JobParts, GlobsKeepTheirPlaces) {
    const JobParts parts = partsOf("{parts: [/Knight*, /Tree]}");
    EXPECT_FALSE(parts.automatic);
    ASSERT_EQ(parts.globs.size(), 2u);
    EXPECT_EQ(parts.globs[1].value, "/Tree");
    EXPECT_EQ(parts.globs[1].place.line, 3);
}

TEST(JobParts, SplitPlanesForAllOrByGlobs) {
    EXPECT_EQ(partsOf("{splitPlane: point-point-light}").splitPlane, "point-point-light");
    const JobParts parts = partsOf("{splitPlane: {/A: point-camera-light, /B: {points: [[0, 1, 2], [3, 4, 5]]}}}");
    EXPECT_EQ(parts.splitPlane, "auto");
    ASSERT_EQ(parts.ownSplitPlanes.size(), 2u);
    EXPECT_EQ(parts.ownSplitPlanes[0].plane, "point-camera-light");
    EXPECT_FALSE(parts.ownSplitPlanes[0].points);
    ASSERT_TRUE(parts.ownSplitPlanes[1].points);
    EXPECT_EQ((*parts.ownSplitPlanes[1].points)[1][2], 5.0);
    EXPECT_EQ(parts.ownSplitPlanes[1].glob.value, "/B");
}

TEST(JobParts, TheOverlayOfPlanesNeedsTheCountThatHasThem) {
    const std::string head = "umbrage: 1\nscene: [{gltf: a.glb}]\ndiagnostics: {overlays: [split-plane]}\n";
    EXPECT_THROW(parseJob(head, "a.yaml", "."), Error);
    EXPECT_NO_THROW(parseJob(head + "shadow: {count: split-plane}\n", "a.yaml", "."));
}

}  // namespace
}  // namespace umbrage
