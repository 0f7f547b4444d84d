// SPDX-License-Identifier: Apache-2.0
// Where volumes may end and which are out of view, against points drawn at random.
#include "shadow/extent.h"

#include <gtest/gtest.h>

#include <random>

namespace umbrage {
namespace {

/// Random boxes, lights and eyes.
class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}

    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    glm::dvec3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    Geometry::Bounds box(double size) {
        const glm::dvec3 centre = point(size), half(number(0, 1), number(0, 1), number(0, 1));
        return {centre - half, centre + half};
    }
    glm::dvec3 in(const Geometry::Bounds& box) {
        return glm::mix(box.low, box.high, glm::dvec3(number(0, 1), number(0, 1), number(0, 1)));
    }
    ShadowLight light() {
        return number(0, 1) < 0.3 ? ShadowLight(glm::normalize(point(1)), 0) : ShadowLight(point(8), 1);
    }
    /// Of a light at a place: some with a range, some with a cone, some with both.
    LightReach reach(const ShadowLight& light) {
        LightReach reach{light};
        if (light.w == 0.0) return reach;
        if (number(0, 1) < 0.3) reach.rangeMetres = number(1, 12);
        if (number(0, 1) < 0.4) {
            reach.axis = glm::normalize(point(1));
            reach.coneAngle = number(0.01, 0.5 * std::numbers::pi);
        }
        return reach;
    }
    Eye eye() {
        PlacedCamera camera;
        camera.camera.perspective = number(0, 1) < 0.7;
        camera.camera.yfov = 0.8;
        camera.camera.ymag = 3.0;
        camera.camera.znear = 0.1;
        camera.camera.zfar = 30.0;
        const glm::dvec3 z = glm::normalize(point(1)), x = glm::normalize(glm::cross(z, point(1)));
        camera.worldFromCamera =
            glm::dmat4(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(point(6), 1));
        return makeEye(camera, 64, 48);
    }

private:
    std::mt19937 random_;
};

bool isReached(const glm::dvec3& p, const LightReach& reach) {
    if (reach.light.w == 0.0) return true;
    const glm::dvec3 towards = p - glm::dvec3(reach.light);
    const double distance = glm::length(towards);
    return (reach.rangeMetres == 0.0 || distance <= reach.rangeMetres) &&
           (reach.coneAngle > 3.0 || glm::dot(towards, reach.axis) >= distance * std::cos(reach.coneAngle));
}

TEST(LightExtent, NoViewRayToAReceiverMeetsWhatLiesBehindAnEnd) {
    Draw draw(3);
    int ended = 0, ranged = 0, spots = 0;
    for (int scene = 0; scene < 3000; ++scene) {
        const std::array<Geometry::Bounds, 3> boxes{draw.box(5), draw.box(5), draw.box(5)};
        const ShadowLight light = draw.light();
        const Eye eye = draw.eye();
        const LightReach reach = draw.reach(light);
        const LightExtent extent(boxes, reach, eye);
        if (outOfReach(boxes[0], reach)) continue;
        const std::uint32_t end = extent.endOf(cornersOf(boxes[0]));
        if (end == 0) continue;
        ++ended;
        ranged += reach.rangeMetres > 0.0;
        spots += reach.coneAngle < std::numbers::pi;
        const glm::vec4 face = extent.facesInView(eye)[end - 1];
        const auto behind = [&](const glm::dvec3& p) {
            return glm::dot(glm::dvec3(face), glm::dvec3(eye.viewFromWorld * glm::dvec4(p, 1.0))) - double(face.w);
        };
        // Every ray of the light through the caster gets there.
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 p = draw.in(boxes[0]), away = p * light.w - glm::dvec3(light);
            EXPECT_GT(glm::dot(glm::dvec3(face), glm::dmat3(eye.viewFromWorld) * away), 0.0);
            EXPECT_LT(behind(p), 0.0);
        }
        // Nothing in range, and no view ray to it, lies behind.
        for (int i = 0; i < 24; ++i) {
            const glm::dvec3 receiver = draw.in(boxes[std::size_t(i) % 3]);
            if (!isReached(receiver, reach)) continue;
            const glm::dvec3 from =
                eye.perspective ? eye.position() : receiver + draw.number(0, 50) * glm::dvec3(eye.point());
            EXPECT_LT(behind(glm::mix(from, receiver, draw.number(0, 1))), 0.0);
        }
    }
    EXPECT_GT(ended, 500);
    EXPECT_GT(ranged, 50);
    EXPECT_GT(spots, 50);
}

TEST(OutOfReach, NoPointOfTheBoxIsReached) {
    Draw draw(7);
    int out = 0, outOfCone = 0;
    for (int scene = 0; scene < 3000; ++scene) {
        const Geometry::Bounds box = draw.box(5);
        const LightReach reach = draw.reach(draw.light());
        if (!outOfReach(box, reach)) continue;
        ++out;
        outOfCone += !outOfReach(box, {.light = reach.light, .rangeMetres = reach.rangeMetres});
        for (int i = 0; i < 64; ++i) EXPECT_FALSE(isReached(draw.in(box), reach));
    }
    EXPECT_GT(out, 300);
    EXPECT_GT(outOfCone, 100);
    const LightReach down{.light = {0, 6, 0, 1}, .axis = {0, -1, 0}, .coneAngle = 0.3};
    EXPECT_TRUE(outOfReach({{-1, 8, -1}, {1, 9, 1}}, down)) << "behind a spot";
    EXPECT_FALSE(outOfReach({{-1, 0, -1}, {1, 1, 1}}, down)) << "before it";
    EXPECT_EQ(boxOf(down).high.y, 6.0) << "nothing above a spot that shines down";
}

TEST(LightExtent, TheShortestWayOutIsTaken) {
    const Geometry::Bounds ground{{-10, -0.1, -10}, {10, 0, 10}}, caster{{-1, 1, -1}, {1, 2, 1}};
    const std::array<Geometry::Bounds, 2> boxes{ground, caster};
    Eye eye;
    eye.worldFromView[3] = {0, 2, 9, 1};
    eye.viewFromWorld = glm::inverse(eye.worldFromView);
    const LightExtent extent(boxes, {{0, 6, 0, 1}}, eye);
    const glm::vec4 face = extent.facesInView(eye)[extent.endOf(cornersOf(caster)) - 1];
    EXPECT_EQ(glm::vec3(face), glm::vec3(0, -1, 0));
    EXPECT_EQ(extent.endOf(cornersOf({{-1, 5, -1}, {1, 7, 1}})), 0u) << "the light is inside: rays leave on all sides";
}

TEST(OutOfView, NoPointOfTheVolumeIsInView) {
    Draw draw(5);
    int out = 0;
    for (int scene = 0; scene < 3000; ++scene) {
        const Geometry::Bounds box = draw.box(5);
        const ShadowLight light = draw.light();
        const Eye eye = draw.eye();
        if (!outOfView(cornersOf(box), light, sidesOfView(eye))) continue;
        ++out;
        for (int i = 0; i < 64; ++i) {
            const glm::dvec3 p = draw.in(box), away = p * light.w - glm::dvec3(light);
            const glm::dvec3 q(eye.viewFromWorld * glm::dvec4(p + draw.number(0, 20) * away, 1.0));
            const double depth = eye.perspective ? -q.z : 1.0;
            const bool seen =
                depth > 0.0 && std::abs(q.x) <= eye.rayScale.x * depth && std::abs(q.y) <= eye.rayScale.y * depth;
            EXPECT_FALSE(seen);
        }
    }
    EXPECT_GT(out, 300);
}

}  // namespace
}  // namespace umbrage
