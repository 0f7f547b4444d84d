// SPDX-License-Identifier: Apache-2.0
#include "shadow/sides.h"

#include <algorithm>

namespace umbrage {

void QuadPattern::bind(std::size_t quadCount) {
    const std::size_t indexCount = 6 * quadCount;
    if (indices_.sizeBytes() < indexCount * sizeof(std::uint32_t)) {
        std::vector<std::uint32_t> indices;
        indices.reserve(indexCount);
        for (std::uint32_t q = 0; q < quadCount; ++q) {
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(4 * q + corner);
        }
        indices_ = gpu::Buffer::of("quad pattern", std::span<const std::uint32_t>(indices));
        vertexArray_.elements(indices_);
    }
    vertexArray_.bind();
}

void ListedSides::upload(std::span<const std::vector<std::uint32_t>> lists, Silhouettes& out) {
    for (std::size_t list = 0; list < lists.size(); ++list) {
        const std::size_t kept = std::min<std::size_t>(lists[list].size(), out.capacity);
        out.quads.write(list * out.capacity * sizeof(std::uint32_t), kept * sizeof(std::uint32_t), lists[list].data());
    }
}

void ListedSides::draw(const SideList& sides) {
    pattern_.bind(sides.silhouettes.capacity);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, sides.silhouettes.summaries.name());
    const std::size_t offset = sides.l * sizeof(gpu::LightSummary) + offsetof(gpu::LightSummary, lists) +
                               sides.list * sizeof(gpu::DrawCommand);
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

void EverySide::draw(const SideList& sides, const gpu::Program& program, int times) {
    setEveryEdgeUniforms(sides, program);
    pattern_.bind(sides.geometry.placedEdgeCount());
    glDrawElementsInstanced(GL_TRIANGLES, GLsizei(6 * sides.geometry.placedEdgeCount()), GL_UNSIGNED_INT, nullptr,
                            times);
}

void setEveryEdgeUniforms(const SideList& sides, const gpu::Program& program) {
    program.uniform(2, sides.silhouettes.facingBase(sides.group));
    program.uniform(3, sides.l);
    program.uniform(4, sides.list);
}

}  // namespace umbrage
