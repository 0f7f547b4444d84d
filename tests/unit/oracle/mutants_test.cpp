// SPDX-License-Identifier: Apache-2.0
// What a scene's picture depends on really shows in it: the tests' scenes can tell a wrong facing, a missing triangle
// and a light that stands elsewhere.
#include <gtest/gtest.h>

#include "pictures.h"

namespace umbrage::oracle {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const glm::dvec4 kLight(3, 9, 2, 1);

std::vector<Triangle> scene() {
    std::vector<Corners> things = box({-1, 1.5, -0.75}, {1, 2.75, 1.5});
    append(things, moved(icosphere(1), [](const glm::dvec3& p) { return p + glm::dvec3(-2.5, 1.5, 1.5); }));
    std::vector<Triangle> triangles = overGround(things);
    for (Triangle& t : triangles) t.singleSided = true;
    return triangles;
}

/// Pixels whose answer (or whose seen triangle, where asked for) differs.
int difference(const std::vector<Triangle>& a, const std::vector<Triangle>& b, const glm::dvec4& lightA,
               const glm::dvec4& lightB) {
    const EyeRays rays(cameraAt({1.5, 8, 9}, {0, 0, 0}, true), kWidth, kHeight);
    const std::vector<Pixel> one = picture(Oracle(a), rays, kWidth, kHeight, lightA);
    const std::vector<Pixel> other = picture(Oracle(b), rays, kWidth, kHeight, lightB);
    int different = 0;
    for (std::size_t i = 0; i < one.size(); ++i) different += one[i].answer != other[i].answer;
    return different;
}

TEST(Mutants, NothingChangesWhereNothingIsChanged) {
    EXPECT_EQ(difference(scene(), scene(), kLight, kLight), 0);
}

TEST(Mutants, AReceiverTurnedOverIsNoLongerSeen) {
    std::vector<Triangle> mutant = scene();
    std::swap(mutant[0].corners[1], mutant[0].corners[2]);
    EXPECT_GT(difference(scene(), mutant, kLight, kLight), 1000);
}

TEST(Mutants, ATwoSidedCasterTurnedOverCastsTheSame) {
    std::vector<Triangle> original = scene(), mutant;
    for (Triangle& t : original) t.singleSided = false;
    mutant = original;
    for (std::size_t i = 2; i < mutant.size(); i += 3) std::swap(mutant[i].corners[1], mutant[i].corners[2]);
    EXPECT_EQ(difference(original, mutant, kLight, kLight), 0);
}

TEST(Mutants, OneTriangleLessOfAClosedCasterCastsTheSame) {
    // Each way to the light passes two faces of it: one alone still casts.
    std::vector<Triangle> original = scene();
    for (std::size_t i = 2; i < original.size(); ++i) original[i].visible = false;
    for (std::size_t i = 2; i < original.size(); i += 9) {
        std::vector<Triangle> mutant = original;
        mutant[i].casts = false;
        EXPECT_EQ(difference(original, mutant, kLight, kLight), 0) << "triangle " << i;
    }
}

TEST(Mutants, AnOpenedCasterHasAHoleInItsShadow) {
    // Without the two triangles of the box's bottom and one of its top.
    std::vector<Triangle> original = scene(), mutant = original;
    for (std::size_t i = 0; i < mutant.size(); ++i) {
        const Corners& t = mutant[i].corners;
        const bool bottom = t[0].y == 1.5 && t[1].y == 1.5 && t[2].y == 1.5;
        if (bottom) original[i].casts = mutant[i].casts = false;
    }
    for (std::size_t i = 2; i < mutant.size(); ++i) {
        const Corners& t = mutant[i].corners;
        if (t[0].y == 2.75 && t[1].y == 2.75 && t[2].y == 2.75) {
            mutant[i].casts = false;
            break;
        }
    }
    EXPECT_GT(difference(original, mutant, kLight, kLight), 100);
}

TEST(Mutants, ATriangleTakenFromAClosedCasterIsSeenToBeMissing) {
    for (std::size_t i : {2u, 8u, 9u}) {
        std::vector<Triangle> mutant = scene();
        mutant.erase(mutant.begin() + std::ptrdiff_t(i));
        const EyeRays rays(cameraAt({1.5, 8, 9}, {0, 0, 0}, true), kWidth, kHeight);
        const Oracle one(scene()), other(mutant);
        std::uint64_t layers = 0, fewer = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const EyeRay ray = rays.at(x + 0.5, y + 0.5);
                const std::uint32_t seen = one.see(ray);
                if (!isGround(seen) || other.see(ray) != seen) continue;
                layers += one.layersBefore(kLight, seen, ray);
                fewer += other.layersBefore(kLight, seen, ray);
            }
        }
        EXPECT_LT(fewer, layers) << "triangle " << i;
    }
}

TEST(Mutants, AMillimetreOfTheLightShows) {
    EXPECT_GT(difference(scene(), scene(), kLight, kLight + glm::dvec4(1e-3, 0, 0, 0)), 0);
    EXPECT_GT(difference(scene(), scene(), kLight, kLight + glm::dvec4(0, 0, 1e-3, 0)), 0);
    EXPECT_GT(difference(scene(), scene(), {0.4, 1, -0.3, 0}, {0.401, 1, -0.3, 0}), 0);
}

}  // namespace
}  // namespace umbrage::oracle
