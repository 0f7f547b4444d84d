// SPDX-License-Identifier: Apache-2.0
// What excuses a wrong sample and what does not, on geometry where the distance to every boundary is known. The
// tolerance is 1/128 pixel.
#include "judge/explain.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "stage.h"

namespace umbrage {
namespace {

constexpr double kWithin = 0.3 / 128, kBeyond = 3.0 / 128;

/// A square over x from -1 to 1, two metres up: the light that slants throws its shadow on x from 1 to 3.
const std::vector<Corners> kSquare = level(-1, -1, 1, 1, 2.0);
const PlacedLight kSlanting = directional({1, -1, 0});

class Eyes : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Both, Eyes, testing::Bool(),
                         [](const auto& test) { return test.param ? "Perspective" : "Orthographic"; });

TEST_P(Eyes, FarFromBoundariesAWrongMaskIsHard) {
    const Stage stage({kSquare}, GetParam());
    for (const auto& [x, z] : {std::pair(-3.0, 0.0), {-2.5, 2.5}, {3.5, 0.5}, {2.0, 1.5}, {0.3, 0.4}}) {
        SCOPED_TRACE(testing::Message() << x << ", " << z);
        ASSERT_TRUE(stage.exact(kSlanting, pixelOf(x), pixelOf(z)));
        EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(x), pixelOf(z)), SampleVerdict::FalseDark);
    }
    for (const auto& [x, z] : {std::pair(1.5, 0.0), {2.9, 0.9}, {2.5, -0.7}}) {
        SCOPED_TRACE(testing::Message() << x << ", " << z);
        ASSERT_FALSE(stage.exact(kSlanting, pixelOf(x), pixelOf(z)));
        EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(x), pixelOf(z)), SampleVerdict::FalseLit);
    }
}

TEST_P(Eyes, TheOutlineOfAShadowExcusesWithinTheToleranceOnly) {
    const Stage stage({kSquare}, GetParam());
    // Its right side and its far side, from inside and outside.
    for (const auto& [x, z, dx, dz] : {std::array{3.0, 0.37, 1.0, 0.0}, {2.21, 1.0, 0.0, 1.0}}) {
        for (const double side : {-1.0, 1.0}) {
            SCOPED_TRACE(testing::Message() << x << ", " << z << ", side " << side);
            const double px = pixelOf(x), pz = pixelOf(z);
            const double near = side * kWithin, off = side * kBeyond;
            ASSERT_EQ(stage.exact(kSlanting, px + near * dx, pz + near * dz), side > 0);
            ASSERT_EQ(stage.exact(kSlanting, px + off * dx, pz + off * dz), side > 0);
            EXPECT_EQ(stage.ofWrongMask(kSlanting, px + near * dx, pz + near * dz), SampleVerdict::Boundary);
            EXPECT_TRUE(isHard(stage.ofWrongMask(kSlanting, px + off * dx, pz + off * dz)));
            EXPECT_TRUE(stage.changesNearby(kSlanting, px + near * dx, pz + near * dz));
            EXPECT_FALSE(stage.changesNearby(kSlanting, px + off * dx, pz + off * dz));
        }
    }
}

TEST(Explainer, EdgesThatAreNoOutlineExcuseNothing) {
    const Stage stage({kSquare});
    // The shadow of the diagonal between the square's two triangles, and the ground's own diagonal.
    ASSERT_FALSE(stage.exact(kSlanting, pixelOf(2.25), pixelOf(0.25)));
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(2.25), pixelOf(0.25)), SampleVerdict::FalseLit);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(-2.25), pixelOf(-2.25)), SampleVerdict::FalseDark);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(-2.25) + kWithin, pixelOf(-2.25)), SampleVerdict::FalseDark);
}

TEST(Explainer, AnotherVisibleSurfaceExcusesWithinTheToleranceOnly) {
    const Stage stage({kSquare});
    // Right of the square's right side the ground is dark, left of it the square is lit.
    const double px = pixelOf(1.0), pz = pixelOf(0.37);
    const std::uint32_t ground = stage.seen(px + 1.0, pz), above = stage.seen(px - 1.0, pz);
    ASSERT_NE(ground, above);
    for (const std::uint32_t claimed : {ground, above}) {
        SCOPED_TRACE(claimed == ground ? "ground" : "square");
        EXPECT_EQ(stage.ofWrongMask(kSlanting, px + kWithin, pz, claimed), SampleVerdict::Primary);
        EXPECT_EQ(stage.ofWrongMask(kSlanting, px - kWithin, pz, claimed), SampleVerdict::Primary);
        EXPECT_EQ(stage.ofWrongMask(kSlanting, px + kBeyond, pz, claimed), SampleVerdict::FalseLit);
        EXPECT_EQ(stage.ofWrongMask(kSlanting, px - kBeyond, pz, claimed), SampleVerdict::FalseDark);
    }
}

TEST(Explainer, ClaimingASurfaceThatIsHiddenExcusesNothing) {
    const Stage stage({kSquare});
    // On the square; the ground beneath it is dark from x = 1 on, lit before.
    const double px = pixelOf(0.5), pz = pixelOf(0.2);
    const std::uint32_t ground = stage.seen(pixelOf(2.0), pixelOf(-0.5));
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px, pz, ground), SampleVerdict::FalseDark);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px, pz, kNothing), SampleVerdict::FalseDark);
}

TEST(Explainer, TheBackgroundIsNeverLit) {
    const Stage stage({});
    // The ground ends at 10 metres; the picture at 4.
    ASSERT_EQ(stage.seen(pixelOf(11.0), pixelOf(0.0)), kNothing);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(11.0), pixelOf(0.0)), SampleVerdict::FalseLit);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(10.0) + kWithin, pixelOf(0.0)), SampleVerdict::Primary);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(10.0) + kBeyond, pixelOf(0.0)), SampleVerdict::FalseLit);
}

TEST(Explainer, ALightInTheSurfacesPlaneIsGrazing) {
    const Stage stage({});
    for (const double sine : {0.0, 1e-6, -1e-6}) {
        EXPECT_EQ(stage.ofWrongMask(directional({1, -sine, 0}), 20.3, 30.7), SampleVerdict::Grazing) << sine;
        EXPECT_EQ(stage.ofWrongMask(pointLight({9.0, 10.0 * sine, 0}), 20.3, 30.7), SampleVerdict::Grazing) << sine;
    }
    EXPECT_EQ(stage.ofWrongMask(directional({1, -1e-4, 0}), 20.3, 30.7), SampleVerdict::FalseDark);
    EXPECT_EQ(stage.ofWrongMask(directional({1, 1e-4, 0}), 20.3, 30.7), SampleVerdict::FalseLit);
}

/// A sliver a thousandth of a pixel wide over x = -1.
const std::vector<Corners> kSliver = level(-1 - 0.0005 / 16.0, -1, -1 + 0.0005 / 16.0, 1, 2.0);

TEST_P(Eyes, AShadowThinnerThanTheRaysAroundASampleExcusesWithinTheToleranceOnly) {
    const Stage stage({kSliver}, GetParam());
    // Both throw it on x = 1.
    for (const PlacedLight& light : {kSlanting, pointLight({-3, 4, 0})}) {
        const double spread = light.light.type == LightType::Point ? 2.0 : 1.0;
        for (const double z : {-0.95, 0.41, 0.95}) {
            SCOPED_TRACE(testing::Message() << spread << ", " << z);
            const double px = pixelOf(1.0), pz = pixelOf(spread * z);
            EXPECT_FALSE(stage.exact(light, px, pz));
            EXPECT_EQ(stage.ofWrongMask(light, px, pz), SampleVerdict::Boundary);
            for (const double side : {-1.0, 1.0}) {
                EXPECT_EQ(stage.ofWrongMask(light, px + side * kWithin, pz), SampleVerdict::Boundary);
                EXPECT_EQ(stage.ofWrongMask(light, px + side * kBeyond, pz), SampleVerdict::FalseDark);
            }
        }
    }
}

TEST_P(Eyes, ASurfaceThinnerThanTheRaysAroundASampleMayBeSeenWithinTheToleranceOnly) {
    // As thin, and turned away from the light, over x = -3.
    constexpr double kHalf = 0.0005 / 16.0;
    const Stage stage(
        {square({-3 - kHalf, 4 * kHalf, -1}, {-3 - kHalf, 4 * kHalf, 1}, {-3 + kHalf, 0, 1}, {-3 + kHalf, 0, -1})},
        GetParam());
    const double px = pixelOf(-3.0), pz = pixelOf(0.41);
    const std::uint32_t sliver = stage.seen(px, pz);
    ASSERT_FALSE(stage.exact(kSlanting, px, pz));
    // Aside, where its own shadow does not fall.
    ASSERT_NE(stage.seen(px - kWithin, pz), sliver);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px - kWithin, pz, sliver), SampleVerdict::Primary);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px - kBeyond, pz, sliver), SampleVerdict::FalseDark);
}

TEST(Explainer, CastersBehindTheSurfaceOrBeyondTheLightExcuseNothing) {
    const Stage stage({level(-1, -1, 1, 1, -0.2), level(2, -1, 3.4, 1, 3.2)});
    const PlacedLight light = pointLight({3, 3, 0});
    // In line with the light and a side of the square below, and of the square above.
    for (const double x : {1.125, -3.0}) {
        ASSERT_TRUE(stage.exact(light, pixelOf(x), pixelOf(0.2)));
        EXPECT_EQ(stage.ofWrongMask(light, pixelOf(x), pixelOf(0.2)), SampleVerdict::FalseDark) << x;
    }
}

TEST(Explainer, ALightOnACasterExcusesNothingElsewhere) {
    const std::vector<Corners> wall = square({1, 2, -1}, {1, 2, 1}, {1, 3, 1}, {1, 3, -1});
    const Stage stage({kSquare, wall});
    for (const glm::dvec3& place :
         {glm::dvec3(1, 2, 0), {1, 2, 1}, {0.25, 2, 0.25}, {-1, 2, -0.5}, {1, 3, 0.5}, {1, 3, -1}}) {
        SCOPED_TRACE(testing::Message() << place.x << ", " << place.y << ", " << place.z);
        for (const auto& [x, z] : {std::pair(-3.0, 0.3), {-2.5, 2.6}, {3.5, 0.45}, {2.0, 1.7}, {1.9, -3.1}}) {
            const PlacedLight light = pointLight(place);
            const bool lit = stage.exact(light, pixelOf(x), pixelOf(z));
            EXPECT_EQ(stage.ofWrongMask(light, pixelOf(x), pixelOf(z)),
                      lit ? SampleVerdict::FalseDark : SampleVerdict::FalseLit)
                << x << ", " << z;
        }
    }
}

TEST_P(Eyes, BordersOfRangeAndConeExcuseWithinTheToleranceOnly) {
    const Stage stage({}, GetParam());
    // Both are circles on the ground around the origin.
    const std::array lights{pointLight({0, 3, 0}, 5.0f), spotLight({0, 3, 0}, {0, -1, 0}, std::atan(0.5))};
    const std::array radii{4.0, 3.0 * std::tan(double(lights[1].light.outerConeAngle))};
    for (std::size_t i = 0; i < 2; ++i) {
        for (const double angle : {0.0, 0.7, 2.9}) {
            SCOPED_TRACE(testing::Message() << (i ? "cone, " : "range, ") << angle);
            const auto at = [&](double beyond) {
                const double radius = 16.0 * radii[i] * 0.999999999 + beyond;
                return stage.ofWrongMask(lights[i], 64.0 + radius * std::cos(angle), 64.0 + radius * std::sin(angle));
            };
            EXPECT_EQ(at(kWithin), SampleVerdict::Boundary);
            EXPECT_EQ(at(-kWithin), SampleVerdict::Boundary);
            EXPECT_EQ(at(kBeyond), SampleVerdict::FalseLit);
            EXPECT_EQ(at(-kBeyond), SampleVerdict::FalseDark);
        }
    }
}

TEST_P(Eyes, WhereTheNearPlaneCutsASurfaceItExcusesWithinTheToleranceOnly) {
    // A ramp that rises through the near plane, 2 metres below the eye, over x = 0; it darkens the ground.
    const Stage stage({square({-6, 15, -3}, {-6, 15, 3}, {6, 21, 3}, {6, 21, -3})}, GetParam(), 2.0);
    const PlacedLight light = directional({0, -1, 0});
    const double pz = pixelOf(0.23);
    ASSERT_NE(stage.seen(64.0 - kBeyond, pz), stage.seen(64.0 + kBeyond, pz));
    ASSERT_TRUE(stage.exact(light, 64.0 - kBeyond, pz));
    ASSERT_FALSE(stage.exact(light, 64.0 + kBeyond, pz));
    EXPECT_FALSE(isHard(stage.ofWrongMask(light, 64.0 - kWithin, pz)));
    EXPECT_FALSE(isHard(stage.ofWrongMask(light, 64.0 + kWithin, pz)));
    EXPECT_EQ(stage.ofWrongMask(light, 64.0 - kBeyond, pz), SampleVerdict::FalseDark);
    EXPECT_EQ(stage.ofWrongMask(light, 64.0 + kBeyond, pz), SampleVerdict::FalseLit);
}

TEST(Explainer, CasterOnTheGroundExcusesAroundItsFootOnly) {
    // A fence that stands on the ground: its shadow begins where it does.
    const Stage stage({square({-1, 0, -1}, {-1, 0, 1}, {-1, 1, 1}, {-1, 1, -1})});
    const double px = pixelOf(-1.0), pz = pixelOf(0.31);
    EXPECT_TRUE(stage.exact(kSlanting, px - kBeyond, pz));
    EXPECT_FALSE(stage.exact(kSlanting, px + kBeyond, pz));
    EXPECT_FALSE(isHard(stage.ofWrongMask(kSlanting, px - kWithin, pz)));
    EXPECT_FALSE(isHard(stage.ofWrongMask(kSlanting, px + kWithin, pz)));
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px - kBeyond, pz), SampleVerdict::FalseDark);
    EXPECT_EQ(stage.ofWrongMask(kSlanting, px + kBeyond, pz), SampleVerdict::FalseLit);
}

TEST(Explainer, WithinDepthsRoundingASheetMayPassThroughTheGround) {
    // It rises above the ground from x = -1 on, by a tenth of a millimetre a metre.
    const Stage stage({square({-10, -9e-4, -10}, {-10, -9e-4, 10}, {8, 9e-4, 10}, {8, 9e-4, -10})});
    const double pz = pixelOf(0.3);
    EXPECT_FALSE(isHard(stage.ofWrongMask(kSlanting, pixelOf(-1.02), pz)));
    EXPECT_EQ(stage.ofWrongMask(kSlanting, pixelOf(-1.5), pz), SampleVerdict::FalseDark);
}

TEST(Explainer, WithinDepthsRoundingTheNearPlaneMayCutALevelSurface) {
    for (const bool perspective : {false, true}) {
        const double pixel = pixelOf(0.03);
        const PlacedLight light = directional({0, -1, 0});
        const Stage touching({level(-1, -1, 1, 1, 18.0 - 1e-8)}, perspective, 2.0);
        EXPECT_FALSE(isHard(touching.ofWrongMask(light, pixel, pixel)));
        const Stage clear({level(-1, -1, 1, 1, 18.0 - 1e-3)}, perspective, 2.0);
        EXPECT_EQ(clear.ofWrongMask(light, pixel, pixel), SampleVerdict::FalseDark);
    }
}

TEST(Explainer, ARangeThatJustMissesIsExcusedAtItsTipOnly) {
    const Stage stage({});
    const PlacedLight light = pointLight({0, 3, 0}, std::nextafter(3.0f, 0.0f));
    ASSERT_FALSE(stage.exact(light, 64.0, 64.0));
    EXPECT_EQ(stage.ofWrongMask(light, 64.0, 64.0), SampleVerdict::Boundary);
    EXPECT_EQ(stage.ofWrongMask(light, 64.5, 64.0), SampleVerdict::FalseLit);
}

TEST(Explainer, CountsAreExcusedWhereTheyChangeOnly) {
    const Stage stage({kSquare, level(-1, -1, 1, 1, 1.5)});
    const PlacedLight light = directional({2, -1, 0});
    // The upper square's shadow is over x from 3 to 5, the lower one's from 2 to 4.
    const double pz = pixelOf(0.33);
    EXPECT_TRUE(stage.explainsCount(light, pixelOf(3.5), pz, 2)) << "it is right";
    EXPECT_FALSE(stage.explainsCount(light, pixelOf(3.5), pz, 1));
    EXPECT_FALSE(stage.explainsCount(light, pixelOf(2.5), pz, 2));
    EXPECT_FALSE(stage.explainsCount(light, pixelOf(-3.5), pz, 1));
    EXPECT_TRUE(stage.explainsCount(light, pixelOf(3.0) - kWithin, pz, 2));
    EXPECT_TRUE(stage.explainsCount(light, pixelOf(3.0) + kWithin, pz, 1));
    EXPECT_FALSE(stage.explainsCount(light, pixelOf(3.0) - kBeyond, pz, 2));
    EXPECT_FALSE(stage.explainsCount(light, pixelOf(3.0) + kBeyond, pz, 1));
}

TEST(Explainer, ALightThatIsOffLightsNothing) {
    const Stage stage({kSquare});
    PlacedLight light = kSlanting;
    light.light.intensity = 0.0f;
    EXPECT_EQ(stage.ofWrongMask(light, pixelOf(-3.0), pixelOf(0.0)), SampleVerdict::FalseLit);
}

}  // namespace
}  // namespace umbrage
