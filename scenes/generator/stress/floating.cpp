// SPDX-License-Identifier: Apache-2.0
#include "stress/floating.h"

namespace generator::stress {

std::string lookDown(const std::string& frames, int samples) {
    return sequence({.camera = eye(at({0, 5.5, 7.5}), at({0, 0.6, 0}), 42),
                     .lights = {pointLight("Key", at({2.6, 6.3, 2.2}), 7), pointLight("Side", at({-5.3, 4.2, 1.7}), 5)},
                     .frames = frames,
                     .samples = samples});
}

Case floating(const std::string& id, const std::string& what, const std::string& answer, const std::string& catches,
              const std::function<Mesh()>& make) {
    const auto fill = [make](Document& document) {
        addGround(document, 9);
        place(document, "Caster", make(), paint(document, "Caster", kCasterColor, true), Kind::Open);
    };
    return {id, what, answer, catches, fill, lookDown()};
}

Mesh oddlyPlaced(Mesh mesh, const dvec3& centre) {
    return moved(std::move(mesh), [&](const dvec3& p) { return centre + oddRotation() * p; });
}

Mesh unshared(const Mesh& mesh) {
    Mesh result;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        result.triangle(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                        mesh.positions[mesh.indices[i + 2]]);
    return result;
}

dvec3 inBall(Random& random) {
    for (;;) {
        const double x = random.between(-1, 1), y = random.between(-1, 1);
        const dvec3 p(x, y, random.between(-1, 1));
        if (glm::dot(p, p) <= 1) return p;
    }
}

}  // namespace generator::stress
