// SPDX-License-Identifier: Apache-2.0
// The single casters of Laine's Figures 3 to 5: where his split planes lie well and where they do not.
#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

constexpr dvec3 kGroundColor{0.6, 0.58, 0.54};

}  // namespace

void teapotLike(Document& document) {
    addGround(document, 10, 8, kGroundColor);
    const std::vector<dvec2> outline{{0, 0},       {0.62, 0},    {0.66, 0.05}, {0.85, 0.2}, {0.98, 0.42}, {1, 0.6},
                                     {0.93, 0.82}, {0.78, 0.98}, {0.66, 1.04}, {0.6, 1.04}, {0.5, 1.1},   {0.25, 1.17},
                                     {0.08, 1.2},  {0.06, 1.25}, {0.12, 1.31}, {0.1, 1.37}, {0, 1.39}};
    Shape pot = lathe(outline, 36);
    const auto spout = splineThrough({{0.75, 0.38, 0}, {1.15, 0.48, 0}, {1.3, 0.8, 0}, {1.58, 1.06, 0}}, 10);
    std::vector<double> radii;
    for (int i = 0; i < 10; ++i) radii.push_back(mix(0.24, 0.09, i / 9.0));
    pot.add(tube(ringsAlong(spout, radii), 14));
    const auto handle =
        splineThrough({{-0.72, 0.95, 0}, {-1.15, 1.02, 0}, {-1.42, 0.8, 0}, {-1.32, 0.45, 0}, {-0.9, 0.3, 0}}, 14);
    pot.add(tube(ringsAlong(handle, std::vector<double>(14, 0.075)), 10));
    const int material = document.material({.name = "Glaze", .color = {0.75, 0.3, 0.2}, .roughness = 0.35});
    addSolid(document, "Teapot", pot, material);
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.92, 0.8}, .intensity = 60},
                   {{-3, 3.2, 2}, {-1.2, 3.6, 3}, {1.4, 3.4, 2.6}});
    addCamera(document, "Camera", 40, 0.05, {{2.4, 2.2, 4.6}, {0, 2.4, 5.2}, {-2.6, 2.1, 4.4}},
              {{0, 0.6, 0}, {0, 0.6, 0}, {0, 0.6, 0}});
}

void pole(Document& document) {
    addGround(document, 14, 8, kGroundColor);
    const int material = document.material({.name = "Paint", .color = {0.8, 0.75, 0.65}, .roughness = 0.5});
    addSolid(document, "Pole", tube(ringsAlong({{-3, 0.35, 0.6}, {3, 1.6, -0.6}}, {0.07, 0.07}), 12), material);
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.92, 0.8}, .intensity = 80},
                   {{-2.5, 4, -2.5}, {0, 4.2, -2.5}, {2.5, 4, -2}});
    addCamera(document, "Camera", 42, 0.05, {{-2.5, 2.4, 6}, {0, 2.6, 6.4}, {2.5, 2.2, 6}},
              {{0, 0.7, 0}, {0, 0.7, 0}, {0, 0.7, 0}});
}

void pipe(Document& document) {
    addGround(document, 10, 8, kGroundColor);
    const auto arc = [](dvec3 centre, dvec3 from, dvec3 to) {
        std::vector<dvec3> points;
        for (int i = 0; i <= 8; ++i)
            points.push_back(centre + from * cosDegrees(90 * i / 8.0) + to * sinDegrees(90 * i / 8.0));
        return points;
    };
    // Up from the ground, over, along and down in front: neighbours share their end rings' planes exactly.
    const std::vector<dvec3> parts[] = {
        {{-1.6, 0, -0.5}, {-1.6, 0.7, -0.5}, {-1.6, 1.4, -0.5}},
        arc({-1, 1.4, -0.5}, {-0.6, 0, 0}, {0, 0.6, 0}),
        {{-1, 2, -0.5}, {0, 2, -0.5}, {1, 2, -0.5}},
        arc({1, 2, 0.1}, {0, 0, -0.6}, {0.6, 0, 0}),
    };
    const dvec3 colors[] = {{0.7, 0.45, 0.3}, {0.65, 0.6, 0.4}, {0.4, 0.55, 0.6}, {0.55, 0.45, 0.6}};
    const char* names[] = {"PartA", "PartB", "PartC", "PartD"};
    for (int i = 0; i < 4; ++i) {
        const int material = document.material({.name = names[i], .color = colors[i], .roughness = 0.45});
        addSolid(document, names[i], tube(ringsAlong(parts[i], std::vector<double>(parts[i].size(), 0.22)), 16),
                 material);
    }
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.92, 0.8}, .intensity = 90},
                   {{-2.5, 4.5, 3}, {0, 4.8, 3.2}, {2, 4.4, 2.4}});
    addCamera(document, "Camera", 42, 0.05, {{-3.2, 2.6, 5.4}, {-0.4, 3, 6.2}, {3, 2.6, 5.4}},
              {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}});
}

}  // namespace generator
