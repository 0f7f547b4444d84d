// SPDX-License-Identifier: Apache-2.0
// Small scenes made in code, and a brute-force answer to "is this pixel lit": every pixel centre against every
// triangle in double. Not the oracle (which is exact): mismatches are judged by whether they lie on a boundary.
#pragma once

#include <algorithm>
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

/// What brute force says about a point of the picture.
struct Answer {
    int triangle = -1;  // of all placed triangles; -1: background
    bool lit = false;
    bool grazing = false;   // the light is in the plane of what is seen, up to rounding
    double distance = 0.0;  // along the view axis
};

class BruteForce {
public:
    BruteForce(const TestScene& test, const Moment& moment, const PlacedLight& light, int width, int height)
        : eye_(makeEye(test.placedCamera(), width, height)), width_(width), height_(height) {
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
                triangles_.push_back(placed);
            }
        }
        light_ = light.light.type == LightType::Directional ? glm::dvec4(-light.direction, 0.0)
                                                            : glm::dvec4(light.position, 1.0);
    }

    /// @param x, y  in pixels from the upper left corner; the centre of the first pixel is (0.5, 0.5)
    Answer at(double x, double y) const {
        const glm::dvec2 ndc(2.0 * x / width_ - 1.0, 1.0 - 2.0 * y / height_);
        const glm::dvec2 at = ndc * eye_.rayScale;
        const glm::dvec3 origin(eye_.worldFromView *
                                (eye_.perspective ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(at, 0.0, 1.0)));
        const glm::dvec3 d(eye_.worldFromView *
                           (eye_.perspective ? glm::dvec4(at, -1.0, 0.0) : glm::dvec4(0, 0, -1, 0)));
        Answer answer;
        double nearest = eye_.zfar > 0.0 ? eye_.zfar : 1e300;
        bool seenFront = false;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const Placed& t = triangles_[i];
            const double e = hit(t, origin, d);
            if (e < eye_.znear || e >= nearest) continue;
            const bool front = (glm::dot(normal(t), d) < 0.0) != t.mirrored;
            if (!front && !t.doubleSided) continue;
            nearest = e;
            seenFront = front;
            answer.triangle = int(i);
        }
        if (answer.triangle < 0) return answer;
        const Placed& seen = triangles_[std::size_t(answer.triangle)];
        answer.distance = nearest;
        const glm::dvec3 p = origin + nearest * d;
        const glm::dvec3 toLight = glm::dvec3(light_) - light_.w * p;
        const double side = glm::dot(normal(seen), toLight) * (seen.mirrored ? -1.0 : 1.0);
        answer.grazing = std::abs(side) < 1e-5 * glm::length(normal(seen)) * glm::length(toLight);
        answer.lit = seenFront ? side > 0.0 : side < 0.0;
        for (std::size_t i = 0; i < triangles_.size() && answer.lit; ++i) {
            if (int(i) == answer.triangle) continue;
            const double s = hit(triangles_[i], p, toLight);
            if (s > 1e-9 && (light_.w == 0.0 || s < 1.0)) answer.lit = false;
        }
        return answer;
    }

    struct Mismatches {
        int wrong = 0;     // not explained by where the rasteriser snaps vertices
        int boundary = 0;  // explained: within 1/64 pixel the answer changes
        int judged = 0;
    };

    /// Compares shadow masks (one value a pixel) with the answer at every pixel's centre.
    /// @param normalAndDepth  what the renderer sees there: another surface (a sliver) explains another answer
    Mismatches compare(const std::vector<float>& shadow, const std::vector<float>& normalAndDepth) const {
        Mismatches result;
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                const bool lit = shadow[std::size_t(y * width_ + x)] > 0.5f;
                const Answer answer = at(x + 0.5, y + 0.5);
                result.judged += answer.triangle >= 0;
                if (lit == answer.lit || answer.grazing) continue;
                const double seen = normalAndDepth[4 * std::size_t(y * width_ + x) + 3];
                const bool other = answer.triangle < 0 || !(std::abs(seen - answer.distance) < 1e-3 * seen);
                ++(other || explained(x, y, lit, answer) ? result.boundary : result.wrong);
            }
        }
        return result;
    }

private:
    struct Placed {
        glm::dvec3 v[3];
        bool doubleSided, mirrored;
    };

    static glm::dvec3 normal(const Placed& t) { return glm::cross(t.v[1] - t.v[0], t.v[2] - t.v[0]); }

    /// Parameter along the ray where it crosses the triangle's interior; far below 0 where it does not.
    static double hit(const Placed& t, const glm::dvec3& origin, const glm::dvec3& d) {
        const glm::dvec3 e1 = t.v[1] - t.v[0], e2 = t.v[2] - t.v[0], p = glm::cross(d, e2);
        const double det = glm::dot(e1, p);
        if (det == 0.0) return -1e300;
        const glm::dvec3 s = origin - t.v[0], q = glm::cross(s, e1);
        const double u = glm::dot(s, p) / det, v = glm::dot(d, q) / det;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) return -1e300;
        return glm::dot(e2, q) / det;
    }

    /// The point of the seen triangle's plane at a place of the picture.
    glm::dvec3 onPlane(const Placed& seen, double x, double y) const {
        const glm::dvec2 at = glm::dvec2(2.0 * x / width_ - 1.0, 1.0 - 2.0 * y / height_) * eye_.rayScale;
        const glm::dvec3 origin(eye_.worldFromView *
                                (eye_.perspective ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(at, 0.0, 1.0)));
        const glm::dvec3 d(eye_.worldFromView *
                           (eye_.perspective ? glm::dvec4(at, -1.0, 0.0) : glm::dvec4(0, 0, -1, 0)));
        return origin + glm::dot(seen.v[0] - origin, normal(seen)) / glm::dot(d, normal(seen)) * d;
    }

    /// Whether the pixel's centre is inside the shadow of a triangle or within `tolerance` pixels of it, seen from the
    /// sides of its shadow: finds shadows too thin for sampling.
    bool nearShadowOf(const Placed& caster, const Placed& seen, double x, double y, double tolerance) const {
        double distance[3];
        for (int k = 0; k < 3; ++k) {
            const auto side = [&](double u, double v) {
                const glm::dvec3 p = onPlane(seen, u, v);
                const glm::dvec3 toLight = glm::dvec3(light_) - light_.w * p;
                return glm::dot(toLight, glm::cross(caster.v[k] - p, caster.v[(k + 1) % 3] - p));
            };
            const double here = side(x, y), dx = side(x + tolerance, y) - here, dy = side(x, y + tolerance) - here;
            distance[k] = here / std::max(std::hypot(dx, dy), 1e-300);  // in tolerances
        }
        const auto [low, high] = std::minmax({distance[0], distance[1], distance[2]});
        return low >= -1.0 || high <= 1.0;
    }

    bool explained(int x, int y, bool lit, const Answer& answer) const {
        for (int i = 0; i < 48; ++i) {
            const double angle = 6.283185307 * (i % 16) / 16.0, radius = (1 + i / 16) / 192.0;
            const Answer other = at(x + 0.5 + radius * std::cos(angle), y + 0.5 + radius * std::sin(angle));
            if (other.lit == lit || other.grazing || other.triangle != answer.triangle) return true;
        }
        for (std::size_t i = 0; i < triangles_.size() && !lit && answer.triangle >= 0; ++i) {
            const Placed& seen = triangles_[std::size_t(answer.triangle)];
            if (int(i) != answer.triangle && nearShadowOf(triangles_[i], seen, x + 0.5, y + 0.5, 1.0 / 64.0))
                return true;
        }
        return false;
    }

    Eye eye_;
    int width_, height_;
    glm::dvec4 light_{0.0};
    std::vector<Placed> triangles_;
};

}  // namespace umbrage::test
