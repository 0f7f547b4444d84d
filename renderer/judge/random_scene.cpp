// SPDX-License-Identifier: Apache-2.0
#include "judge/random_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace umbrage {
namespace {

/// std::mt19937_64 is defined to the bit, the distributions of <random> are not.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}

    /// low <= result <= high
    int integer(int low, int high) { return low + int(engine_() % std::uint64_t(high - low + 1)); }
    bool chance(int percent) { return integer(1, 100) <= percent; }
    double real(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

/// Builds one scene. Where it is snapped, points are multiples of 1/4, but for the poles of spindles.
class Builder {
public:
    explicit Builder(std::uint64_t seed) : draw_(seed), snapped_(draw_.chance(50)) {}

    RandomScene build() {
        addMaterials();
        int left = draw_.chance(30) ? draw_.integer(1, 10) : draw_.integer(1, 300);
        const int triangles = left;
        while (left > 0) left -= addMesh(left);
        if (draw_.chance(50)) addGround();
        const int lights = draw_.integer(1, 4);
        for (int l = 0; l < lights; ++l) addLight();
        placeCamera();
        made_.description =
            fmt::format("{} triangles, {} lights, {}{}", triangles, lights,
                        made_.camera.camera.perspective ? "perspective" : "orthographic", snapped_ ? ", snapped" : "");
        return std::move(made_);
    }

private:
    double coordinate(double size) {
        const double value = draw_.real(-size, size);
        return snapped_ ? std::round(4.0 * value) / 4.0 : value;
    }
    glm::dvec3 point(double size) {
        const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
        return {x, y, z};
    }

    void addMaterials() {
        for (int i = 0; i < 4; ++i) {
            Material material;
            material.doubleSided = i % 2 != 0;
            material.metallic = 0.0f;
            made_.scene.materials.push_back(material);
        }
        made_.scene.materials[2].alphaMode = AlphaMode::Mask;  // of alpha 1: all there
        made_.scene.materials[3].alphaMode = AlphaMode::Blend;
        made_.scene.materials[3].baseColor.a = 0.5f;
    }

    Node& addNode(const char* name) {
        Node node;
        node.path = fmt::format("/{}{}", name, made_.scene.nodes.size());
        made_.scene.nodes.push_back(node);
        return made_.scene.nodes.back();
    }

    void place(Node& node) {
        if (draw_.chance(40)) return;
        node.translation = point(1.0);
        if (snapped_) {
            const int turns = draw_.integer(0, 3);  // quarter turns, exactly
            glm::dmat4 m(1.0);
            if (turns == 1) m = glm::dmat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1);
            if (turns == 2) m = glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
            if (turns == 3) m = glm::dmat4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
            if (draw_.chance(30)) m[0] = -m[0];
            m[3] = glm::dvec4(node.translation, 1.0);
            node.matrix = m;
            return;
        }
        const glm::dvec3 axis = point(1.0);
        if (glm::length(axis) > 0.01) node.rotation = glm::angleAxis(draw_.real(-3.0, 3.0), glm::normalize(axis));
        for (int k = 0; k < 3; ++k) node.scale[k] = draw_.real(0.3, 1.5) * (draw_.chance(20) ? -1.0 : 1.0);
    }

    /// @return how many triangles it has
    int addMesh(int most) {
        Mesh mesh;
        const int kind = most >= 12 ? draw_.integer(0, 3) : 0;
        if (kind <= 1) {
            addSoup(mesh, draw_.integer(1, most), kind == 1);
        } else if (kind == 2) {
            addBox(mesh);
        } else {
            addFan(mesh, draw_.integer(3, std::min(most / 2, 24)));
        }
        if (draw_.chance(20)) removeSome(mesh);
        const int triangles = int(mesh.indices.size() / 3);
        if (triangles == 0) return 1;
        Primitive primitive;
        primitive.indexCount = std::uint32_t(mesh.indices.size());
        primitive.vertexCount = std::uint32_t(mesh.positions.size());
        primitive.material = draw_.chance(85) ? draw_.integer(0, 1) : draw_.integer(2, 3);
        mesh.primitives = {primitive};
        const auto index = Index(made_.scene.meshes.size());
        made_.scene.meshes.push_back(std::move(mesh));
        Node& node = addNode("mesh");
        node.mesh = index;
        place(node);
        return triangles;
    }

    static void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }

    /// `shared`: triangles between few points, so that edges have any valence and faces coincide.
    void addSoup(Mesh& mesh, int count, bool shared) {
        const double size = draw_.real(0.5, 2.5);
        const int points = shared ? draw_.integer(4, 4 + count / 2) : 3 * count;
        const glm::dvec3 centre = point(1.0);
        for (int i = 0; i < points; ++i) mesh.positions.emplace_back(centre + point(size));
        for (int t = 0; t < count; ++t) {
            const auto pick = [&](int k) { return std::uint32_t(shared ? draw_.integer(0, points - 1) : 3 * t + k); };
            const std::uint32_t a = pick(0), b = pick(1), c = pick(2);
            addTriangle(mesh, a, b, c);
        }
    }

    void addBox(Mesh& mesh) {
        const glm::dvec3 a = point(1.5), b = a + glm::dvec3(1.0) * (snapped_ ? 0.5 : draw_.real(0.1, 1.5));
        for (int i = 0; i < 8; ++i)
            mesh.positions.emplace_back(i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z);
        for (const auto& [p, q, r, s] : {std::array<std::uint32_t, 4>{0, 4, 6, 2},
                                         {1, 3, 7, 5},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 2, 3, 1},
                                         {4, 5, 7, 6}}) {
            addTriangle(mesh, p, q, r);
            addTriangle(mesh, p, r, s);
        }
    }

    /// A closed spindle: a ring of points between two poles.
    void addFan(Mesh& mesh, int ring) {
        const glm::dvec3 centre = point(1.5);
        const double radius = draw_.real(0.2, 1.2);
        mesh.positions = {glm::vec3(centre + glm::dvec3(0, radius, 0)), glm::vec3(centre - glm::dvec3(0, radius, 0))};
        for (int i = 0; i < ring; ++i) {
            const double angle = 6.283185307179586 * i / ring;
            glm::dvec3 p = centre + radius * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
            if (snapped_) p = glm::round(4.0 * p) / 4.0;
            mesh.positions.emplace_back(p);
        }
        for (int i = 0; i < ring; ++i) {
            const auto a = std::uint32_t(2 + i), b = std::uint32_t(2 + (i + 1) % ring);
            addTriangle(mesh, 0, b, a);
            addTriangle(mesh, 1, a, b);
        }
    }

    void removeSome(Mesh& mesh) {
        std::vector<std::uint32_t> kept;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            if (draw_.chance(30)) continue;
            kept.insert(kept.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
        }
        mesh.indices = kept;
    }

    void addGround() {
        Mesh mesh;
        const auto y = float(coordinate(2.0) - 1.0);
        mesh.positions = {{-8, y, 8}, {8, y, 8}, {8, y, -8}, {-8, y, -8}};
        mesh.indices = {0, 1, 2, 0, 2, 3};
        Primitive primitive;
        primitive.indexCount = 6;
        primitive.vertexCount = 4;
        primitive.material = 0;
        mesh.primitives = {primitive};
        const auto index = Index(made_.scene.meshes.size());
        made_.scene.meshes.push_back(std::move(mesh));
        addNode("ground").mesh = index;
    }

    void addLight() {
        Light light;
        light.type = LightType(draw_.integer(0, 2));
        light.intensity = light.type == LightType::Directional ? 2.0f : 60.0f;
        if (light.type != LightType::Directional && draw_.chance(40)) light.rangeMetres = float(draw_.real(1.0, 8.0));
        if (light.type == LightType::Spot) {
            light.outerConeAngle = float(draw_.real(0.2, 1.5));
            light.innerConeAngle = draw_.chance(30) ? light.outerConeAngle : 0.5f * light.outerConeAngle;
        }
        made_.scene.lights.push_back(light);
        Node& node = addNode("light");
        node.light = Index(made_.scene.lights.size() - 1);
        const glm::dvec3 position = point(draw_.chance(60) ? 4.0 : 2.0);
        glm::dvec3 away = glm::dvec3(0.0) - point(2.0);
        if (glm::length(away) < 0.1) away = {0.0, -1.0, 0.0};
        if (snapped_ && draw_.chance(50)) {
            // Along an axis, exactly.
            away = glm::dvec3(0.0);
            away[draw_.integer(0, 2)] = draw_.chance(50) ? 1.0 : -1.0;
        }
        node.matrix = lookAlong(position, away);
    }

    void placeCamera() {
        Camera& camera = made_.camera.camera;
        camera.perspective = draw_.chance(70);
        camera.znear = draw_.chance(50) ? 0.01 : 0.1;
        camera.yfov = snapped_ ? 1.5707963267948966 : draw_.real(0.3, 2.2);
        camera.xmag = camera.ymag = snapped_ ? 4.0 : draw_.real(1.0, 5.0);
        camera.zfar = camera.perspective && draw_.chance(70) ? 0.0 : draw_.real(8.0, 40.0);
        glm::dvec3 eye = point(5.0), target = point(1.0);
        if (draw_.chance(20)) eye = point(1.5);  // among the triangles
        if (glm::length(target - eye) < 0.2) target = eye + glm::dvec3(0.0, 0.0, -1.0);
        if (snapped_ && draw_.chance(50)) {
            target = eye;
            target[draw_.integer(0, 2)] += draw_.chance(50) ? 1.0 : -1.0;
        }
        made_.camera.worldFromCamera = lookAlong(eye, target - eye);
        made_.width = draw_.integer(64, 96);
        made_.height = 64;
    }

    /// Axes of exactly 0 and 1 where `forward` is along one.
    static glm::dmat4 lookAlong(const glm::dvec3& from, const glm::dvec3& forward) {
        const glm::dvec3 f = glm::normalize(forward);
        const glm::dvec3 up = std::abs(f.y) > 0.99 ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 side = glm::normalize(glm::cross(f, up));
        return {glm::dvec4(side, 0.0), glm::dvec4(glm::cross(side, f), 0.0), glm::dvec4(-f, 0.0),
                glm::dvec4(from, 1.0)};
    }

    Draw draw_;
    bool snapped_;
    RandomScene made_;
};

}  // namespace

RandomScene randomScene(std::uint64_t seed) {
    return Builder(seed).build();
}

}  // namespace umbrage
