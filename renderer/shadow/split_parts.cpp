// SPDX-License-Identifier: Apache-2.0
#include "shadow/split_parts.h"

#include <algorithm>

namespace umbrage {

static_assert(float(int(SplitPoints::Kind::PointPointLight)) == float(SPLIT_POINT_POINT) &&
              float(int(SplitPoints::Kind::Nowhere)) == float(SPLIT_NOWHERE));

void SplitParts::setClusters(std::vector<std::uint32_t> ofPlacedTriangle, std::uint32_t clusterCount) {
    clusters_ = std::move(ofPlacedTriangle);
    clusterCount_ = clusterCount;
    clusterBuffer_ = gpu::Buffer::of("clusters of triangles", std::span<const std::uint32_t>(clusters_));
}

void SplitParts::set(std::span<const LightParts> lights, std::uint32_t firstLight, const Eye& eye) {
    firstLight_ = firstLight;
    partsPerLight_ = 0;
    for (const LightParts& light : lights) {
        partsPerLight_ = std::max(partsPerLight_, std::uint32_t(light.parts.size()));
    }
    partOf_.clear();
    host.assign(lights.size() * partsPerLight_, {});
    for (std::size_t l = 0; l < lights.size(); ++l) {
        const auto first = std::uint32_t(l) * partsPerLight_;
        for (const std::uint32_t part : lights[l].ofCluster) partOf_.push_back(first + part);
        for (std::size_t p = 0; p < lights[l].parts.size(); ++p) {
            const SplitPoints& made = lights[l].parts[p];
            for (int k = 0; k < 2; ++k) {
                host[first + p].points[k] = gpu::vec4(eye.viewFromWorld * glm::dvec4(made.points[k], 1.0));
            }
            host[first + p].points[1].w = float(int(made.kind));
        }
    }
    partOfBuffer_.reserve("parts of clusters", partOf_.size() * sizeof(std::uint32_t));
    partOfBuffer_.write(std::span<const std::uint32_t>(partOf_));
    parts_.reserve("split parts", host.size() * sizeof(gpu::SplitPart));
}

void SplitParts::begin() {
    for (gpu::SplitPart& part : host) part.eyeInside[SPLIT_PASS] = part.eyeInside[SPLIT_FAIL] = part.hazards = 0;
    upload();
    if (host.empty()) return;
    parts_.bindStorage(BIND_PARTS);
    planes_.uniform(0, GLuint(host.size()));
    planes_.uniform(1, partsPerLight_);
    planes_.uniform(2, firstLight_);
    planes_.dispatchGroups(GLuint((host.size() + CHUNK_SIZE - 1) / CHUNK_SIZE));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void SplitParts::bind() const {
    parts_.bindStorage(BIND_PARTS);
    partOfBuffer_.bindStorage(BIND_PART_OF);
    clusterBuffer_.bindStorage(BIND_CLUSTERS);
}

void SplitParts::read() {
    if (!host.empty()) parts_.read(0, host.size() * sizeof(gpu::SplitPart), host.data());
}

void SplitParts::upload() {
    parts_.write(std::span<const gpu::SplitPart>(host));
}

}  // namespace umbrage
