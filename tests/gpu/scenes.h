// SPDX-License-Identifier: Apache-2.0
// Small scenes made in code, and a brute-force answer to "is this pixel lit": every pixel centre against every
// triangle in double. Not the oracle (which is exact): mismatches are judged by whether they lie on a boundary.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "frame/frame.h"
#include "scene/moment.h"
#include "shadow/eye.h"

namespace umbrage::test {

using Triangles = std::vector<std::array<glm::vec3, 3>>;

inline Triangles transformed(Triangles triangles, const glm::mat4& m) {
    for (auto& triangle : triangles) {
        for (glm::vec3& p : triangle) p = glm::vec3(m * glm::vec4(p, 1.0f));
    }
    return triangles;
}

inline Triangles quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return {{a, b, c}, {a, c, d}};
}

/// Facing +Y.
inline Triangles ground(float halfSize, float y = 0.0f) {
    return quad({-halfSize, y, halfSize}, {halfSize, y, halfSize}, {halfSize, y, -halfSize}, {-halfSize, y, -halfSize});
}

/// A unit sphere, outward; positions shared exactly.
inline Triangles sphere(int subdivisions) {
    const float t = (1.0f + std::sqrt(5.0f)) / 2.0f;
    const std::vector<glm::vec3> v = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                      {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    const int faces[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    Triangles triangles;
    for (const auto& f : faces) triangles.push_back({v[f[0]], v[f[1]], v[f[2]]});
    for (int s = 0; s < subdivisions; ++s) {
        Triangles finer;
        for (const auto& [a, b, c] : triangles) {
            const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    for (auto& triangle : triangles) {
        for (glm::vec3& p : triangle) p = glm::normalize(p);
    }
    return triangles;
}

/// An axis-aligned box, outward.
inline Triangles box(const glm::vec3& low, const glm::vec3& high) {
    const auto p = [&](int x, int y, int z) {
        return glm::vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    Triangles triangles;
    for (const Triangles& face :
         {quad(p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)), quad(p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0)),
          quad(p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1)), quad(p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)),
          quad(p(0, 1, 1), p(1, 1, 1), p(1, 1, 0), p(0, 1, 0)), quad(p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1))}) {
        triangles.insert(triangles.end(), face.begin(), face.end());
    }
    return triangles;
}

struct TestScene {
    Scene scene;
    Camera camera;
    glm::dvec3 eye{0.0, 2.0, 8.0}, target{0.0};

    TestScene() {
        camera.yfov = 0.9;
        camera.znear = 0.1;
        Material single, both;
        both.doubleSided = true;
        scene.materials = {single, both};
    }

    Node& add(const Triangles& triangles, bool doubleSided = false) {
        Mesh mesh;
        for (const auto& triangle : triangles) {
            for (const glm::vec3& p : triangle) {
                mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
                mesh.positions.push_back(p);
            }
        }
        Primitive primitive;
        primitive.indexCount = std::uint32_t(mesh.indices.size());
        primitive.vertexCount = std::uint32_t(mesh.positions.size());
        primitive.material = doubleSided ? 1 : 0;
        mesh.primitives = {primitive};
        scene.meshes.push_back(std::move(mesh));
        Node node;
        node.path = "/mesh" + std::to_string(scene.nodes.size());
        node.mesh = Index(scene.meshes.size() - 1);
        scene.nodes.push_back(node);
        return scene.nodes.back();
    }

    Node& addLight(LightType type, const glm::dvec3& at) {
        Light light;
        light.type = type;
        light.intensity = type == LightType::Directional ? 3.0f : 100.0f;
        scene.lights.push_back(light);
        Node node;
        node.path = "/light" + std::to_string(scene.nodes.size());
        node.light = Index(scene.lights.size() - 1);
        if (type == LightType::Directional) {
            const glm::dvec3 up = std::abs(at.y) > 0.99 * glm::length(at) ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
            const glm::dmat4 m = glm::inverse(glm::lookAt(glm::dvec3(0.0), -at, up));
            node.matrix = m;
        } else {
            node.translation = at;
        }
        scene.nodes.push_back(node);
        return scene.nodes.back();
    }

    PlacedCamera placedCamera() const {
        const glm::dvec3 forward = glm::normalize(target - eye);
        const glm::dvec3 up = std::abs(forward.y) > 0.99 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
        return {camera, glm::inverse(glm::lookAt(eye, target, up))};
    }
};

/// What brute force says about a pixel.
struct Answer {
    int triangle = -1;  // of all placed triangles; -1: background
    bool facesLight = false, lit = false;
};

inline std::vector<Answer> bruteForce(const TestScene& test, const Moment& moment, const PlacedLight& light, int width,
                                      int height) {
    struct Placed {
        glm::dvec3 v[3];
        bool doubleSided, mirrored;
    };
    std::vector<Placed> triangles;
    for (const Instance& instance : moment.instances) {
        const Mesh& mesh = test.scene.meshes[std::size_t(instance.mesh)];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Placed placed;
            for (std::size_t k = 0; k < 3; ++k) {
                placed.v[k] =
                    glm::dvec3(instance.worldFromModel * glm::dvec4(mesh.positions[mesh.indices[i + k]], 1.0));
            }
            placed.doubleSided = mesh.primitives[0].material == 1;
            placed.mirrored = glm::determinant(glm::dmat3(instance.worldFromModel)) < 0.0;
            triangles.push_back(placed);
        }
    }
    const Eye eye = makeEye(test.placedCamera(), width, height);
    const glm::dvec4 l = light.light.type == LightType::Directional ? glm::dvec4(-light.direction, 0.0)
                                                                    : glm::dvec4(light.position, 1.0);
    // Parameter along the ray where it crosses the triangle's interior, or -1.
    const auto hit = [](const Placed& t, const glm::dvec3& origin, const glm::dvec3& d) {
        const glm::dvec3 e1 = t.v[1] - t.v[0], e2 = t.v[2] - t.v[0], p = glm::cross(d, e2);
        const double det = glm::dot(e1, p);
        if (det == 0.0) return -1e300;
        const glm::dvec3 s = origin - t.v[0], q = glm::cross(s, e1);
        const double u = glm::dot(s, p) / det, v = glm::dot(d, q) / det;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) return -1e300;
        return glm::dot(e2, q) / det;
    };
    std::vector<Answer> answers(std::size_t(width * height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 ndc(2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height);
            const glm::dvec2 at = ndc * eye.rayScale;
            const glm::dvec3 origin =
                glm::dvec3(eye.worldFromView * (eye.perspective ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(at, 0.0, 1.0)));
            const glm::dvec3 d =
                glm::dvec3(eye.worldFromView * (eye.perspective ? glm::dvec4(at, -1.0, 0.0) : glm::dvec4(0, 0, -1, 0)));
            Answer& answer = answers[std::size_t(y * width + x)];
            double nearest = eye.zfar > 0.0 ? eye.zfar : 1e300;
            bool seenFront = false;
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const Placed& t = triangles[i];
                const double e = hit(t, origin, d);
                if (e < eye.znear || e >= nearest) continue;
                const bool front = (glm::dot(glm::cross(t.v[1] - t.v[0], t.v[2] - t.v[0]), d) < 0.0) != t.mirrored;
                if (!front && !t.doubleSided) continue;
                nearest = e;
                seenFront = front;
                answer.triangle = int(i);
            }
            if (answer.triangle < 0) continue;
            const Placed& seen = triangles[std::size_t(answer.triangle)];
            const glm::dvec3 p = origin + nearest * d;
            const glm::dvec3 toLight = glm::dvec3(l) - l.w * p;
            const double side = glm::dot(glm::cross(seen.v[1] - seen.v[0], seen.v[2] - seen.v[0]), toLight) *
                                (seen.mirrored ? -1.0 : 1.0);
            answer.facesLight = seenFront ? side > 0.0 : side < 0.0;
            answer.lit = answer.facesLight;
            for (std::size_t i = 0; i < triangles.size() && answer.lit; ++i) {
                if (int(i) == answer.triangle) continue;
                const double s = hit(triangles[i], p, toLight);
                if (s > 1e-9 && (l.w == 0.0 || s < 1.0)) answer.lit = false;
            }
        }
    }
    return answers;
}

struct Mismatches {
    int off = 0;       // away from every boundary: wrong
    int boundary = 0;  // within a pixel of one
    int lit = 0, dark = 0;
};

/// Compares a shadow mask with brute force. A pixel is on a boundary when a pixel within two steps sees another
/// triangle whose plane differs or has another answer.
inline Mismatches compare(const std::vector<float>& shadow, const std::vector<Answer>& answers, int width, int height) {
    Mismatches result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Answer& answer = answers[std::size_t(y * width + x)];
            (answer.lit ? result.lit : result.dark) += answer.triangle >= 0;
            if ((shadow[std::size_t(y * width + x)] > 0.5f) == answer.lit) continue;
            bool boundary = false;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (x + dx < 0 || y + dy < 0 || x + dx >= width || y + dy >= height) continue;
                    const Answer& other = answers[std::size_t((y + dy) * width + x + dx)];
                    boundary = boundary || other.lit != answer.lit || (other.triangle < 0) != (answer.triangle < 0);
                }
            }
            ++(boundary ? result.boundary : result.off);
        }
    }
    return result;
}

}  // namespace umbrage::test
