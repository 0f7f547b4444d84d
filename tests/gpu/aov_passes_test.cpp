// SPDX-License-Identifier: Apache-2.0
// AOVs with passes of their own: fragments of the scene, cost of a light, silhouette edges.
#include "aovs.h"

namespace umbrage::test {
namespace {

class AovPasses : public testing::TestWithParam<int> {
protected:
    int samples = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Samples, AovPasses, testing::Values(1, 4), testing::PrintToStringParamName());

/// Sheets before each other that fill the picture; each is drawn as it is added.
TestScene stack(std::initializer_list<float> depths) {
    TestScene test;
    test.eye = {0.0, 0.0, 5.0};
    for (const float z : depths) test.add(quad({-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}));
    return test;
}

TEST_P(AovPasses, SceneCountsWhatIsHiddenAndWhatWasShadedInTheOrderItIsDrawn) {
    const auto counts = [&](std::initializer_list<float> depths) {
        const AovFrame frame(stack(depths), samples);
        const SceneFragments& scene = frame.pixels.scene;
        const std::uint64_t all = AovFrame::kPixelCount;
        EXPECT_EQ(scene.coveredPixels, all);
        for (std::size_t i = 0; i < all; ++i) {
            if (scene.fragments[i] != scene.fragments[0] || scene.shaded[i] != scene.shaded[0]) ADD_FAILURE() << i;
        }
        EXPECT_EQ(scene.fragmentSamples, std::uint64_t(scene.fragments[0]) * all * std::uint64_t(samples));
        EXPECT_EQ(scene.shadedSamples, std::uint64_t(scene.shaded[0]) * all * std::uint64_t(samples));
        return std::pair(scene.fragments[0], scene.shaded[0]);
    };
    EXPECT_EQ(counts({0.0f, 1.0f, 2.0f}), std::pair(3.0f, 3.0f));
    EXPECT_EQ(counts({2.0f, 1.0f, 0.0f}), std::pair(3.0f, 1.0f));
    EXPECT_EQ(counts({1.0f, 2.0f, 0.0f}), std::pair(3.0f, 2.0f));
    EXPECT_EQ(counts({1.0f, 1.0f, 6.0f}), std::pair(2.0f, 1.0f)) << "the third is behind the eye";
}

TEST_P(AovPasses, SceneLeavesOutCulledFacesHolesAndWhatIsTooFar) {
    TestScene test = stack({0.0f, -20.0f});
    test.camera.zfar = 15.0;
    test.add(quad({-9, -9, 1}, {-9, 9, 1}, {9, 9, 1}, {9, -9, 1}));  // seen from behind
    Material masked;
    masked.alphaMode = AlphaMode::Mask;
    masked.baseColor.a = 0.1f;
    test.add(quad({-9, -9, 2}, {9, -9, 2}, {9, 9, 2}, {-9, 9, 2}));
    test.scene.meshes.back().primitives[0].material = Index(test.scene.materials.size());
    test.scene.materials.push_back(masked);
    const AovFrame frame(test, samples);
    EXPECT_EQ(frame.pixels.scene.fragments, std::vector<float>(AovFrame::kPixelCount, 1.0f));
    EXPECT_EQ(frame.pixels.scene.shaded, std::vector<float>(AovFrame::kPixelCount, 1.0f));
    EXPECT_EQ(frame.ids(0), glm::uvec3(1, 1, frame.ids(0).z)) << "through the hole";
}

TEST_P(AovPasses, SceneAddsUpToItsTotalsOnAnyPicture) {
    const AovFrame frame(courtScene(), samples);
    const SceneFragments& scene = frame.pixels.scene;
    double fragments = 0.0, shaded = 0.0, covered = 0.0;
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        fragments += scene.fragments[i];
        shaded += scene.shaded[i];
        covered += scene.fragments[i] > 0.0f;
        ASSERT_LE(scene.shaded[i], scene.fragments[i]);
        ASSERT_EQ(scene.shaded[i] > 0.0f, scene.fragments[i] > 0.0f);
    }
    EXPECT_EQ(fragments * samples, double(scene.fragmentSamples));
    EXPECT_EQ(shaded * samples, double(scene.shadedSamples));
    EXPECT_EQ(covered, double(scene.coveredPixels));
    EXPECT_LT(scene.shadedSamples, scene.fragmentSamples);
}

TEST_P(AovPasses, CostsOfLightsAddUpToOverdraw) {
    const AovFrame frame(courtScene(), samples);
    std::vector<float> sum(AovFrame::kPixelCount);
    for (const LightPlanes& light : frame.pixels.lights) {
        const std::vector<float>& cost = light.aovs.find("cost")->second.values;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += cost[i];
    }
    EXPECT_EQ(sum, frame.pixels.overdrawFragments);
    EXPECT_GT(*std::max_element(sum.begin(), sum.end()), 1.0f);
    const std::vector<float>& off = frame.pixels.lights[2].aovs.find("cost")->second.values;
    EXPECT_EQ(off, std::vector<float>(AovFrame::kPixelCount, 0.0f));
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + t * (b - a));
}

/// A box from -1 to 1.
struct BoxFrame {
    static constexpr glm::dvec3 kEye{2.0, 2.5, 4.0}, kLight{-1.5, 4.0, 3.0};

    static TestScene scene() {
        TestScene test;
        test.eye = kEye;
        test.add(box(glm::vec3(-1.0f), glm::vec3(1.0f)));
        test.addLight(LightType::Point, kLight);
        return test;
    }
    explicit BoxFrame(int samples) : frame(scene(), samples) {}

    /// Lines are where the edges between what faces a point and what does not are seen, and nowhere else.
    void expectSilhouette(const std::vector<float>& plane, const glm::dvec3& from) const;

    AovFrame frame;
};

void BoxFrame::expectSilhouette(const std::vector<float>& plane, const glm::dvec3& from) const {
    // An edge of the box lies between two faces: along `axis`, at the sides a and b of the other two.
    struct Line {
        glm::dvec2 from, to;
    };
    std::vector<Line> seen;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-1.0, 1.0}) {
                const bool silhouette = (a * from[u] > 1.0) != (b * from[v] > 1.0);
                const bool visible = a * kEye[u] > 1.0 || b * kEye[v] > 1.0;
                if (!silhouette || !visible) continue;
                glm::dvec3 begin, end;
                begin[u] = end[u] = a;
                begin[v] = end[v] = b;
                begin[axis] = -1.0;
                end[axis] = 1.0;
                seen.push_back({frame.projected(begin), frame.projected(end)});
            }
        }
    }
    ASSERT_GE(seen.size(), 3u);
    int pixels = 0;
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        ASSERT_TRUE(plane[i] == 0.0f || plane[i] == 1.0f);
        if (plane[i] == 0.0f) continue;
        ++pixels;
        double nearest = 1e9;
        for (const Line& line : seen) {
            nearest = std::min(nearest, distanceToSegment(frame.placeOf(i), line.from, line.to));
        }
        EXPECT_LT(nearest, 1.0) << i % AovFrame::kWidth << ", " << i / AovFrame::kWidth;
    }
    EXPECT_GT(pixels, 100);
    for (const Line& line : seen) {
        for (double t = 0.05; t < 1.0; t += 0.05) {
            const glm::dvec2 at = glm::mix(line.from, line.to, t);
            bool found = false;
            for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
                found = found || (plane[i] == 1.0f && glm::distance(frame.placeOf(i), at) < 1.5);
            }
            EXPECT_TRUE(found) << "a gap at " << at.x << ", " << at.y;
        }
    }
}

TEST_P(AovPasses, SilhouettesAreTheEdgesBetweenLitAndUnlitFacesThatAreSeen) {
    const BoxFrame box(samples);
    box.expectSilhouette(box.frame.pixels.lights[0].aovs.find("silhouette")->second.values, BoxFrame::kLight);
}

TEST_P(AovPasses, ContoursAreTheEdgesBetweenFacesThatTheViewerSeesAndDoesNot) {
    const BoxFrame box(samples);
    box.expectSilhouette(box.frame.pixels.aovs.find("contour")->second.values, BoxFrame::kEye);
}

}  // namespace
}  // namespace umbrage::test
