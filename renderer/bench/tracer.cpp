// SPDX-License-Identifier: Apache-2.0
#include "bench/tracer.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "instruction_set.h"
#include "shading/lights.h"

namespace umbrage {
namespace {

void set(float (&to)[3], const glm::dvec3& from) {
    for (int k = 0; k < 3; ++k) to[k] = float(from[k]);
}

/// The pixels' rays, relative to the scene's origin.
void aim(const Eye& eye, const glm::dvec3& origin, TracerFrame& frame) {
    const glm::dvec3 right(eye.worldFromView[0]), up(eye.worldFromView[1]), forward(-eye.worldFromView[2]);
    const glm::dvec3 acrossPixel = 2.0 / frame.width * eye.rayScale.x * right;
    const glm::dvec3 downPixel = -2.0 / frame.height * eye.rayScale.y * up;
    const glm::dvec3 first = -eye.rayScale.x * right + eye.rayScale.y * up + 0.5 * (acrossPixel + downPixel);
    const glm::dvec3 place = eye.position() - origin;
    set(frame.origin, eye.perspective ? place : place + first);
    set(frame.direction, eye.perspective ? forward + first : forward);
    set(eye.perspective ? frame.directionRight : frame.originRight, acrossPixel);
    set(eye.perspective ? frame.directionDown : frame.originDown, downPixel);
    frame.near = float(eye.znear);
    frame.far = eye.zfar > 0.0 ? float(eye.zfar) : std::numeric_limits<float>::infinity();
}

/// As lightData() has it for the renderer, but in the tracer's space.
TracerLight tracerLight(const PlacedLight& placed, const glm::dvec3& origin) {
    Eye here;
    here.viewFromWorld = glm::translate(glm::dmat4(1.0), -origin);
    const gpu::LightData data = lightData(placed, here);
    TracerLight light;
    set(light.position, glm::dvec3(data.position));
    set(light.direction, glm::dvec3(data.direction));
    set(light.color, glm::dvec3(data.color));
    light.w = data.position.w;
    light.inverseRange2 = data.direction.w;
    light.intensity = data.color.w;
    light.coneScale = data.cone.x;
    light.coneOffset = data.cone.y;
    return light;
}

std::vector<LightsReach> reachOf(const std::vector<TracerLight>& lights) {
    std::vector<LightsReach> all;
    for (std::size_t l = 0; l < lights.size(); ++l) {
        const TracerLight& light = lights[l];
        addReach(all, l, {light.position[0], light.position[1], light.position[2]},
                 light.w != 0.0f ? light.inverseRange2 : 0.0f);
    }
    return all;
}

}  // namespace

TraceTile* traceTileHere() {
    return forThisProcessor(traceTileBaseline, traceTileAvx2, traceTileAvx512);
}

void makeColorsConstant(Scene& scene) {
    for (Material& material : scene.materials) {
        material.baseColorTexture = material.metallicRoughnessTexture = material.normalTexture =
            material.occlusionTexture = material.emissiveTexture = {};
    }
    for (Mesh& mesh : scene.meshes) {
        for (Primitive& primitive : mesh.primitives) primitive.hasColors = false;
    }
}

TracerSettings tracerSettings(const FrameSettings& settings) {
    TracerSettings made;
    made.width = settings.width;
    made.height = settings.height;
    made.shadows = settings.shadows;
    made.background = settings.background;
    made.ambientSky = settings.ambientSky;
    made.ambientGround = settings.ambientGround;
    return made;
}

Tracer::Tracer(const TracerScene& scene, const TracerSettings& settings, TraceTile* traceTile)
    : scene_(scene),
      settings_(settings),
      traceTile_(traceTile),
      radiance_(4 * std::size_t(settings.width) * std::size_t(settings.height)) {}

void Tracer::run(const Moment& moment, const PlacedCamera& camera, FramePixels* samples) {
    TracerFrame frame;
    scene_.describe(frame);
    frame.width = settings_.width;
    frame.height = settings_.height;
    frame.shadows = settings_.shadows;
    frame.offset = settings_.offset;
    aim(makeEye(camera, frame.width, frame.height), scene_.origin(), frame);
    std::vector<TracerLight> lights;
    for (const PlacedLight& light : moment.lights) {
        if (isOn(light.light)) lights.push_back(tracerLight(light, scene_.origin()));
    }
    const std::vector<LightsReach> reach = reachOf(lights);
    frame.lights = lights.data();
    frame.reach = reach.data();
    frame.lightCount = int(lights.size());
    set(frame.ambientSky, settings_.ambientSky);
    set(frame.ambientGround, settings_.ambientGround);
    set(frame.background, settings_.background);
    frame.radiance = radiance_.data();
    const std::size_t pixels = radiance_.size() / 4;
    std::vector<std::uint8_t> reaches(samples ? lights.size() * pixels : 0);
    if (samples) {
        samples->seen.triangles.resize(pixels);
        frame.reaches = reaches.data();
        frame.seen = samples->seen.triangles.data();
    }
    const int columns = (frame.width + kTracerTile - 1) / kTracerTile;
    const int rows = (frame.height + kTracerTile - 1) / kTracerTile;
    tbb::parallel_for(0, columns * rows,
                      [&](int tile) { traceTile_(frame, tile % columns * kTracerTile, tile / columns * kTracerTile); });
    if (!samples) return;
    auto plane = reaches.begin();
    for (const PlacedLight& light : moment.lights) {
        LightPlanes& planes = samples->lights.emplace_back();
        planes.id = light.id;
        planes.reaches.resize(pixels);
        if (!isOn(light.light)) continue;
        planes.reaches.assign(plane, plane + std::ptrdiff_t(pixels));
        plane += std::ptrdiff_t(pixels);
    }
    for (std::uint32_t& triangle : samples->seen.triangles) {
        triangle = triangle == RTC_INVALID_GEOMETRY_ID ? NO_TRIANGLE : scene_.placedTriangles()[triangle];
    }
    samples->seen.positions = {glm::vec2(0.5f)};
}

const std::vector<float>& Tracer::trace(const Moment& moment, const PlacedCamera& camera) {
    run(moment, camera, nullptr);
    return radiance_;
}

FramePixels Tracer::traceSamples(const Moment& moment, const PlacedCamera& camera) {
    FramePixels samples;
    run(moment, camera, &samples);
    samples.radiance = radiance_;
    return samples;
}

}  // namespace umbrage
