// SPDX-License-Identifier: Apache-2.0
// Brabec and Seidel's Figure 5: three spheres that the sequence displaces with noise, three lights.
#include "scenes.h"
#include "stage.h"

namespace generator {

void noiseSpheres(Document& document) {
    addGround(document, 12, 8, {0.62, 0.6, 0.56});
    const Shape shape = sphere(1, 32, 18);
    const struct {
        const char* name;
        dvec3 place, color;
    } spheres[] = {{"SphereA", {-2.3, 1.5, -0.3}, {0.75, 0.32, 0.22}},
                   {"SphereB", {0.2, 1.7, 0.9}, {0.85, 0.68, 0.3}},
                   {"SphereC", {2.4, 1.4, -0.9}, {0.3, 0.5, 0.72}}};
    for (const auto& [name, place, color] : spheres) {
        const int material = document.material({.name = name, .color = color, .roughness = 0.55});
        const int node = addSolid(document, name, shape, material, place, 180);
        const Topology t = document.castersUnder(node);
        document.promise("vertices of a sphere", t.vertices, 546);
        document.promise("edges of a sphere", t.edges, 1632);
        document.promise("triangles of a sphere", t.triangles, 1088);
    }
    addMovingLight(document, {.name = "Warm", .color = {1, 0.78, 0.5}, .intensity = 90},
                   {{-4.5, 5, 3.5}, {-3, 5.4, 4.5}});
    addMovingLight(document, {.name = "Cool", .color = {0.5, 0.7, 1}, .intensity = 70}, {{4.5, 4.5, 3}, {5, 4.5, 1}});
    addMovingLight(document, {.name = "Rear", .color = {0.85, 1, 0.8}, .intensity = 60}, {{0.5, 4.2, -5}});
    addCamera(document, "Camera", 40, 0.1, {{-0.8, 4.6, 9.5}, {0, 4.4, 9.3}, {0.8, 4.2, 9.1}},
              {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}});
}

}  // namespace generator
