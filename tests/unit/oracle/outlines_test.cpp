// SPDX-License-Identifier: Apache-2.0
// Shadows whose outlines are known: every pixel farther from them than kMargin must be right.
#include <gtest/gtest.h>

#include <numbers>

#include "pictures.h"

namespace umbrage::oracle {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr double kMargin = 1e-9;  // metres, on the thing

/// Point and directional lights, eyes of both projections.
class Outlines : public testing::Test {
protected:
    const std::vector<glm::dvec4> lights{{3, 9, 2, 1}, {-1.5, 4.5, 0.25, 1}, {0.4, 1, -0.3, 0}, {0, 1, 0, 0}};
    const std::vector<PlacedCamera> cameras{cameraAt({1.5, 8, 9}, {0, 0, 0}, true),
                                            cameraAt({1.5, 8, 9}, {0, 0, 0}, false),
                                            cameraAt({-4, 1.2, 0.5}, {0, 0.5, 0}, true)};

    template <class Body>
    void forEachView(Body&& body) {
        for (std::size_t c = 0; c < cameras.size(); ++c) {
            for (std::size_t l = 0; l < lights.size(); ++l) {
                SCOPED_TRACE("camera " + std::to_string(c) + ", light " + std::to_string(l));
                body(EyeRays(cameras[c], kWidth, kHeight), lights[l]);
            }
        }
    }
};

glm::dvec3 onGround(const Ray& ray) {
    return ray.origin - ray.origin.y / ray.direction.y * ray.direction;
}

glm::dvec3 wayTo(const glm::dvec4& light, const glm::dvec3& p) {
    return glm::dvec3(light) - light.w * p;
}

/// Where the ray from p along `way`, no longer than the way to a point light, passes the sphere.
bool meetsBall(const glm::dvec3& p, const glm::dvec3& way, bool endless, const glm::dvec3& centre, double radius) {
    const glm::dvec3 to = centre - p;
    double s = std::max(0.0, glm::dot(to, way) / glm::dot(way, way));
    if (!endless) s = std::min(s, 1.0);
    return glm::length(to - s * way) < radius;
}

TEST_F(Outlines, TheBallsShadowLiesBetweenThoseOfPolyhedraInsideAndOutside) {
    const glm::dvec3 centre(0.25, 2.0, -0.5);
    const double radius = 1.25;
    const std::vector<Corners> unit = icosphere(3);
    double least = 1.0;  // distance of a face
    for (const Corners& t : unit) {
        const glm::dvec3 n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
        least = std::min(least, glm::dot(n, t[0]));
    }
    const auto sized = [&](double r) {
        return Oracle(overGround(moved(unit, [&](const glm::dvec3& p) { return centre + r * p; })));
    };
    const Oracle inner = sized(radius), outer = sized(radius / least);
    forEachView([&](const EyeRays& rays, const glm::dvec4& light) {
        const std::vector<Pixel> in = picture(inner, rays, kWidth, kHeight, light);
        const std::vector<Pixel> out = picture(outer, rays, kWidth, kHeight, light);
        int dark = 0, between = 0;
        for (std::size_t i = 0; i < in.size(); ++i) {
            // Primary visibility first: what sees the inner one sees the ball, and so on.
            const bool ballSeen = meetsBall(in[i].ray.origin, in[i].ray.direction, true, centre, radius);
            EXPECT_TRUE(isGround(in[i].seen) || in[i].seen == kNothing || ballSeen) << "pixel " << i;
            EXPECT_TRUE(!ballSeen || (!isGround(out[i].seen) && out[i].seen != kNothing)) << "pixel " << i;
            if (!isGround(in[i].seen) || !isGround(out[i].seen)) continue;
            const glm::dvec3 p = onGround(in[i].ray), way = wayTo(light, p);
            const bool shrunk = meetsBall(p, way, light.w == 0.0, centre, radius - kMargin);
            const bool grown = meetsBall(p, way, light.w == 0.0, centre, radius + kMargin);
            EXPECT_TRUE(in[i].answer != Answer::Dark || grown) << "pixel " << i;
            EXPECT_TRUE(!shrunk || out[i].answer == Answer::Dark) << "pixel " << i;
            dark += in[i].answer == Answer::Dark;
            between += in[i].answer != out[i].answer;
        }
        EXPECT_GT(dark, 100);
        EXPECT_LT(between, dark / 5);
    });
}

/// Whether p + s way, 0 < s (< 1 unless endless), passes through the open box.
bool meetsBox(const glm::dvec3& p, const glm::dvec3& way, bool endless, const glm::dvec3& low, const glm::dvec3& high) {
    double from = 0.0, to = endless ? std::numeric_limits<double>::infinity() : 1.0;
    for (int k = 0; k < 3; ++k) {
        if (way[k] == 0.0) {
            if (p[k] <= low[k] || p[k] >= high[k]) return false;
            continue;
        }
        const double a = (low[k] - p[k]) / way[k], b = (high[k] - p[k]) / way[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

TEST_F(Outlines, BoxesOverTheGroundAndRestingOnIt) {
    for (const double bottom : {1.5, 0.0}) {
        const glm::dvec3 low(-1, bottom, -0.75), high(1, bottom + 1.25, 1.5);
        const Oracle oracle(overGround(box(low, high)));
        forEachView([&](const EyeRays& rays, const glm::dvec4& light) {
            int dark = 0, judged = 0;
            for (const Pixel& pixel : picture(oracle, rays, kWidth, kHeight, light)) {
                const auto& [origin, direction] = static_cast<const Ray&>(pixel.ray);
                const bool shrunk = meetsBox(origin, direction, true, low + kMargin, high - kMargin);
                const bool grown = meetsBox(origin, direction, true, low - kMargin, high + kMargin);
                if (shrunk != grown) continue;
                EXPECT_EQ(shrunk, pixel.seen != kNothing && !isGround(pixel.seen));
                if (shrunk || !isGround(pixel.seen)) continue;
                const glm::dvec3 p = onGround(pixel.ray), way = wayTo(light, p);
                const bool hidden = meetsBox(p, way, light.w == 0.0, low + kMargin, high - kMargin);
                if (hidden != meetsBox(p, way, light.w == 0.0, low - kMargin, high + kMargin)) continue;
                ++judged;
                dark += hidden;
                EXPECT_EQ(pixel.answer, hidden ? Answer::Dark : Answer::Lit) << "at " << p.x << " " << p.z;
            }
            EXPECT_GT(judged, 5000);
            // The light that shines straight down casts nothing beside the box that rests.
            const bool casts = bottom > 0.0 || glm::dvec3(light) != glm::dvec3(0, 1, 0);
            EXPECT_TRUE(!casts || dark > 50) << dark;
        });
    }
}

TEST_F(Outlines, TheHalfPlanesShadowEndsAtAStraightLine) {
    const double height = 0.5;
    const Oracle oracle(
        overGround(quad({-400, height, -400}, {-400, height, 400}, {0, height, 400}, {0, height, -400})));
    forEachView([&](const EyeRays& rays, const glm::dvec4& light) {
        int dark = 0, lit = 0;
        for (const Pixel& pixel : picture(oracle, rays, kWidth, kHeight, light)) {
            if (!isGround(pixel.seen)) continue;
            const glm::dvec3 p = onGround(pixel.ray), way = wayTo(light, p), q = p + height / way.y * way;
            if (std::abs(q.x) < kMargin || glm::length(q) > 300.0) continue;
            EXPECT_EQ(pixel.answer, q.x < 0.0 ? Answer::Dark : Answer::Lit) << "at " << p.x << " " << p.z;
            (q.x < 0.0 ? dark : lit) += 1;
        }
        EXPECT_GT(lit, 500);
        EXPECT_GT(dark + lit, 2000);
    });
}

TEST_F(Outlines, TheDiscsShadowLiesBetweenThoseOfPolygonsInsideAndOutside) {
    const double height = 1.0, radius = 1.5;
    const int corners = 128;
    const auto disc = [&](double r) {
        std::vector<Corners> fan;
        for (int i = 0; i < corners; ++i) {
            const auto rim = [&](int k) {
                const double angle = 2.0 * std::numbers::pi * (k % corners) / corners;
                return glm::dvec3(r * std::cos(angle), height, r * std::sin(angle));
            };
            fan.push_back({glm::dvec3(0, height, 0), rim(i + 1), rim(i)});
        }
        return Oracle(overGround(fan));
    };
    const Oracle inner = disc(radius), outer = disc(radius / std::cos(std::numbers::pi / corners));
    forEachView([&](const EyeRays& rays, const glm::dvec4& light) {
        const std::vector<Pixel> in = picture(inner, rays, kWidth, kHeight, light);
        const std::vector<Pixel> out = picture(outer, rays, kWidth, kHeight, light);
        int dark = 0;
        for (std::size_t i = 0; i < in.size(); ++i) {
            if (!isGround(in[i].seen) || !isGround(out[i].seen)) continue;
            const glm::dvec3 p = onGround(in[i].ray), way = wayTo(light, p), q = p + height / way.y * way;
            const double distance = std::hypot(q.x, q.z);
            EXPECT_TRUE(in[i].answer != Answer::Dark || distance < radius + kMargin) << "pixel " << i;
            EXPECT_TRUE(out[i].answer == Answer::Dark || distance > radius - kMargin) << "pixel " << i;
            dark += in[i].answer == Answer::Dark;
        }
        EXPECT_GT(dark, 100);
    });
}

TEST_F(Outlines, NothingIsDarkThatIsTurnedAway) {
    const Oracle oracle(overGround(icosphere(1)));
    for (const glm::dvec4& light : {glm::dvec4(1, -3, 1, 1), glm::dvec4(0.1, -1, 0, 0)}) {
        for (const Pixel& pixel : picture(oracle, EyeRays(cameras[0], kWidth, kHeight), kWidth, kHeight, light)) {
            EXPECT_TRUE(!isGround(pixel.seen) || pixel.answer == Answer::Away);
        }
    }
}

}  // namespace
}  // namespace umbrage::oracle
