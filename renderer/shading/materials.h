// SPDX-License-Identifier: Apache-2.0
// Materials on the device: factors in one buffer, textures decoded and uploaded, those that a drawn primitive uses.
#pragma once

#include <vector>

#include "gpu/objects.h"
#include "scene/scene.h"

namespace umbrage {

class Materials {
public:
    /// Decodes the textures on all cores. @throws Error(Input) for an image that cannot be decoded
    explicit Materials(const Scene& scene);

    const Material& material(std::uint32_t entry) const { return materials_[entry]; }

    /// Bits of the textures that it has: 1 << TEXTURE_...
    std::uint32_t texturesOf(std::uint32_t entry) const;

    /// Factors and textures, for the fragments of a primitive.
    void bind(std::uint32_t entry) const;

    /// Entries: the scene's materials, then glTF's default.
    std::size_t count() const { return materials_.size(); }

private:
    std::vector<Material> materials_;  // the scene's, then glTF's default
    std::vector<gpu::Texture> textures_;
    std::vector<std::array<int, 5>> textureOf_;  // per entry: indices of textures_, -1: none
    gpu::Buffer buffer_;
    gpu::Texture white_;
};

}  // namespace umbrage
