// SPDX-License-Identifier: Apache-2.0
// Sheets with every vertex attribute and textures made in code, rendered whole, and what their shading must be:
// formulas of the glTF specification in double, written down once more.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "gpu/context.h"
#include "image/image.h"
#include "scenes.h"

namespace umbrage::test {

using Texel = std::array<std::uint8_t, 4>;

/// An RGBA PNG.
inline Image pngOf(int width, int height, const std::vector<Texel>& texels) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("umbrage-texture-" + std::to_string(::getpid()) + ".png");
    ImageFile picture;
    picture.width = width;
    picture.height = height;
    const char* names[] = {"R", "G", "B", "A"};
    for (int c = 0; c < 4; ++c) {
        picture.channels.push_back({names[c], PixelType::UInt8, texels.front().data() + c, 4});
    }
    codec().write(file, picture);
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove(file);
    Image image;
    image.name = "texture";
    image.mimeType = "image/png";
    image.encoded.resize(bytes.size());
    std::memcpy(image.encoded.data(), bytes.data(), bytes.size());
    return image;
}

/// Sheets facing +Z, seen from +Z.
struct Sheets {
    TestScene test;
    FrameSettings settings;

    Sheets() {
        test.scene.materials.clear();
        test.eye = {0.0, 0.0, 4.0};
        settings.width = 64;
        settings.height = 48;
    }

    /// The square of that half size at z, of columns x columns cells; u runs right and v down, as in glTF.
    Node& add(const Material& material, float halfSize, float z = 0.0f, int columns = 1) {
        Mesh mesh;
        for (int row = 0; row <= columns; ++row) {
            for (int column = 0; column <= columns; ++column) {
                const glm::vec2 uv = glm::vec2(column, row) / float(columns);
                mesh.positions.emplace_back(halfSize * (2.0f * uv.x - 1.0f), halfSize * (1.0f - 2.0f * uv.y), z);
                mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
                mesh.texCoords[0].push_back(uv);
            }
        }
        for (int row = 0; row < columns; ++row) {
            for (int column = 0; column < columns; ++column) {
                const auto corner = std::uint32_t(row * (columns + 1) + column),
                           below = corner + std::uint32_t(columns) + 1;
                for (const std::uint32_t i : {corner, below, below + 1, corner, below + 1, corner + 1}) {
                    mesh.indices.push_back(i);
                }
            }
        }
        Primitive primitive;
        primitive.indexCount = std::uint32_t(mesh.indices.size());
        primitive.vertexCount = std::uint32_t(mesh.positions.size());
        primitive.material = Index(test.scene.materials.size());
        primitive.hasNormals = true;
        mesh.primitives = {primitive};
        test.scene.meshes.push_back(std::move(mesh));
        test.scene.materials.push_back(material);
        Node node;
        node.path = "/sheet" + std::to_string(test.scene.nodes.size());
        node.mesh = Index(test.scene.meshes.size() - 1);
        test.scene.nodes.push_back(node);
        return test.scene.nodes.back();
    }

    Mesh& lastMesh() { return test.scene.meshes.back(); }

    TextureUse texture(int width, int height, const std::vector<Texel>& texels, Filter filter = Filter::Nearest) {
        test.scene.images.push_back(pngOf(width, height, texels));
        Texture texture;
        texture.image = Index(test.scene.images.size() - 1);
        texture.sampler.magnify = texture.sampler.minify = filter;
        if (filter == Filter::Nearest) texture.sampler.betweenMipmaps.reset();
        test.scene.textures.push_back(texture);
        TextureUse use;
        use.texture = Index(test.scene.textures.size() - 1);
        return use;
    }

    FramePixels render(const gpu::Context& context, bool geometry = false) const {
        const Moment moment = evaluate(test.scene, {}, 0.0);
        FrameOutputs outputs;
        outputs.geometry = geometry;
        Statistics statistics;
        return FrameRenderer(test.scene, moment, settings, context)
            .render(moment, test.placedCamera(), outputs, 1, statistics);
    }

    /// Where the ray through a pixel's middle meets the plane z = 0, and the direction from there to the viewer.
    struct Seen {
        glm::dvec3 position, towardsViewer;
    };
    Seen seen(int x, int y) const {
        const Eye eye = makeEye(test.placedCamera(), settings.width, settings.height);
        const glm::dvec2 at =
            glm::dvec2(2.0 * (x + 0.5) / settings.width - 1.0, 1.0 - 2.0 * (y + 0.5) / settings.height) * eye.rayScale;
        const glm::dvec3 origin(eye.worldFromView *
                                (eye.perspective ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(at, 0.0, 1.0)));
        const glm::dvec3 d = glm::normalize(
            glm::dvec3(eye.worldFromView * (eye.perspective ? glm::dvec4(at, -1.0, 0.0) : glm::dvec4(0, 0, -1, 0))));
        return {origin - d * (origin.z / d.z), -d};
    }

    std::size_t index(int x, int y) const { return 4 * std::size_t(y * settings.width + x); }
};

inline glm::dvec3 rgbAt(const std::vector<float>& pixels, std::size_t index) {
    return {pixels[index], pixels[index + 1], pixels[index + 2]};
}

/// Appendix B of the glTF 2.0 specification, times the cosine.
inline glm::dvec3 reflected(const glm::dvec3& baseColor, double metallic, double roughness, const glm::dvec3& n,
                            const glm::dvec3& v, const glm::dvec3& l) {
    constexpr double kPi = 3.14159265358979323846;
    const double nl = glm::dot(n, l), nv = glm::dot(n, v);
    if (nl <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 h = glm::normalize(l + v);
    const double a2 = std::pow(roughness, 4.0), nh = glm::dot(n, h);
    const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
    // Smith's auxiliary function; the two directions' shadowing is correlated by height.
    const auto lambda = [a2](double cosine) {
        return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (cosine * cosine) - 1.0)) - 1.0);
    };
    const double g = 1.0 / (1.0 + lambda(nl) + lambda(nv));
    const double specular = d * g / (4.0 * nl * nv);
    const double fresnel = std::pow(1.0 - glm::dot(v, h), 5.0);
    const glm::dvec3 dielectric = glm::mix(baseColor / kPi, glm::dvec3(specular), 0.04 + 0.96 * fresnel);
    const glm::dvec3 metal = specular * glm::mix(baseColor, glm::dvec3(1.0), fresnel);
    return glm::mix(dielectric, metal, metallic) * nl;
}

/// What a light sends to a surface at p that faces it, and from where (KHR_lights_punctual).
struct Arriving {
    glm::dvec3 strength, direction;
};
inline Arriving arrivingAt(const PlacedLight& placed, const glm::dvec3& p) {
    const Light& light = placed.light;
    const glm::dvec3 color = glm::dvec3(light.color) * double(light.intensity);
    if (light.type == LightType::Directional) return {color, -placed.direction};
    const glm::dvec3 d = placed.position - p;
    const double distance = glm::length(d);
    double share = 1.0 / (distance * distance);
    if (light.rangeMetres > 0.0f) share *= std::max(0.0, 1.0 - std::pow(distance / light.rangeMetres, 4.0));
    if (light.type == LightType::Spot) {
        const double cosine = glm::dot(placed.direction, -d / distance);
        const double inner = std::cos(double(light.innerConeAngle)), outer = std::cos(double(light.outerConeAngle));
        const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
        share *= t * t;
    }
    return {color * share, d / distance};
}

}  // namespace umbrage::test
