// SPDX-License-Identifier: Apache-2.0
// The tile counter against brute force: counts of triangles between places and lights, whatever the eye, the light and
// the triangles.
#include "bench/tile_counter.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "error.h"

namespace umbrage {
namespace {

constexpr int kWidth = 150, kHeight = 101;  // neither whole tiles nor whole blocks

struct Soup {
    Eye eye;
    glm::dvec4 light{0.0};
    std::vector<TileCaster> casters;
    std::vector<double> inverseDepths;

    TileView view() const { return TileView(eye, kWidth, kHeight); }
    std::vector<TileVolume> volumes() const {
        std::vector<TileVolume> made;
        for (const TileCaster& caster : casters) made.push_back(tileVolume(caster, light, {}, eye, view()));
        return made;
    }
    TileCounts counted(int threads = 1) const { return countTiles(volumes(), inverseDepths, view(), true, threads); }
};

Eye eyeAt(const glm::dvec3& position, const glm::dvec3& target, bool perspective = true) {
    PlacedCamera placed;
    placed.camera.perspective = perspective;
    placed.camera.znear = 0.2;
    placed.camera.zfar = perspective ? 0.0 : 50.0;
    placed.worldFromCamera = glm::inverse(glm::lookAt(position, target, glm::dvec3(0.1, 1.0, 0.2)));
    return makeEye(placed, kWidth, kHeight);
}

/// Triangles, the light and the eye all over the place; what is seen is a wall at any distance, in steps.
Soup soup(unsigned seed, bool directional) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
    const auto point = [&] { return glm::dvec3(coordinate(random), coordinate(random), coordinate(random)); };
    Soup made;
    made.eye = eyeAt(1.5 * point(), point());
    made.light = glm::dvec4(point() * 2.0, directional ? 0.0 : 1.0);
    for (int c = 0; c < 4; ++c) {
        TileCaster& caster = made.casters.emplace_back();
        const glm::dvec3 center = point();
        std::vector<glm::dvec3> corners;
        for (int i = 0; i < 7; ++i) corners.push_back(center + 0.4 * point());
        for (int t = 0; t < 9; ++t) {
            CastingTriangle& triangle = caster.triangles.emplace_back();
            for (glm::dvec3& corner : triangle.corners) corner = corners[random() % corners.size()];
            triangle.mayBeUnseen = true;
        }
    }
    made.inverseDepths.resize(std::size_t(kWidth * kHeight));
    const double near = 0.3 + double(random() % 100) / 50.0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double wall = (x / 23 + y / 17) % 5 == 0 ? 0.0 : 1.0 / (near + double((x / 11) % 7));
            made.inverseDepths[std::size_t(y * kWidth + x)] = wall;
        }
    }
    return made;
}

/// How many triangles lie between a place and the light.
int layersOver(const Soup& soup, const glm::dvec3& place) {
    int layers = 0;
    const glm::dvec3 way = glm::dvec3(soup.light) - soup.light.w * place;
    for (const TileCaster& caster : soup.casters) {
        for (const CastingTriangle& triangle : caster.triangles) {
            const auto& [a, b, c] = triangle.corners;
            const glm::dvec3 n = glm::cross(b - a, c - a);
            const double distance = glm::dot(n, a - place) / glm::dot(n, way);
            if (!(distance > 0.0) || (soup.light.w != 0.0 && distance >= 1.0)) continue;
            const glm::dvec3 p = place + distance * way;
            const double u = glm::dot(n, glm::cross(b - a, p - a)), v = glm::dot(n, glm::cross(c - b, p - b)),
                         w = glm::dot(n, glm::cross(a - c, p - c));
            layers += u > 0.0 && v > 0.0 && w > 0.0;
        }
    }
    return layers;
}

class TileSoups : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Lights, TileSoups, testing::Bool(),
                         [](const auto& test) { return test.param ? "Directional" : "Point"; });

TEST_P(TileSoups, EveryMethodCountsTheTrianglesBetweenPlaceAndLight) {
    std::size_t shadowed = 0, places = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Soup soup = umbrage::soup(seed, GetParam());
        const TileCounts counts = soup.counted();
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            EXPECT_EQ(counts.methods[m].different, 0u) << kTileMethods[m].name << ", seed " << seed;
        }
        const TileView view = soup.view();
        std::size_t wrong = 0;
        for (int y = 0; y < kHeight; y += 3) {
            for (int x = 0; x < kWidth; x += 3) {
                const std::size_t i = std::size_t(y * kWidth + x);
                if (soup.inverseDepths[i] == 0.0) continue;
                const glm::dvec3 seen = view.ray(x, y) / soup.inverseDepths[i];
                const glm::dvec3 place(soup.eye.worldFromView * glm::dvec4(seen.x, -seen.y, -seen.z, 1.0));
                const int layers = layersOver(soup, place);
                wrong += counts.layers[i] != layers;
                shadowed += layers > 0;
                ++places;
            }
        }
        EXPECT_EQ(wrong, 0u) << "seed " << seed;
    }
    EXPECT_GT(shadowed, places / 50);
}

TEST_P(TileSoups, NoChoiceForEachTileAndCasterLeavesFewerPixelsThanTheCheaper) {
    std::uint64_t all = 0, allBounded = 0, allUnbounded = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const TileCounts counts = soup(seed, GetParam()).counted();
        std::uint64_t best = 0, bestWhole = 0;
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            if (kTileMethods[m].name == "best") best = counts.methods[m].pixels;
            if (kTileMethods[m].name == "best/H") bestWhole = counts.methods[m].pixels;
            if (kTileMethods[m].name == "ZF+DB") allBounded += counts.methods[m].pixels;
            if (kTileMethods[m].name == "ZF") allUnbounded += counts.methods[m].pixels;
        }
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            if (kTileMethods[m].depthBounds || kTileMethods[m].wholeTiles) continue;
            EXPECT_LE(best, counts.methods[m].pixels) << kTileMethods[m].name;
        }
        EXPECT_LE(bestWhole, best);
        all += bestWhole;
    }
    EXPECT_GT(all, 0u);
    EXPECT_LT(allBounded, allUnbounded);
}

TEST_P(TileSoups, ThreadsChangeNothing) {
    const Soup made = soup(5, GetParam());
    const TileCounts one = made.counted(1), three = made.counted(3);
    EXPECT_EQ(one.layers, three.layers);
    EXPECT_EQ(one.processed, three.processed);
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        EXPECT_EQ(one.methods[m].pixels, three.methods[m].pixels);
        EXPECT_EQ(one.methods[m].updates, three.methods[m].updates);
    }
}

TEST_P(TileSoups, PixelsProcessedAreThoseOfThePlanes) {
    const TileCounts counts = soup(7, GetParam()).counted();
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        if (kTileMethods[m].wholeTiles) continue;
        std::uint64_t sum = 0;
        for (const std::uint16_t often : counts.processed[m]) sum += often;
        EXPECT_EQ(sum, counts.methods[m].pixels) << kTileMethods[m].name;
    }
}

/// A square before a wall at distance 10 in a light along the view: everything is known.
TEST(TileCounter, ASquareBeforeAWallIsCountedAsOnPaper) {
    Soup made;
    made.eye = eyeAt({0, 0, 0}, {0, 0, -1});
    made.eye.viewFromWorld = made.eye.worldFromView = glm::dmat4(1.0);
    made.light = {0, 0, 1, 0};
    TileCaster& caster = made.casters.emplace_back();
    const glm::dvec3 a(-1, -1, -5), b(1, -1, -5), c(1, 1, -5), d(-1, 1, -5);
    caster.triangles = {{{a, b, c}, false, true}, {{a, c, d}, false, true}};
    made.inverseDepths.assign(std::size_t(kWidth * kHeight), 0.1);
    const TileCounts counts = made.counted();
    // On the wall the shadow is as large as the square, on screen half as large. View rays enter the volume through
    // the square; in the frame around the shadow they leave it through a side before the wall, elsewhere behind it.
    const TileView view = made.view();
    std::uint64_t inside = 0, around = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::dvec3 ray = glm::abs(view.ray(x, y));
            const double reach = 10.0 * std::max(ray.x, ray.y);
            inside += reach < 1.0;
            around += reach > 1.0 && reach < 2.0;
            EXPECT_EQ(counts.layers[std::size_t(y * kWidth + x)], reach < 1.0);
        }
    }
    EXPECT_GT(inside, 50u);
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        EXPECT_EQ(counts.methods[m].different, 0u) << kTileMethods[m].name;
        if (kTileMethods[m].name == "ZP") {
            EXPECT_EQ(counts.methods[m].updates, inside + 2 * around);
        }
        if (kTileMethods[m].name == "ZF") {
            EXPECT_EQ(counts.methods[m].updates, inside);
        }
    }
}

TEST(TileCounter, RefusesOrthographicEyes) {
    EXPECT_THROW(TileView(eyeAt({0, 0, 5}, {0, 0, 0}, false), kWidth, kHeight), Error);
}

}  // namespace
}  // namespace umbrage
