// SPDX-License-Identifier: Apache-2.0
// What surfaces look like, against formulas: lights, materials, textures, transparency, samples.
#include <gtest/gtest.h>

#include "sheets.h"
#include "techniques.h"

namespace umbrage::test {
namespace {

/// By the device, and, where that is a processor, without it.
class Shading : public testing::TestWithParam<bool> {
protected:
    void SetUp() override { sheets.settings.resolveOnHost = GetParam(); }

    const gpu::Context& context = test::context();
    Sheets sheets;

    void expectColor(const FramePixels& pixels, int x, int y, const glm::dvec3& expected, double tolerance = 1e-3) {
        const glm::dvec3 is = rgbAt(pixels.radiance, sheets.index(x, y));
        EXPECT_LE(glm::length(is - expected), tolerance * (1.0 + glm::length(expected)))
            << "at " << x << ", " << y << ": " << is.x << " " << is.y << " " << is.z << " instead of " << expected.x
            << " " << expected.y << " " << expected.z;
    }
    void expectColorEverywhere(const FramePixels& pixels, const glm::dvec3& expected, double tolerance = 1e-3) {
        for (int y = 0; y < sheets.settings.height; y += 7) {
            for (int x = 0; x < sheets.settings.width; x += 7) expectColor(pixels, x, y, expected, tolerance);
        }
    }
    /// World-space normal at the middle of the picture.
    glm::dvec3 normal() {
        const FramePixels pixels = sheets.render(context, true);
        return rgbAt(pixels.normalAndDepth, sheets.index(sheets.settings.width / 2, sheets.settings.height / 2));
    }
    /// As a light of every kind sees it: against the formulas, at every pixel.
    void expectLitRight();
};

constexpr float k51 = 51.0f / 255.0f;  // exact in 8 bits

Material plain(const glm::vec3& color, float metallic, float roughness) {
    Material material;
    material.baseColor = glm::vec4(color, 1.0f);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

Material unlit(const glm::vec4& color) {
    Material material;
    material.baseColor = color;
    material.unlit = true;
    material.doubleSided = true;
    return material;
}

void Shading::expectLitRight() {
    const Moment moment = evaluate(sheets.test.scene, {}, 0.0);
    const FramePixels pixels = sheets.render(context);
    const Material& m = sheets.test.scene.materials[0];
    double brightest = 0.0;
    for (int y = 0; y < sheets.settings.height; ++y) {
        for (int x = 0; x < sheets.settings.width; ++x) {
            const auto [p, v] = sheets.seen(x, y);
            glm::dvec3 expected(0.0);
            for (const PlacedLight& light : moment.lights) {
                const auto [strength, l] = arrivingAt(light, p);
                expected += strength * reflected(glm::dvec3(m.baseColor), m.metallic, m.roughness, {0, 0, 1}, v, l);
            }
            brightest = std::max(brightest, expected.g);
            const glm::dvec3 is = rgbAt(pixels.radiance, sheets.index(x, y));
            ASSERT_LE(glm::length(is - expected), 2e-3 * glm::length(expected) + 1e-5)
                << "at " << x << ", " << y << ": " << is.x << " instead of " << expected.x;
        }
    }
    EXPECT_GT(brightest, 0.01) << "nothing was lit";
}

TEST_P(Shading, FollowsTheSpecificationsBrdfForEveryKindOfLightAndCamera) {
    for (const bool perspective : {true, false}) {
        for (const LightType type : {LightType::Point, LightType::Spot, LightType::Directional}) {
            for (const float metallic : {0.0f, k51, 1.0f}) {
                for (const float roughness : {k51, 2 * k51, 1.0f}) {
                    SCOPED_TRACE(testing::Message()
                                 << (perspective ? "perspective" : "orthographic") << ", light " << int(type)
                                 << ", metallic " << metallic << ", roughness " << roughness);
                    sheets = Sheets();
                    sheets.add(plain({0.8f, 0.4f, 0.1f}, metallic, roughness), 100.0f);
                    sheets.test.eye = {1.0, -2.0, 3.0};
                    sheets.test.camera.perspective = perspective;
                    sheets.test.camera.ymag = 1.5;
                    if (!perspective) sheets.test.camera.zfar = 50.0;
                    Node& node = sheets.test.addLight(type, {-1.0, 1.0, 2.0});
                    if (type == LightType::Spot) {
                        node.matrix =
                            glm::inverse(glm::lookAt(glm::dvec3(-1, 1, 2), glm::dvec3(0.3, 0, 0), glm::dvec3(0, 1, 0)));
                        sheets.test.scene.lights[0].innerConeAngle = 0.2f;
                        sheets.test.scene.lights[0].outerConeAngle = 0.6f;
                    }
                    sheets.test.scene.lights[0].color = {1.0f, 0.7f, 0.3f};
                    expectLitRight();
                }
            }
        }
    }
}

TEST_P(Shading, LightEndsAtItsRangeAndSeveralLightsAddUp) {
    sheets.add(plain(glm::vec3(0.5f), 0.0f, 1.0f), 100.0f);
    sheets.test.addLight(LightType::Point, {-0.5, 0.0, 1.0});
    sheets.test.addLight(LightType::Point, {0.7, 0.3, 1.0});
    sheets.test.addLight(LightType::Directional, {0.0, 0.0, 1.0});
    sheets.test.scene.lights[0].rangeMetres = 1.4f;
    sheets.test.scene.lights[2].intensity = 0.01f;
    expectLitRight();
}

TEST_P(Shading, AmbientLightIsMixedByTheNormalsHeightAndDimmedByOcclusion) {
    Material material = plain({0.8f, 0.4f, 0.2f}, 0.0f, 1.0f);
    material.occlusionTexture = sheets.texture(1, 1, {{51, 255, 255, 255}});
    material.occlusionStrength = 0.5f;
    Node& node = sheets.add(material, 100.0f);
    node.rotation = glm::angleAxis(glm::radians(-30.0), glm::dvec3(1, 0, 0));  // its normal is now half up
    sheets.settings.ambientSky = {1.0f, 2.0f, 4.0f};
    sheets.settings.ambientGround = {0.4f, 0.4f, 0.0f};
    const glm::dvec3 ambient = 0.75 * glm::dvec3(1, 2, 4) + 0.25 * glm::dvec3(0.4, 0.4, 0);
    expectColor(sheets.render(context), 32, 24, glm::dvec3(0.8, 0.4, 0.2) * ambient * (1.0 - 0.5 * 0.8), 2e-3);
}

TEST_P(Shading, UnlitSurfacesShowTheirColorWhateverTheLight) {
    sheets.add(unlit({0.25f, 0.5f, 0.75f, 1.0f}), 100.0f);
    sheets.test.addLight(LightType::Point, {0.0, 0.0, 1.0});
    sheets.settings.ambientSky = sheets.settings.ambientGround = glm::vec3(1.0f);
    expectColorEverywhere(sheets.render(context), {0.25, 0.5, 0.75});
}

TEST_P(Shading, VertexColorsMultiplyTheBaseColorLinearly) {
    sheets.add(unlit({0.5f, 1.0f, 1.0f, 1.0f}), 1.0f);
    Mesh& mesh = sheets.lastMesh();
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(p.x > 0.0f ? 1.0f : 0.0f, 0.25f, 1.0f, 1.0f);
    mesh.primitives[0].hasColors = true;
    const FramePixels pixels = sheets.render(context);
    const glm::dvec3 p = sheets.seen(36, 24).position;
    expectColor(pixels, 36, 24, {0.5 * (p.x + 1.0) / 2.0, 0.25, 1.0});
}

TEST_P(Shading, ColorTexturesAreDecodedFromSrgbAndTheRestIsNot) {
    constexpr double kSampler =
        4e-3;  // llvmpipe's decoding is off by up to a third of a percent, a fifth of an 8-bit step
    Material material = unlit({1, 1, 1, 1});
    material.baseColorTexture = sheets.texture(1, 1, {{188, 128, 55, 255}});
    sheets.add(material, 100.0f);
    expectColorEverywhere(sheets.render(context), {0.50289, 0.21586, 0.03820}, kSampler);

    sheets = Sheets();
    material = plain(glm::vec3(0.0f), 0.0f, 1.0f);
    material.emissive = {2.0f, 10.0f, 1.0f};
    material.emissiveTexture = sheets.texture(1, 1, {{188, 128, 55, 255}});
    material.occlusionTexture = sheets.texture(1, 1, {{51, 51, 51, 255}});  // dims no emission
    sheets.add(material, 100.0f);
    expectColorEverywhere(sheets.render(context), {2 * 0.50289, 10 * 0.21586, 0.03820}, kSampler);

    sheets = Sheets();
    material = plain({0.8f, 0.4f, 0.1f}, 1.0f, 1.0f);
    material.metallicRoughnessTexture = sheets.texture(1, 1, {{0, 102, 51, 255}});
    sheets.add(material, 100.0f);
    sheets.test.addLight(LightType::Point, {-1.0, 1.0, 2.0});
    const FramePixels textured = sheets.render(context);
    sheets.test.scene.materials[0] = plain({0.8f, 0.4f, 0.1f}, k51, 2 * k51);
    EXPECT_EQ(textured.radiance, sheets.render(context).radiance);
    expectLitRight();
}

TEST_P(Shading, TextureCoordinatesAreTransformedAndTakenFromTheRightSet) {
    const std::vector<Texel> four = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}};
    Material material = unlit({1, 1, 1, 1});
    material.baseColorTexture = sheets.texture(2, 2, four);
    sheets.add(material, 2.0f);
    Mesh& mesh = sheets.lastMesh();
    for (const glm::vec2& uv : mesh.texCoords[0]) mesh.texCoords[1].push_back(glm::vec2(1.0f) - uv);
    const auto colorsAre = [&](const std::array<glm::dvec3, 4>& colors) {
        const FramePixels pixels = sheets.render(context);
        for (int i = 0; i < 4; ++i) expectColor(pixels, i % 2 ? 42 : 22, i / 2 ? 34 : 14, colors[std::size_t(i)]);
    };
    const glm::dvec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1);
    colorsAre({red, green, blue, white});
    TextureUse& use = sheets.test.scene.materials[0].baseColorTexture;
    use.uvFromTexCoord = glm::mat3x2(1, 0, 0, 1, 0.5f, 0);  // an offset of half a texture
    colorsAre({green, red, white, blue});
    use.uvFromTexCoord = glm::mat3x2(0, 1, 1, 0, 0, 0);  // u and v exchanged
    colorsAre({red, blue, green, white});
    use.uvFromTexCoord = glm::mat3x2(1, 0, 0, 1, 0, 0);
    use.texCoordSet = 1;
    colorsAre({white, blue, green, red});
}

TEST_P(Shading, TexturesAreAsSharpOnTinyTrianglesAsOnLargeOnes) {
    // llvmpipe gives the helper lanes at a triangle's edge zeros from storage buffers; with texture coordinates made
    // from those the smallest mipmap was taken there.
    std::vector<Texel> board;
    for (int i = 0; i < 64 * 64; ++i)
        board.push_back((i / 8 + i / 512) % 2 ? Texel{255, 255, 255, 255} : Texel{0, 0, 0, 255});
    for (const bool lit : {false, true}) {
        std::vector<float> first;
        for (const int columns : {1, 40}) {
            sheets = Sheets();
            Material material = lit ? plain(glm::vec3(1.0f), 0.0f, 1.0f) : unlit({1, 1, 1, 1});
            material.baseColorTexture = sheets.texture(64, 64, board, Filter::Linear);
            material.normalTexture = material.baseColorTexture;
            sheets.add(plain(glm::vec3(0.0f), 0.0f, 1.0f), 0.01f, 3.0f);  // the first material is another one
            sheets.add(material, 1.5f, 0.0f, columns);
            sheets.test.addLight(LightType::Directional, {0.3, 0.3, 1.0});
            const std::vector<float> radiance = sheets.render(context).radiance;
            if (first.empty()) {
                first = radiance;
                continue;
            }
            double worst = 0.0;
            for (std::size_t i = 0; i < first.size(); ++i)
                worst = std::max(worst, std::abs(double(first[i] - radiance[i])));
            EXPECT_LT(worst, 0.02) << (lit ? "lit" : "unlit");
        }
    }
}

TEST_P(Shading, MaskedSurfacesHaveHolesWhereAlphaIsBelowTheCutoff) {
    Material material = unlit({1.0f, 1.0f, 1.0f, 0.8f});
    material.alphaMode = AlphaMode::Mask;
    material.alphaCutoff = 0.4f;
    material.baseColorTexture =
        sheets.texture(2, 2, {{255, 0, 0, 127}, {255, 0, 0, 129}, {255, 0, 0, 0}, {255, 0, 0, 255}});
    sheets.add(material, 2.0f);
    sheets.settings.background = {0.0f, 0.0f, 0.5f};
    const FramePixels pixels = sheets.render(context);
    expectColor(pixels, 22, 14, {0, 0, 0.5});
    expectColor(pixels, 42, 14, {1, 0, 0});
    expectColor(pixels, 22, 34, {0, 0, 0.5});
    expectColor(pixels, 42, 34, {1, 0, 0});
}

TEST_P(Shading, OpaqueSurfacesIgnoreAlpha) {
    sheets.add(unlit({0.5f, 0.5f, 0.5f, 0.1f}), 100.0f);
    expectColorEverywhere(sheets.render(context), glm::dvec3(0.5));
}

TEST_P(Shading, BlendedSurfacesLieOverWhatIsBehindThemInOrderOfDepth) {
    Material blue = unlit({0.0f, 0.0f, 1.0f, 0.5f}), red = unlit({1.0f, 0.0f, 0.0f, 0.25f});
    Material hidden = unlit({1.0f, 1.0f, 1.0f, 0.5f});
    blue.alphaMode = red.alphaMode = hidden.alphaMode = AlphaMode::Blend;
    sheets.add(red, 100.0f, 1.0f);  // the nearest first
    sheets.add(blue, 100.0f, 0.5f);
    sheets.add(hidden, 100.0f, -1.0f);
    sheets.add(unlit({0.0f, 0.8f, 0.0f, 1.0f}), 100.0f);
    const glm::dvec3 over =
        glm::mix(glm::mix(glm::dvec3(0, 0.8, 0), glm::dvec3(0, 0, 1), 0.5), glm::dvec3(1, 0, 0), 0.25);
    expectColorEverywhere(sheets.render(context), over);
}

TEST_P(Shading, BlendedSurfacesAreLitLikeOpaqueOnes) {
    Material material = plain({0.8f, 0.4f, 0.1f}, k51, 2 * k51);
    sheets.add(material, 100.0f);
    sheets.test.addLight(LightType::Point, {-1.0, 1.0, 2.0});
    sheets.settings.ambientSky = sheets.settings.ambientGround = glm::vec3(0.1f);
    const std::vector<float> opaque = sheets.render(context).radiance;
    sheets.test.scene.materials[0].alphaMode = AlphaMode::Blend;
    const std::vector<float> blended = sheets.render(context).radiance;
    for (std::size_t i = 0; i < opaque.size(); ++i) ASSERT_NEAR(opaque[i], blended[i], 2e-3 * opaque[i] + 1e-5) << i;
}

TEST_P(Shading, NormalMapsTiltTheSameWayWithAndWithoutTangents) {
    // (x, y, z) of the map: right and up along the texture. As 8-bit values, 128 is not quite 0.
    const Texel texel{178, 204, 230, 255};
    const glm::dvec3 mapped = glm::normalize(2.0 * glm::dvec3(178, 204, 230) / 255.0 - 1.0);
    struct Case {
        const char* name;
        glm::dvec3 scale;
        double turned;  // about y
        glm::dvec3 expected;
    };
    const glm::dvec3 m = mapped;
    const Case cases[] = {{"as it is", {1, 1, 1}, 0.0, m},
                          {"large", {100, 100, 100}, 0.0, m},
                          {"tiny", {1e-4, 1e-4, 1e-4}, 0.0, m},
                          {"mirrored", {-1, 1, 1}, 0.0, {-m.x, m.y, m.z}},
                          {"from behind", {1, 1, 1}, 180.0, {m.x, -m.y, m.z}}};
    for (const Case& c : cases) {
        for (const bool tangents : {true, false}) {
            SCOPED_TRACE(testing::Message() << c.name << (tangents ? " with tangents" : " without tangents"));
            sheets = Sheets();
            Material material = plain(glm::vec3(1.0f), 0.0f, 1.0f);
            material.doubleSided = true;
            material.normalTexture = sheets.texture(1, 1, {texel});
            Node& node = sheets.add(material, 1.0f);
            node.scale = c.scale;
            node.rotation = glm::angleAxis(glm::radians(c.turned), glm::dvec3(0, 1, 0));
            sheets.test.eye *= std::abs(c.scale.x);
            sheets.test.camera.znear = 0.1 * std::abs(c.scale.x);
            if (tangents) {
                Mesh& mesh = sheets.lastMesh();
                mesh.tangents.assign(mesh.positions.size(), {1, 0, 0, 1});
                mesh.primitives[0].hasTangents = true;
            }
            EXPECT_LT(glm::length(normal() - c.expected), 2e-3);
        }
    }
}

TEST_P(Shading, NormalsAreTurnedToTheViewerOnBackFacesAndFlatWithoutNormals) {
    Material material = plain(glm::vec3(1.0f), 0.0f, 1.0f);
    material.doubleSided = true;
    Node& node = sheets.add(material, 1.0f);
    node.rotation = glm::angleAxis(glm::radians(180.0 - 40.0), glm::dvec3(0, 1, 0));
    const glm::dvec3 front(std::sin(glm::radians(140.0)), 0.0, std::cos(glm::radians(140.0)));
    EXPECT_LT(glm::length(normal() + front), 1e-3);
    sheets.lastMesh().primitives[0].hasNormals = false;
    EXPECT_LT(glm::length(normal() + front), 1e-3);
    sheets.test.scene.nodes[0].scale = {1, 1, -1};  // a mirror image of a sheet is the same sheet from its other side
    EXPECT_LT(glm::length(normal() + front), 1e-3);
}

TEST_P(Shading, SeveralSamplesAPixelGiveTheCoverageOfEdges) {
    if (context.maxSamples() < 4) GTEST_SKIP() << "the device has no 4 samples a pixel";
    Node& node = sheets.add(unlit({1, 1, 1, 1}), 1.0f);
    node.rotation = glm::angleAxis(glm::radians(17.0), glm::dvec3(0, 0, 1));
    sheets.settings.samples = 4;
    const std::vector<float> radiance = sheets.render(context).radiance;
    const Eye eye = makeEye(sheets.test.placedCamera(), sheets.settings.width, sheets.settings.height);
    const double pixelsPerMetre = 0.5 * sheets.settings.height / eye.rayScale.y / 4.0;
    double area = 0.0;
    int partial = 0;
    for (std::size_t i = 0; i < radiance.size(); i += 4) {
        area += radiance[i];
        partial += radiance[i] > 0.0f && radiance[i] < 1.0f;
        ASSERT_NEAR(4.0f * radiance[i], std::round(4.0f * radiance[i]), 1e-5) << "not a number of quarters";
    }
    EXPECT_GT(partial, 60);
    EXPECT_NEAR(area, std::pow(2.0 * pixelsPerMetre, 2.0), 4.0);
}

INSTANTIATE_TEST_SUITE_P(Resolved, Shading, testing::Bool(), [](const auto& parameters) {
    return std::string(parameters.param ? "onTheHost" : "onTheDevice");
});

}  // namespace
}  // namespace umbrage::test
