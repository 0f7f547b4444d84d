// SPDX-License-Identifier: Apache-2.0
// What the oracle says about every pixel of a picture.
#pragma once

#include <string>
#include <vector>

#include "oracle/oracle.h"
#include "surfaces.h"

namespace umbrage::oracle {

inline PlacedCamera cameraAt(const glm::dvec3& eye, const glm::dvec3& target, bool perspective) {
    const glm::dvec3 back = glm::normalize(eye - target), right = glm::normalize(glm::cross({0, 1, 0}, back));
    PlacedCamera placed;
    placed.camera.perspective = perspective;
    placed.camera.ymag = 6.0;
    placed.camera.znear = 0.01;
    placed.camera.zfar = perspective ? 0.0 : 100.0;
    placed.worldFromCamera = {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
                              glm::dvec4(eye, 1)};
    return placed;
}

enum class Answer { Nothing, Away, Dark, Lit };

struct Pixel {
    EyeRay ray;
    std::uint32_t seen = kNothing;
    Answer answer = Answer::Nothing;
};

inline std::vector<Pixel> picture(const Oracle& oracle, const EyeRays& rays, int width, int height,
                                  const glm::dvec4& light) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Pixel pixel{.ray = rays.at(x + 0.5, y + 0.5)};
            pixel.seen = oracle.see(pixel.ray);
            if (pixel.seen != kNothing) {
                const bool turned = oracle.turnedTo(light, pixel.seen, pixel.ray);
                const bool dark = turned && oracle.hiddenBy(light, pixel.seen, pixel.ray) != kNothing;
                pixel.answer = !turned ? Answer::Away : dark ? Answer::Dark : Answer::Lit;
            }
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

/// The ground y = 0 (triangles 0 and 1), and something on or over it.
inline std::vector<Triangle> overGround(const std::vector<Corners>& thing) {
    std::vector<Triangle> triangles;
    for (const Corners& t : quad({-500, 0, -500}, {-500, 0, 500}, {500, 0, 500}, {500, 0, -500})) {
        triangles.push_back({.corners = t});
    }
    for (const Corners& t : thing) triangles.push_back({.corners = t});
    return triangles;
}

inline bool isGround(std::uint32_t seen) {
    return seen < 2;
}

}  // namespace umbrage::oracle
