// SPDX-License-Identifier: Apache-2.0
// What exactness costs: a frame of the oracle next to Embree's own occlusion rays to the same lights from the same
// points. Per repetition both take turns; figures are milliseconds a frame (see) and a frame and light (the others).
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "scene/compose.h"
#include "scene/moment.h"
#include "unit/oracle/pictures.h"

namespace umbrage::oracle {
namespace {

constexpr int kWidth = 1024, kHeight = 768, kThreads = 2;

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void forEachPixel(const std::function<void(int x, int y)>& body) {
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int y; (y = next++) < kHeight;) {
            for (int x = 0; x < kWidth; ++x) body(x, y);
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) threads.emplace_back(work);
}

/// side * side spheres on the ground, at float coordinates.
std::vector<Triangle> spheres(int side, int level) {
    const std::vector<Corners> unit = icosphere(level);
    std::vector<Corners> all;
    for (int i = 0; i < side * side; ++i) {
        const glm::dvec3 centre(1.5 * (i % side - 0.5 * (side - 1)), 0.6, 1.5 * (i / side - 0.5 * (side - 1)));
        append(all, moved(unit, [&](const glm::dvec3& p) { return glm::dvec3(glm::vec3(centre + 0.6 * p)); }));
    }
    return overGround(all);
}

/// Embree as others use it: float triangles, its own test.
class PlainEmbree {
public:
    explicit PlainEmbree(const std::vector<Triangle>& triangles) {
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles.size()));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
        for (const Triangle& t : triangles) {
            for (const glm::dvec3& p : t.corners) {
                for (int k = 0; k < 3; ++k) *vertices++ = float(p[k]);
            }
        }
        for (unsigned i = 0; i < 3 * triangles.size(); ++i) indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    PlainEmbree(const PlainEmbree&) = delete;
    PlainEmbree& operator=(const PlainEmbree&) = delete;
    ~PlainEmbree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    bool hidden(const glm::dvec3& p, const glm::dvec4& light) const {
        const glm::dvec3 way = glm::dvec3(light) - light.w * p;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay ray{};
        ray.org_x = float(p.x);
        ray.org_y = float(p.y);
        ray.org_z = float(p.z);
        ray.dir_x = float(way.x);
        ray.dir_y = float(way.y);
        ray.dir_z = float(way.z);
        ray.tnear = 1e-5f;
        ray.tfar = light.w != 0.0 ? 1.0f : std::numeric_limits<float>::infinity();
        ray.mask = ~0u;
        rtcOccluded1(scene_, &context, &ray);
        return ray.tfar < 0.0f;
    }

private:
    RTCDevice device_ = rtcNewDevice(nullptr);
    RTCScene scene_;
};

/// What a frame is made of.
struct Setting {
    std::vector<Triangle> triangles;
    PlacedCamera camera;
    std::vector<glm::dvec4> lights;
};

Setting settingOfSpheres(int side, int level) {
    const double extent = 0.75 * side;
    return {spheres(side, level),
            cameraAt({0.9 * extent, 1.1 * extent, 1.6 * extent}, {0, 0, 0}, true),
            {{4, 6, 2, 1}, {-3, 5, 4, 1}, {0.4, 1, -0.3, 0}, {-0.7, 0.5, 0.2, 0}}};
}

/// Frame 24 of the sequence (16 figures, one light): rigid meshes, all of them casting.
Setting settingOfKnights() {
    const Job job = readJob(UMBRAGE_SOURCE_DIR "/configs/knights.yaml");
    const Composition composition = compose(job);
    const Moment moment = evaluate(composition.scene, composition.animations, 24.0 / job.time.framesPerSecond);
    Setting setting;
    setting.camera = placeCamera(composition.scene, moment, composition.cameraNode);
    for (const PlacedLight& light : moment.lights) setting.lights.push_back(placeOf(light));
    for (const Instance& instance : moment.instances) {
        const Mesh& mesh = composition.scene.meshes[std::size_t(instance.mesh)];
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
            Triangle& triangle = setting.triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                triangle.corners[corner] =
                    instance.worldFromModel * glm::dvec4(mesh.positions[mesh.indices[k + corner]], 1.0);
            }
        }
    }
    return setting;
}

void frame(benchmark::State& state, const Setting& setting) {
    const std::vector<Triangle>& triangles = setting.triangles;
    const EyeRays rays(setting.camera, kWidth, kHeight);
    const std::vector<glm::dvec4>& lights = setting.lights;
    const Oracle oracle(triangles);
    const PlainEmbree embree(triangles);
    std::vector<std::uint32_t> seen(kWidth * kHeight);
    std::vector<glm::dvec3> points(seen.size());
    std::vector<std::uint8_t> turned(seen.size()), hidden(seen.size());
    double see = 0, turn = 0, hide = 0, plain = 0, queries = 0, differ = 0;
    for (auto _ : state) {
        see += milliseconds([&] {
            forEachPixel(
                [&](int x, int y) { seen[std::size_t(y * kWidth + x)] = oracle.see(rays.at(x + 0.5, y + 0.5)); });
        });
        forEachPixel([&](int x, int y) {
            const std::size_t i = std::size_t(y * kWidth + x);
            const EyeRay ray = rays.at(x + 0.5, y + 0.5);
            if (seen[i] != kNothing) points[i] = ray.origin + oracle.distanceTo(seen[i], ray) * ray.direction;
        });
        for (const glm::dvec4& light : lights) {
            turn += milliseconds([&] {
                forEachPixel([&](int x, int y) {
                    const std::size_t i = std::size_t(y * kWidth + x);
                    turned[i] = seen[i] != kNothing && oracle.turnedTo(light, seen[i], rays.at(x + 0.5, y + 0.5));
                });
            });
            hide += milliseconds([&] {
                forEachPixel([&](int x, int y) {
                    const std::size_t i = std::size_t(y * kWidth + x);
                    if (!turned[i]) return;
                    hidden[i] = oracle.hiddenBy(light, seen[i], rays.at(x + 0.5, y + 0.5)) != kNothing;
                });
            });
            std::atomic<int> different{0};
            plain += milliseconds([&] {
                forEachPixel([&](int x, int y) {
                    const std::size_t i = std::size_t(y * kWidth + x);
                    if (turned[i] && embree.hidden(points[i], light) != bool(hidden[i])) ++different;
                });
            });
            differ += different;
            queries += double(std::count(turned.begin(), turned.end(), 1));
        }
    }
    const double frames = double(state.iterations()), each = frames * double(lights.size());
    state.counters["triangles"] = double(triangles.size());
    state.counters["see_ms"] = see / frames;
    state.counters["turned_ms"] = turn / each;
    state.counters["hidden_ms"] = hide / each;
    state.counters["embree_ms"] = plain / each;
    state.counters["ratio"] = hide / plain;
    state.counters["rays"] = queries / each;
    state.counters["differ"] = differ / each;  // answers, a light
}

void spheresOf(benchmark::State& state) {
    frame(state, settingOfSpheres(int(state.range(0)), int(state.range(1))));
}
void knights(benchmark::State& state) {
    frame(state, settingOfKnights());
}

BENCHMARK(knights)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(spheresOf)->Args({6, 2})->Args({7, 5})->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace umbrage::oracle

BENCHMARK_MAIN();
