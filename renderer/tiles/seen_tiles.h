// SPDX-License-Identifier: Apache-2.0
// What is seen in a picture, stored as the tile counter reads it (count_band.h).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "tiles/count_band.h"

namespace umbrage {

/// One sample of every pixel of a G-buffer, rows from the top.
struct SeenPicture {
    std::span<const std::uint32_t> triangles;
    std::span<const float> depths;  // of the depth buffer
    std::uint32_t noTriangle = 0;   // these and what lies at `emptyDepth` are lit by nothing
    float emptyDepth = 0.0f;
    double depthScale = 1.0, depthOffset = 0.0;  // to depths as PixelFunction has them
    std::span<const glm::vec4> planes;           // per triangle, in view space
    std::span<const glm::uvec2> facing;  // per triangle: bits of the lights that its front (x) and its back (y) face
};

class SeenTiles {
public:
    SeenTiles(int width, int height);

    int columns() const { return columns_; }  // of blocks
    int rows() const { return rows_; }
    std::size_t pixelCount() const { return depths_.size(); }  // with those beyond its edges
    std::size_t pixelsOfPicture() const { return std::size_t(width_) * std::size_t(height_); }

    /// A surface's depth is its plane's, where interpolated depth has lost bits (T9); the depth buffer keeps planes
    /// seen edge-on from running away. As eyeDistance() in shaders/gbuffer.glsl.
    void set(const SeenPicture& picture, const TileEye& eye);

    const float* depths() const { return depths_.data(); }
    /// Bits of lights that what is seen faces; nothing beyond the picture's edges does.
    const std::uint32_t* lit() const { return lit_.data(); }
    /// Around what some light may light, tile by tile as pixels are stored.
    const TileBox* boxes() const { return boxes_.data(); }

    /// Where a pixel of the picture is stored.
    std::size_t indexOf(int column, int row) const;

    /// Whether something is before what is seen anywhere between two places of the picture: that any light may light.
    bool isBefore(const glm::dvec2& low, const glm::dvec2& high, float depth) const;

    /// As if every light could light everything, for counts that are shown.
    void lightAll();

    /// Rows from the top, of values that are stored tile by tile.
    template <class T>
    void toRows(const T* tiles, T* rows) const;

private:
    /// Calls visit(index of its first pixel here, its column in the picture, how many pixels of it are in it) for each
    /// tile that a row of pixels runs through.
    template <class Visit>
    void forTilesOfRow(int y, const Visit& visit) const;
    void findBounds();

    int width_, height_, columns_, rows_;
    TileEye eye_;
    std::vector<float> depths_;
    std::vector<std::uint32_t> lit_;
    std::vector<float> farthest_;  // in each tile, of what some light may light; rows of tiles from the top
    std::vector<TileBox> boxes_;
    int tileColumns_;
};

}  // namespace umbrage
