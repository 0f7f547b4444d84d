// SPDX-License-Identifier: Apache-2.0
#include "shading/host_resolve.h"

#include <tbb/parallel_for.h>

#include "instruction_set.h"

namespace umbrage {
namespace {

std::vector<LightsReach> reachOf(std::span<const gpu::LightData> lights) {
    std::vector<LightsReach> all;
    for (std::size_t l = 0; l < lights.size(); ++l) {
        addReach(all, l, glm::vec3(lights[l].position), lights[l].position.w != 0.0f ? lights[l].direction.w : 0.0f);
    }
    return all;
}

}  // namespace

std::vector<float> HostResolve::shade(const Input& input) {
    const GBuffer& gbuffer = input.gbuffer;
    const int width = gbuffer.width(), height = gbuffer.height();
    const std::size_t pixels = std::size_t(width) * std::size_t(height), padded = pixels + kShadeLanes;
    const auto read = [&](int attachment, std::size_t words, GLenum format, GLenum type,
                          std::vector<std::uint32_t>& to) {
        to.resize(words * padded);
        gbuffer.readColor(attachment, format, type, words * pixels * sizeof(std::uint32_t), to.data());
    };
    read(1, 2, GL_RGBA, GL_UNSIGNED_SHORT, baseColor_);
    read(2, 1, GL_RG, GL_UNSIGNED_SHORT, normal_);
    read(3, 1, GL_RGBA, GL_UNSIGNED_BYTE, properties_);
    if (input.emissive) read(4, 2, GL_RGBA, GL_HALF_FLOAT, emissive_);
    const std::size_t groups = (input.lights.size() + LIGHTS_PER_GROUP - 1) / LIGHTS_PER_GROUP;
    dark_.resize(groups);
    std::vector<const std::uint32_t*> facing(groups);
    for (std::size_t g = 0; g < groups; ++g) {
        dark_[g].resize(padded);
        input.masks.read(std::uint32_t(g), dark_[g]);
        facing[g] = reinterpret_cast<const std::uint32_t*>(input.silhouettes.hostFacing.data() +
                                                           g * input.silhouettes.facingStride);
    }
    const std::vector<LightsReach> reach = reachOf(input.lights);
    ShadeRowFunction* const shadeRow = forThisProcessor(shadeRowBaseline, shadeRowAvx2, shadeRowAvx512);
    std::vector<float> radiance(4 * pixels);
    tbb::parallel_for(0, height, [&](int y) {
        const std::size_t first = std::size_t(y) * std::size_t(width);
        std::vector<const std::uint32_t*> dark;
        for (const std::vector<std::uint32_t>& of : dark_) dark.push_back(of.data() + first);
        ShadeRow row;
        row.y = y, row.width = width;
        row.view = &input.view, row.lights = input.lights.data(), row.reach = reach.data();
        row.triangles = input.seen.triangles.data() + first, row.depths = input.seen.depths.data() + first;
        row.baseColor = baseColor_.data() + 2 * first, row.normal = normal_.data() + first;
        row.properties = properties_.data() + first;
        row.emissive = input.emissive ? emissive_.data() + 2 * first : nullptr;
        row.dark = dark.data(), row.facing = facing.data();
        row.planes = reinterpret_cast<const float*>(input.silhouettes.hostPlanes.data());
        row.radiance = radiance.data() + 4 * first;
        shadeRow(row);
    });
    return radiance;
}

}  // namespace umbrage
