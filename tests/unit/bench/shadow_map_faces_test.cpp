// SPDX-License-Identifier: Apache-2.0
#include "bench/shadow_map_faces.h"

#include <gtest/gtest.h>

#include <random>

#include "shadow/extent.h"

namespace umbrage {
namespace {

constexpr double kPi = 3.14159265358979;

/// Where a point lies on a face: x and y from -1 to 1, and its depth, greater where it is nearer to the light.
glm::dvec3 placeOn(const Eye& face, const glm::dvec3& world) {
    const glm::dvec4 clip = face.clipFromView * (face.viewFromWorld * glm::dvec4(world, 1.0));
    return {VIEWPORT_SCALE * glm::dvec2(clip) / clip.w, clip.z / clip.w};
}

bool isOn(const Eye& face, const glm::dvec3& world) {
    const glm::dvec4 clip = face.clipFromView * (face.viewFromWorld * glm::dvec4(world, 1.0));
    const glm::dvec3 place = placeOn(face, world);
    return clip.w > 0.0 && std::abs(place.x) <= 1.0 && std::abs(place.y) <= 1.0;
}

struct Hall {
    std::vector<Geometry::Bounds> boxes{
        {{-10, 0, -10}, {10, 0.1, 10}}, {{-1, 0, -1}, {1, 2, 1}}, {{8, 0, 8}, {9, 9, 9}}};
    std::vector<bool> unseen{false, false, true};
    PlacedLight light;
    Eye eye;

    Hall() {
        PlacedCamera camera;
        camera.camera.yfov = 0.6;
        camera.camera.znear = 0.1;
        camera.worldFromCamera = glm::inverse(glm::lookAt(glm::dvec3(0, 3, 12), glm::dvec3(0), glm::dvec3(0, 1, 0)));
        eye = makeEye(camera, 64, 48);
        light.position = {3, 5, 1};
        light.direction = glm::normalize(glm::dvec3(-0.3, -1.0, 0.2));
    }
    std::vector<Eye> faces() const { return shadowMapFaces(light, boxes, unseen, eye); }
};

TEST(ShadowMapFaces, OfAPointLightHoldEveryDirectionOnceInTheirOrder) {
    Hall hall;
    hall.light.light.type = LightType::Point;
    const std::vector<Eye> faces = hall.faces();
    ASSERT_EQ(faces.size(), 6u);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 d(normal(random), normal(random), normal(random));
        const glm::dvec3 a = glm::abs(d);
        const int axis = a.x > a.y && a.x > a.z ? 0 : a.y > a.z ? 1 : 2;
        for (int f = 0; f < 6; ++f) {
            EXPECT_EQ(isOn(faces[std::size_t(f)], hall.light.position + d), f == 2 * axis + (d[axis] < 0.0));
        }
    }
}

TEST(ShadowMapFaces, OfASpotLightHoldItsConeAndLittleMore) {
    Hall hall;
    hall.light.light.type = LightType::Spot;
    hall.light.light.outerConeAngle = float(kPi / 6);
    const std::vector<Eye> faces = hall.faces();
    ASSERT_EQ(faces.size(), 1u);
    const glm::dvec3 across = glm::normalize(glm::cross(hall.light.direction, glm::dvec3(1, 0, 0)));
    const auto at = [&](double angle) {
        return hall.light.position + std::cos(angle) * hall.light.direction + std::sin(angle) * across;
    };
    EXPECT_TRUE(isOn(faces[0], at(0.999 * kPi / 6)));
    EXPECT_FALSE(isOn(faces[0], at(kPi / 3.9)));
    EXPECT_GT(placeOn(faces[0], at(0.0)).z, placeOn(faces[0], hall.light.position + 2.0 * hall.light.direction).z);
    hall.light.light.outerConeAngle = 1.5f;
    EXPECT_EQ(hall.faces().size(), 6u);
}

TEST(ShadowMapFaces, OfADirectionalLightHoldWhatIsSeenAndAllThatCastsOnIt) {
    Hall hall;
    hall.light.light.type = LightType::Directional;
    const std::vector<Eye> faces = hall.faces();
    ASSERT_EQ(faces.size(), 1u);
    const std::array<HalfSpace, 4> sides = sidesOfView(hall.eye);
    int seen = 0;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> along(-10.0, 10.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p(along(random), 0.0, along(random));
        if (outOfView(cornersOf({p, p}), sides)) continue;
        ++seen;
        EXPECT_TRUE(isOn(faces[0], p));
        const double depth = placeOn(faces[0], p).z;
        EXPECT_GE(depth, 0.0);
        EXPECT_GT(placeOn(faces[0], p - hall.light.direction).z, depth);
    }
    EXPECT_GT(seen, 50);
    EXPECT_LT(seen, 950);
    // Fitted: what is far out of view is not on it.
    EXPECT_FALSE(isOn(faces[0], {9.9, 0.0, 9.9}));
    hall.unseen.assign(3, true);
    EXPECT_TRUE(hall.faces().empty());
}

}  // namespace
}  // namespace umbrage
