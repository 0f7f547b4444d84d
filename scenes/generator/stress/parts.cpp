// SPDX-License-Identifier: Apache-2.0
#include "stress/parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

namespace generator::stress {

Mesh& Mesh::triangle(const vec3& a, const vec3& b, const vec3& c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    indices.insert(indices.end(), {first, first + 1, first + 2});
    return *this;
}

Mesh& Mesh::quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c, d});
    indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    return *this;
}

Mesh& Mesh::add(const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    for (const std::uint32_t index : other.indices) indices.push_back(first + index);
    return *this;
}

Mesh grid(const dvec3& corner, const dvec3& u, const dvec3& v, int cellsU, int cellsV) {
    Mesh result;
    for (int j = 0; j <= cellsV; ++j)
        for (int i = 0; i <= cellsU; ++i)
            result.positions.emplace_back(corner + u * (static_cast<double>(i) / cellsU) +
                                          v * (static_cast<double>(j) / cellsV));
    const auto row = static_cast<std::uint32_t>(cellsU + 1);
    for (int j = 0; j < cellsV; ++j)
        for (int i = 0; i < cellsU; ++i) {
            const std::uint32_t a = static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
            result.indices.insert(result.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
        }
    return result;
}

Mesh box(const dvec3& low, const dvec3& high, int cuts) {
    // Every coordinate comes from the same expression on all faces, so that neighbours share its bits.
    const auto on = [&](int axis, int step) {
        return step == cuts ? high[axis] : low[axis] + (high[axis] - low[axis]) * (static_cast<double>(step) / cuts);
    };
    Mesh result;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            Mesh face = grid({}, {}, {}, cuts, cuts);
            auto position = face.positions.begin();
            for (int j = 0; j <= cuts; ++j)
                for (int i = 0; i <= cuts; ++i, ++position) {
                    (*position)[axis] = static_cast<float>(upper ? high[axis] : low[axis]);
                    (*position)[u] = static_cast<float>(on(u, i)), (*position)[v] = static_cast<float>(on(v, j));
                }
            result.add(upper ? face : flipped(std::move(face)));
        }
    return result;
}

Mesh icosphere(const dvec3& centre, double radius, int levels) {
    Mesh result;
    std::map<std::array<float, 3>, std::uint32_t> known;
    const Shape unit = generator::icosphere(levels);
    for (const Corner& corner : unit.corners()) {
        const vec3 position(centre + radius * glm::normalize(corner.position));
        const auto [found, isNew] = known.try_emplace({position.x, position.y, position.z},
                                                      static_cast<std::uint32_t>(result.positions.size()));
        if (isNew) result.positions.push_back(position);
        result.indices.push_back(found->second);
    }
    return result;
}

Mesh torus(double radius, double thickness, int around, int sides) {
    Mesh result;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < sides; ++j) {
            const double turnDegrees = 360.0 * i / around, sideDegrees = 360.0 * j / sides;
            const double out = radius + thickness * cosDegrees(sideDegrees);
            result.positions.emplace_back(out * cosDegrees(turnDegrees), thickness * sinDegrees(sideDegrees),
                                          -out * sinDegrees(turnDegrees));
        }
    const auto index = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * sides + j % sides); };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < sides; ++j) {
            const std::uint32_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
            result.indices.insert(result.indices.end(), {a, b, c, a, c, d});
        }
    return result;
}

Mesh oddTetrahedron() {
    const vec3 a(-2.25f, 2.5f, -1.75f), b(2.5f, 2.125f, -1.5f), c(0.25f, 2.75f, 2.625f), d(0.375f, 6.5f, -0.25f);
    return Mesh{}.triangle(a, b, c).triangle(a, c, d).triangle(c, b, d).triangle(b, a, d);
}

Mesh flipped(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (vec3& normal : mesh.normals) normal = -normal;
    return mesh;
}

Mesh moved(Mesh mesh, const std::function<dvec3(const dvec3&)>& place) {
    for (vec3& position : mesh.positions) position = place(position);
    return mesh;
}

dmat3 oddRotation() {
    constexpr double kDegrees = 180 / kPi;
    return glm::mat3_cast(turn(0.5178 * kDegrees, {0, 0, 1}) * turn(0.9134 * kDegrees, {0, 1, 0}) *
                          turn(0.3721 * kDegrees, {1, 0, 0}));
}

Part partOf(const Mesh& mesh, int material, Mode mode, bool indexed) {
    Part part{.geometry = {}, .material = material, .mode = mode, .indexed = indexed};
    part.geometry.positions = mesh.positions;
    part.geometry.normals = mesh.normals;
    part.geometry.indices = mesh.indices;
    return part;
}

int paint(Document& document, const std::string& name, const dvec3& color, bool doubleSided) {
    return document.material({.name = name, .color = color, .roughness = 0.9, .doubleSided = doubleSided});
}

int place(Document& document, const std::string& name, const Mesh& mesh, int material, Kind kind) {
    const int index = document.mesh(name, {partOf(mesh, material)}, kind);
    document.node({.name = name, .mesh = index});
    return index;
}

void addGround(Document& document, double halfSize, int cells, double height) {
    place(document, "Ground",
          grid({-halfSize, height, halfSize}, {2 * halfSize, 0, 0}, {0, 0, -2 * halfSize}, cells, cells),
          paint(document, "Ground", dvec3(0.6)), Kind::Receiver);
}

void addCasters(Document& document) {
    const int material = paint(document, "Casters", kCasterColor);
    const auto tiltedAt = [](const dvec3& centre) {
        return [=](const dvec3& p) { return oddRotation() * p + centre; };
    };
    place(document, "Box", moved(box(dvec3(-1), dvec3(1), 4), tiltedAt({-2, 2.25, 0.5})), material);
    place(document, "Sphere", icosphere({1.5, 1.75, -1}, 1.25, 2), material);
    place(document, "Torus", moved(torus(1.5, 0.4, 24, 12), tiltedAt({0.5, 3.5, 2})), material);
}

void addStage(Document& document) {
    addGround(document, 20);
    place(document, "Wall", grid({-20, 0, -7}, {40, 0, 0}, {0, 14, 0}, 1, 1), paint(document, "Wall", dvec3(0.6)),
          Kind::Receiver);
    addCasters(document);
}

void addSun(Document& document, const std::string& name, const dvec3& direction) {
    const dvec3 other = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const dvec3 right = glm::normalize(glm::cross(other, -direction));
    const dmat4 matrix(dmat3(right, glm::cross(-direction, right), -direction));
    const int light = document.light({.name = name, .type = "directional", .intensity = 3});
    document.node({.name = name, .light = light, .matrix = matrix});
}

void addRoom(Document& document, const dvec3& low, const dvec3& high) {
    place(document, "Room", flipped(box(low, high)), paint(document, "Walls", dvec3(0.6)), Kind::Receiver);
}

std::string at(const dvec3& position) {
    return fmt::format("[{}, {}, {}]", position.x, position.y, position.z);
}

std::string keyed(const std::vector<std::pair<double, dvec3>>& keys) {
    std::vector<std::string> samples;
    samples.reserve(keys.size());
    for (const auto& [seconds, value] : keys) samples.push_back(fmt::format("{}: {}", seconds, at(value)));
    return fmt::format("{{{}}}", fmt::join(samples, ", "));
}

std::string pathThrough(const dvec3& middle, const dvec3& reach) {
    return keyed({{1, middle - reach},
                  {401, middle - reach / 1024.0},
                  {kSweepMiddle, middle},
                  {601, middle + reach / 1024.0},
                  {kSweepEnd, middle + reach}});
}

std::string eye(const std::string& position, const std::string& target, double yfovDegrees, double znear) {
    return fmt::format("{{position: {}, target: {}, yfov: {}, znear: {}}}", position, target, yfovDegrees, znear);
}

std::string orthographicEye(const std::string& position, const std::string& target, double ymag, double znear,
                            double zfar) {
    return fmt::format("{{type: orthographic, position: {}, target: {}, ymag: {}, znear: {}, zfar: {}}}", position,
                       target, ymag, znear, zfar);
}

std::string pointLight(const std::string& name, const std::string& position, double reachMetres) {
    return fmt::format("{{type: point, name: {}, position: {}, intensity: {}}}", name, position,
                       3 * reachMetres * reachMetres);
}

std::string sun(const std::string& name, const std::string& from, const std::string& to) {
    return fmt::format("{{type: directional, name: {}, position: {}, target: {}, intensity: 3}}", name, from, to);
}

std::string sequence(const Shot& shot) {
    std::string text;
    if (!shot.lights.empty()) text += "lights:\n";
    for (const std::string& light : shot.lights) text += fmt::format("  - {}\n", light);
    if (!shot.camera.empty()) text += fmt::format("camera: {}\n", shot.camera);
    text += fmt::format("time: {{fps: 1, frames: {}}}\n", shot.frames);
    text += fmt::format(
        "image: {{size: [{}, {}], samples: {}, background: [0.01, 0.012, 0.02], ambient: [0.05, 0.055, 0.065]}}\n",
        shot.width, shot.height, shot.samples);
    return text + shot.more;
}

}  // namespace generator::stress
