// SPDX-License-Identifier: Apache-2.0
#include "counted.h"

#include "oracle/predicates.h"

namespace umbrage::test {
namespace {

/// Whether a ray ends in the projection of a triangle to infinity, away from a point light.
bool endsInDarkCap(const oracle::Ray& ray, const Corners& corners, const glm::dvec3& light) {
    const glm::dvec3 a = corners[0] - light, b = corners[1] - light, c = corners[2] - light, d = ray.direction;
    const double whole = glm::dot(a, glm::cross(b, c));
    return whole != 0.0 && glm::dot(d, glm::cross(b, c)) / whole >= 0.0 &&
           glm::dot(a, glm::cross(d, c)) / whole >= 0.0 && glm::dot(a, glm::cross(b, d)) / whole >= 0.0;
}

/// @param entering  whether the crossing, one of `times`, leads into the volume
void add(Crossings& found, int times, bool entering, bool before, bool byFail) {
    (before ? found.passed : found.failed) += times;
    if (before != byFail) (entering != byFail ? found.entered : found.left) += times;
}

}  // namespace

Crossings& Crossings::operator+=(const Crossings& other) {
    sides += other.sides;
    lightCaps += other.lightCaps;
    darkCaps += other.darkCaps;
    passed += other.passed;
    failed += other.failed;
    entered += other.entered;
    left += other.left;
    return *this;
}

Counted::Counted(const Subject& subject, const How& how, int samples) : truth(subject.scene) {
    FrameSettings settings = subject.settings(how);
    settings.samples = samples;
    FrameRenderer renderer(subject.scene, subject.moment(), settings, context());
    FrameOutputs outputs;
    outputs.figures = outputs.overdraw = outputs.scene = outputs.samples = true;
    outputs.counts = how.counts;
    outputs.aovs = {"cost"};
    Statistics statistics;
    moment = subject.moment();
    pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
    truth.update(moment, renderer.geometry());
    json = nlohmann::json::parse(statistics.file({}).json())["frames"][0];
    for (std::uint32_t i = 0; i < renderer.geometry().instanceCount(); ++i) {
        const gpu::InstanceData& instance = renderer.geometry().instances()[i];
        for (std::uint32_t t = 0; t < instance.triangleCount; ++t) {
            const std::uint32_t index = truth.indexOf(instance.placedTriangleBase + t);
            if (index != oracle::kNothing) instanceOf[index] = i;
        }
    }
}

std::map<std::pair<std::uint32_t, std::array<Counted::Point, 2>>, int> Counted::edges(
    const std::function<int(const Corners&)>& facing) const {
    std::map<std::pair<std::uint32_t, std::array<Point, 2>>, int> found;
    const auto key = [](const glm::dvec3& p) { return Point{p.x, p.y, p.z}; };
    const auto& triangles = truth.oracle().triangles();
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const Corners& corners = triangles[t].corners;
        const int times = triangles[t].casts ? facing(corners) : 0;
        for (std::size_t k = 0; times != 0 && k < 3; ++k) {
            const Point a = key(corners[k]), b = key(corners[(k + 1) % 3]);
            if (a == b) continue;
            found[{instanceOf.at(t), a < b ? std::array{a, b} : std::array{b, a}}] += a < b ? times : -times;
        }
    }
    return found;
}

std::size_t Counted::edgeCount() const {
    return edges([](const Corners& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }).size();
}

std::vector<Quad> Counted::quadsOf(const glm::dvec4& light) const {
    std::vector<Quad> quads;
    for (const auto& [edge, times] : edges([&](const Corners& t) { return oracle::sideOfLight(t, light); })) {
        const auto& [a, b] = edge.second;
        if (times != 0) quads.push_back({{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, times});
    }
    return quads;
}

Crossings crossingsOf(const Counted& counted, const oracle::Ray& ray, const std::vector<Quad>& quads,
                      const glm::dvec4& light, bool byFail, double seen) {
    Crossings found;
    const bool point = light.w != 0.0;
    for (const Quad& quad : quads) {
        // A quad is a + s u + t v: of a point light v = 0 at the light, s, t >= 0 and s + t >= 1.
        const glm::dvec3 origin = point ? glm::dvec3(light) : quad.a;
        const glm::dvec3 u = point ? quad.a - origin : quad.b - quad.a;
        const glm::dvec3 v = point ? quad.b - origin : -glm::dvec3(light);
        const glm::dvec3 n = glm::cross(u, v);  // out of the volume of a point light, into that of another
        const double distance = glm::dot(n, origin - ray.origin) / glm::dot(n, ray.direction);
        if (!(distance > 0.0)) continue;
        const glm::dvec3 h = ray.origin + distance * ray.direction - origin;
        const double s = glm::dot(glm::cross(h, v), n), t = glm::dot(glm::cross(u, h), n), whole = glm::dot(n, n);
        if (s < 0.0 || t < 0.0 || (point ? s + t < whole : s > whole)) continue;
        const bool entering = ((glm::dot(n, ray.direction) > 0.0) != point) == (quad.times > 0);
        found.sides += std::abs(quad.times);
        add(found, std::abs(quad.times), entering, distance < seen, byFail);
    }
    if (!byFail) return found;
    for (const oracle::Triangle& triangle : counted.truth.oracle().triangles()) {
        const int facing = triangle.casts ? oracle::sideOfLight(triangle.corners, light) : 0;
        if (facing == 0) continue;
        const int side = oracle::sideOfRay(triangle.corners, ray);
        const glm::dvec3 n =
            glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
        const double distance = glm::dot(n, triangle.corners[0] - ray.origin) / glm::dot(n, ray.direction);
        if (side != 0 && distance > 0.0 && oracle::meets(ray, triangle.corners)) {
            ++found.lightCaps;
            add(found, 1, side == facing, false, byFail);  // nothing opaque is before what is seen
        }
        if (point && endsInDarkCap(ray, triangle.corners, glm::dvec3(light))) {
            ++found.darkCaps;
            add(found, 1, false, false, byFail);
        }
    }
    return found;
}

double farthest(const PlacedCamera& camera, const oracle::Ray& ray) {
    if (camera.camera.zfar == 0.0) return 1e300;
    return camera.camera.zfar / glm::dot(ray.direction, -glm::dvec3(camera.worldFromCamera[2]));
}

}  // namespace umbrage::test
