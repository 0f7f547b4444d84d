// SPDX-License-Identifier: Apache-2.0
// Counts of soups of triangles against the definition: triangles between a point and the light, one by one.
#include "tiles/tile_counter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbrage {
namespace {

using glm::dvec3;
using glm::dvec4;

struct Soup {
    TileEye eye;
    dvec4 light{0.0};                             // view space
    std::vector<std::array<dvec3, 3>> triangles;  // view space
    std::vector<double> depths;                   // of what each pixel sees, as the counter has them
};

Soup randomSoup(unsigned seed, bool perspective, bool directional) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Soup soup;
    soup.eye.width = 131, soup.eye.height = 77;  // no whole blocks, nor tiles
    soup.eye.rayScale = perspective ? glm::dvec2(0.8, 0.5) : glm::dvec2(6.0, 3.5);
    soup.eye.perspective = perspective;
    soup.light = directional ? dvec4(unit(random), unit(random), unit(random), 0.0)
                             : dvec4(4.0 * unit(random), 4.0 * unit(random), -8.0 + 4.0 * unit(random), 1.0);
    for (int t = 0; t < 40; ++t) {
        const dvec3 center(5.0 * unit(random), 4.0 * unit(random), -8.0 + 7.0 * unit(random));
        const auto corner = [&] { return center + 2.0 * dvec3(unit(random), unit(random), unit(random)); };
        soup.triangles.push_back({corner(), corner(), corner()});
    }
    for (int i = 0; i < soup.eye.width * soup.eye.height; ++i) {
        const double distance = 8.0 + 6.0 * unit(random);
        soup.depths.push_back(perspective ? 1.0 / distance : -distance);
    }
    return soup;
}

double det(const dvec3& a, const dvec3& b, const dvec3& c) {
    return glm::dot(glm::cross(a, b), c);
}

/// 1 if the triangle lies between p and the light, 0 if not, -1 where that is nearly undecided.
int between(const std::array<dvec3, 3>& t, const dvec3& p, const dvec4& light) {
    const dvec3 d = light.w != 0.0 ? dvec3(light) - p : dvec3(light);
    const dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    // Caps are pushed back by 1/256 pixel along their slope.
    if (std::abs(glm::dot(n, p - t[0])) < 1e-3 * glm::length(n)) return -1;
    const double slope = glm::dot(n, d), at = glm::dot(n, t[0] - p) / slope;
    double least = 1.0, most = -1.0;
    const double scale = glm::length(n) * glm::length(d);
    for (std::size_t i = 0; i < 3; ++i) {
        const double inside = det(d, t[i] - p, t[(i + 1) % 3] - p) / scale * (slope > 0.0 ? 1.0 : -1.0);
        least = std::min(least, inside);
        most = std::max(most, inside);
    }
    constexpr double kNear = 1e-4;
    const double end = light.w != 0.0 ? 1.0 : HUGE_VAL;
    if (least < -kNear || at < -kNear || at > end + kNear) return 0;
    return least > kNear && at > kNear && at < end - kNear ? 1 : -1;
}

dvec3 seenAt(const Soup& soup, int x, int y) {
    const glm::dvec2 ndc(2.0 * (x + 0.5) / soup.eye.width - 1.0, 1.0 - 2.0 * (y + 0.5) / soup.eye.height);
    const double depth = soup.depths[std::size_t(y) * std::size_t(soup.eye.width) + std::size_t(x)];
    const glm::dvec2 ray = ndc * soup.eye.rayScale;
    if (!soup.eye.perspective) return {ray, depth};
    return dvec3(ray, -1.0) / depth;
}

/// Triangles between the light and where view rays begin.
int layersOverEye(const Soup& soup) {
    int layers = 0;
    if (!soup.eye.perspective) {
        if (soup.light.w == 0.0) return 0;  // an infinite end of parallel rays
        for (const auto& t : soup.triangles) layers += between(t, dvec3(soup.light), {0.0, 0.0, 1.0, 0.0}) == 1;
        return layers;
    }
    for (const auto& t : soup.triangles) layers += between(t, dvec3(0.0), soup.light) == 1;
    return layers;
}

TileLight lightOf(const Soup& soup) {
    TileLight light;
    light.start = layersOverEye(soup);
    for (const std::array<dvec3, 3>& t : soup.triangles) {
        const dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
        const int facing = glm::dot(n, dvec3(soup.light) - soup.light.w * t[0]) > 0.0 ? 1 : -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto side = tileSide(soup.eye, t[i], t[(i + 1) % 3], {soup.light}, facing);
            if (side) light.polygons.push_back(*side);
        }
        if (const auto cap = tileCap(soup.eye, t, facing)) light.polygons.push_back(*cap);
    }
    return light;
}

SeenTiles seenOf(const Soup& soup) {
    const std::size_t pixels = soup.depths.size();
    std::vector<std::uint32_t> triangles(pixels, 0);
    std::vector<float> depths(soup.depths.begin(), soup.depths.end());
    const glm::vec4 nowhere(0.0f);  // a plane without a normal is off the depth buffer everywhere
    const glm::uvec2 facing(1u);
    SeenPicture picture;
    picture.triangles = triangles;
    picture.depths = depths;
    picture.noTriangle = 1;
    picture.emptyDepth = HUGE_VALF;
    picture.planes = {&nowhere, 1};
    picture.facing = {&facing, 1};
    SeenTiles seen(soup.eye.width, soup.eye.height);
    seen.set(picture, soup.eye);
    return seen;
}

std::vector<std::int32_t> countsOf(const Soup& soup, CountBand* countBand) {
    const SeenTiles seen = seenOf(soup);
    TileCounter counter(countBand);
    std::vector<std::int32_t> rows(seen.pixelsOfPicture());
    seen.toRows(counter.countsOf(seen, lightOf(soup)).data(), rows.data());
    return rows;
}

class Counter : public testing::TestWithParam<std::tuple<bool, bool>> {};

TEST_P(Counter, CountsTheTrianglesBetweenWhatIsSeenAndTheLight) {
    const auto [perspective, directional] = GetParam();
    std::size_t decided = 0, shadowed = 0, wrong = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Soup soup = randomSoup(seed, perspective, directional);
        const std::vector<std::int32_t> counts = countsOf(soup, countBandHere());
        for (int y = 0; y < soup.eye.height; ++y) {
            for (int x = 0; x < soup.eye.width; ++x) {
                int layers = 0;
                bool certain = true;
                for (const auto& t : soup.triangles) {
                    const int hit = between(t, seenAt(soup, x, y), soup.light);
                    certain = certain && hit >= 0;
                    layers += hit == 1;
                }
                if (!certain) continue;
                ++decided;
                shadowed += layers != 0;
                wrong += counts[std::size_t(y) * std::size_t(soup.eye.width) + std::size_t(x)] != layers;
            }
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(decided, 100000u);
    EXPECT_GT(shadowed, 10000u);
}

TEST_P(Counter, GivesTheSameBitsByEveryInstructionSet) {
    const auto [perspective, directional] = GetParam();
    std::vector<CountBand*> sets{countBandBaseline};
    if (__builtin_cpu_supports("avx2")) sets.push_back(countBandAvx2);
    if (countBandHere() == countBandAvx512) sets.push_back(countBandAvx512);
    if (sets.size() < 2) GTEST_SKIP() << "this processor has only one";
    for (unsigned seed = 20; seed < 25; ++seed) {
        const Soup soup = randomSoup(seed, perspective, directional);
        const std::vector<std::int32_t> counts = countsOf(soup, sets[0]);
        for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_EQ(countsOf(soup, sets[i]), counts) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Eyes, Counter, testing::Combine(testing::Bool(), testing::Bool()), [](const auto& parameters) {
    return std::string(std::get<0>(parameters.param) ? "perspective" : "orthographic") +
           (std::get<1>(parameters.param) ? "_directional" : "_point");
});

/// What is marked is what is counted; nothing where no light can matter.
TEST(TileCounter, MarksOnlyWhatALightMayLight) {
    const Soup soup = randomSoup(40, true, false);
    const std::vector<std::int32_t> counts = countsOf(soup, countBandHere());
    const SeenTiles seen = seenOf(soup);
    TileCounter counter;
    std::vector<TileLight> lights(2, lightOf(soup));
    lights[1].bit = 4;  // which nothing faces
    std::vector<std::uint32_t> dark(seen.pixelsOfPicture());
    seen.toRows(counter.count(seen, lights).data(), dark.data());
    for (std::size_t i = 0; i < dark.size(); ++i) EXPECT_EQ(dark[i], counts[i] != 0 ? 1u : 0u);
    EXPECT_GT(counter.work().tiles, 0u);
}

/// Two quads share an edge that runs exactly through samples: each belongs to one of them, and to the one that `ties`
/// says.
TEST(TilePolygon, LeavesASharedBorderToOneOfBoth) {
    for (const double sign : {1.0, -1.0}) {
        TileEye eye;
        eye.width = eye.height = 64;
        eye.rayScale = {32.0, 32.0};  // a metre a pixel
        eye.perspective = false;
        eye.ties = {sign, sign};
        // A sheet across the picture, lit from above: sides run away from the viewer, so look from below ... seen along
        // z.
        const dvec3 left(-20.0, 0.5, -5.0), middle(0.5, 0.5, -5.0), right(20.0, 0.5, -5.0);
        const dvec4 light(0.0, 1.0, 0.01, 0.0);
        TileLight lit;
        lit.polygons = {*tileSide(eye, left, middle, {light}, 1), *tileSide(eye, middle, right, {light}, 1)};
        SeenPicture picture;
        const std::vector<std::uint32_t> triangles(64 * 64, 0);
        const std::vector<float> depths(64 * 64, -1000.0f);
        const glm::vec4 nowhere(0.0f);
        const glm::uvec2 facing(1u);
        picture.triangles = triangles, picture.depths = depths, picture.noTriangle = 1;
        picture.planes = {&nowhere, 1}, picture.facing = {&facing, 1};
        SeenTiles seen(64, 64);
        seen.set(picture, eye);
        TileCounter counter;
        std::vector<std::int32_t> rows(64 * 64);
        seen.toRows(counter.countsOf(seen, lit).data(), rows.data());
        for (int y = 0; y < 64; ++y) {
            // Row 31 has its samples at a height of 0.5, on the upper border; column 32 at 0.5, on the border of both.
            const bool below = y > 31 || (y == 31 && sign > 0.0);
            EXPECT_EQ(std::abs(rows[std::size_t(y * 64 + 32)]), below ? 1 : 0) << y << " " << sign;
            EXPECT_EQ(rows[std::size_t(y * 64 + 32)], rows[std::size_t(y * 64 + 20)]) << y << " " << sign;
        }
    }
}

}  // namespace
}  // namespace umbrage
