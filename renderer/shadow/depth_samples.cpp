// SPDX-License-Identifier: Apache-2.0
#include "shadow/depth_samples.h"

#include <algorithm>
#include <string>

#include "shaders/shared.h"

namespace umbrage {
namespace {

constexpr std::uint32_t kColumns = 40, kRows = 30;

}  // namespace

DepthSampler::DepthSampler(const gpu::Texture& depthStencil)
    : depthStencil_(depthStencil),
      program_("depth_samples.comp", {}, {"SAMPLES " + std::to_string(depthStencil.size().samples)}),
      depths_("depth samples", kColumns * kRows * sizeof(float)) {}

std::vector<DepthSample> DepthSampler::read() {
    const auto width = std::uint32_t(depthStencil_.size().width), height = std::uint32_t(depthStencil_.size().height);
    depthStencil_.bind(0);
    depths_.bindStorage(BIND_FILL);
    glProgramUniform2ui(program_.name(), 0, kColumns, kRows);
    glProgramUniform2ui(program_.name(), 1, width, height);
    program_.dispatchGroups((kColumns * kRows + CHUNK_SIZE - 1) / CHUNK_SIZE);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::vector<float> depths = depths_.readAll<float>();
    std::vector<DepthSample> samples(depths.size());
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t x = (2 * (i % kColumns) + 1) * width / (2 * kColumns);
        const std::uint32_t y = (2 * (i / kColumns) + 1) * height / (2 * kRows);
        samples[i] = {{(x + 0.5) * 2.0 / width - 1.0, 1.0 - (y + 0.5) * 2.0 / height}, double(depths[i])};
    }
    return samples;
}

}  // namespace umbrage
