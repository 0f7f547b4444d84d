// SPDX-License-Identifier: Apache-2.0
#include "textures.h"

#include <algorithm>
#include <functional>

#include "numbers.h"

namespace generator {
namespace {

/// A number in [0, 1) that belongs to a cell of a lattice.
double hash(int x, int y, std::uint64_t seed) {
    std::uint64_t bits = seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(x) * 0xd1b54a32d192ed03u +
                         static_cast<std::uint64_t>(y) * 0x8cb92ba72f3d8dd7u;
    bits = (bits ^ (bits >> 31u)) * 0x7fb5d329728ea185u;
    bits = (bits ^ (bits >> 27u)) * 0x81dadef4bc2dd44du;
    return static_cast<double>((bits ^ (bits >> 33u)) >> 32u) / 4294967296.0;
}

int wrap(int value, int period) {
    return (value % period + period) % period;
}

/// Value noise over [0, 1)^2 that repeats after `cellsX` and `cellsY` cells.
double noise(double u, double v, int cellsX, int cellsY, std::uint64_t seed) {
    const double x = u * cellsX, y = v * cellsY;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const double fx = smooth(x - x0), fy = smooth(y - y0);
    const auto at = [&](int i, int j) { return hash(wrap(x0 + i, cellsX), wrap(y0 + j, cellsY), seed); };
    return mix(mix(at(0, 0), at(1, 0), fx), mix(at(0, 1), at(1, 1), fx), fy);
}

double cloud(double u, double v, int cells, std::uint64_t seed) {
    return 0.55 * noise(u, v, cells, cells, seed) + 0.3 * noise(u, v, 2 * cells, 2 * cells, seed + 1) +
           0.15 * noise(u, v, 4 * cells, 4 * cells, seed + 2);
}

struct Texel {
    double height = 0;  // in texels
    dvec3 color{0};     // sRGB, 0 to 1
    double roughness = 1;
};

/// A block of masonry: its own number, and how far a point is from its joints (0 in the joint, 1 inside).
struct Block {
    int column, row;
    double inside;
};

Block blockAt(double u, double v, int rows, int columns, double joint, std::uint64_t seed) {
    const int row = static_cast<int>(v * rows);
    const double shifted = u * columns + 0.5 * (row % 2) + 0.3 * hash(0, row, seed);
    const int column = wrap(static_cast<int>(std::floor(shifted)), columns);
    const double x = shifted - std::floor(shifted), y = v * rows - row;
    const double edge = std::min(std::min(x, 1 - x) * rows / columns, std::min(y, 1 - y));
    return {column, row, smooth(std::clamp((edge - joint) / joint, 0.0, 1.0))};
}

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255 + 0.5);
}

Surface render(int size, const std::function<Texel(double u, double v)>& at) {
    std::vector<Texel> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) texels.push_back(at((x + 0.5) / size, (y + 0.5) / size));
    Surface surface{{size}, {size}, {size}};
    const auto heightAt = [&](int x, int y) { return texels[wrap(y, size) * size + wrap(x, size)].height; };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Texel& t = texels[y * size + x];
            const dvec3 normal = glm::normalize(
                dvec3(heightAt(x - 1, y) - heightAt(x + 1, y), heightAt(x, y + 1) - heightAt(x, y - 1), 2));
            for (int k = 0; k < 3; ++k) {
                surface.color.rgb.push_back(byteOf(t.color[k]));
                surface.normal.rgb.push_back(byteOf(normal[k] / 2 + 0.5));
                surface.roughness.rgb.push_back(k == 1 ? byteOf(t.roughness) : 0);
            }
        }
    return surface;
}

}  // namespace

Surface pavingStones(int size) {
    return render(size, [size](double u, double v) {
        const Block block = blockAt(u, v, 4, 3, 0.022, 11);
        const double own = hash(block.column, block.row, 12), stains = cloud(u, v, 4, 13), grain = cloud(u, v, 24, 14);
        const double shade = 0.5 + 0.2 * (own - 0.5) + 0.16 * (stains - 0.5) + 0.14 * (grain - 0.5);
        const dvec3 stone = dvec3(1.02, 0.98, 0.92) * shade, joint = dvec3(0.2, 0.19, 0.17);
        return Texel{.height = size / 256.0 * (4 * block.inside + 1.2 * own + 2.2 * grain + 1.5 * stains),
                     .color = glm::mix(joint, stone, block.inside),
                     .roughness = mix(0.95, 0.55 + 0.3 * stains, block.inside)};
    });
}

Surface bricks(int size) {
    return render(size, [size](double u, double v) {
        const Block block = blockAt(u, v, 8, 4, 0.035, 21);
        const double own = hash(block.column, block.row, 22), stains = cloud(u, v, 3, 23), grain = cloud(u, v, 32, 24);
        const dvec3 clay = glm::mix(dvec3(0.5, 0.3, 0.22), dvec3(0.62, 0.43, 0.33), own);
        const dvec3 brick = clay * (0.75 + 0.3 * stains + 0.25 * grain),
                    mortar = dvec3(0.48, 0.45, 0.41) * (0.8 + 0.3 * grain);
        return Texel{.height = size / 256.0 * (3 * block.inside + 1.2 * own + 1.8 * grain),
                     .color = glm::mix(mortar, brick, block.inside),
                     .roughness = 0.8 + 0.15 * grain};
    });
}

Surface planks(int size) {
    return render(size, [size](double u, double v) {
        const int board = static_cast<int>(u * 4);
        const double x = u * 4 - board, own = hash(board, 0, 31);
        const double inside = smooth(std::clamp(std::min(x, 1 - x) / 0.05, 0.0, 1.0));
        const double warp = u + 0.03 * noise(u, v, 4, 4, 32);
        const double grain = 0.6 * noise(warp, v, 40, 3, 33) + 0.4 * noise(warp, v, 90, 6, 34);
        const dvec3 wood = glm::mix(dvec3(0.4, 0.27, 0.17), dvec3(0.58, 0.42, 0.28), 0.5 * own + 0.5 * grain);
        return Texel{.height = size / 256.0 * (3 * inside + 1.2 * grain),
                     .color = wood * mix(0.35, 1, inside),
                     .roughness = 0.6 + 0.3 * grain};
    });
}

}  // namespace generator
