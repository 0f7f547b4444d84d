// SPDX-License-Identifier: Apache-2.0
// Scenes, nodes, cameras, lights and materials.
#include <gmock/gmock.h>

#include <numbers>

#include "gltf_builder.h"

namespace umbrage {
namespace {

using testing::ElementsAre;

std::vector<std::string> paths(const Scene& scene) {
    std::vector<std::string> result;
    for (const Node& node : scene.nodes) {
        result.push_back(node.path);
    }
    return result;
}

class GltfNodes : public testing::Test {
protected:
    void nodes(const json& list) { builder.document["nodes"] = list; }
    json& node(std::size_t i) { return builder.document["nodes"][i]; }

    GltfBuilder builder;
};

TEST_F(GltfNodes, PathsAreUniqueAndParentsComeFirst) {
    nodes({{{"name", "Child"}},
           {{"name", "Root"}, {"children", {3, 0, 2, 4}}},
           {{"name", "Child"}},
           {{"name", "Child_1"}},
           json::object(),
           {{"name", "Root"}},
           {{"name", "a/b"}}});
    const Scene scene = builder.load();
    EXPECT_THAT(paths(scene), ElementsAre("/Root", "/Root/Child_1", "/Root/Child", "/Root/Child_2", "/Root/node4",
                                          "/Root_1", "/a_b"));
    EXPECT_THAT(scene.nodes[0].children, ElementsAre(1, 2, 3, 4));
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        EXPECT_LT(scene.nodes[i].parent, static_cast<Index>(i));
    }
}

TEST_F(GltfNodes, ASceneIsChosenByNameThenByIndexThenByDefault) {
    nodes({{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}});
    builder.document["scenes"] = {
        {{"nodes", {0}}}, {{"name", "second"}, {"nodes", {1}}}, {{"name", "0"}, {"nodes", {2}}}};
    EXPECT_THAT(paths(builder.load()), ElementsAre("/a"));
    builder.document["scene"] = 1;
    EXPECT_THAT(paths(builder.load()), ElementsAre("/b"));
    EXPECT_THAT(paths(builder.load({.scene = "0"})), ElementsAre("/c"));
    EXPECT_THAT(paths(builder.load({.scene = "second"})), ElementsAre("/b"));
    EXPECT_THAT(paths(builder.load({.scene = "2"})), ElementsAre("/c"));
    expectGltfError(builder, "/scenes", R"(there is no scene "third")", {.scene = "third"});
    expectGltfError(builder, "/scenes", R"(1 "second")", {.scene = "3"});
    builder.document["scene"] = 3;
    expectGltfError(builder, "/scene", "names scene 3");
}

TEST_F(GltfNodes, WithoutScenesAllRootsAreKept) {
    nodes({{{"name", "a"}}, {{"name", "b"}}});
    EXPECT_THAT(paths(builder.load()), ElementsAre("/a", "/b"));
    expectGltfError(builder, "/scenes", "the file has no scenes", {.scene = "0"});
}

TEST_F(GltfNodes, WhatIsNotAForestIsAnError) {
    nodes({{{"children", {1}}}, {{"children", {0}}}});
    expectGltfError(builder, "/nodes/0", "own ancestor");
    nodes({{{"children", {0}}}});
    expectGltfError(builder, "/nodes/0", "own ancestor");
    nodes({{{"children", {2}}}, {{"children", {2}}}, json::object()});
    expectGltfError(builder, "/nodes/1/children/0", "node 2 already is a child of node 0");
    nodes({{{"children", {1, 1}}}, json::object()});
    expectGltfError(builder, "/nodes/0/children/1", "already");
    nodes({{{"children", {5}}}});
    expectGltfError(builder, "/nodes/0/children/0", "names node 5");
    nodes({{{"children", {1}}}, json::object()});
    builder.document["scenes"] = {{{"nodes", {1}}}};
    expectGltfError(builder, "/scenes/0/nodes/0", "cannot be a scene's root");
    builder.document["scenes"] = {{{"nodes", {0, 0}}}};
    expectGltfError(builder, "/scenes/0/nodes/1", "twice");
}

TEST_F(GltfNodes, AHundredThousandSiblingsOfOneNameLoadQuickly) {
    json list = json::array();
    for (int i = 0; i < 100000; ++i) {
        list.push_back({{"name", "same"}});
    }
    nodes(list);
    EXPECT_EQ(builder.load().nodes.back().path, "/same_99999");
}

TEST_F(GltfNodes, AnEndlessChainIsAnErrorInsteadOfPathsThatFillTheMemory) {
    json list = json::array();
    for (int i = 0; i < 30000; ++i) {
        list.push_back({{"children", {i + 1}}});
    }
    list.push_back(json::object());
    nodes(list);
    try {
        builder.load();
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(e.where().find("/nodes/"), std::string::npos);
        EXPECT_NE(e.message().find("more bytes of memory"), std::string::npos);
    }
}

TEST_F(GltfNodes, TransformsAreMatricesOrParts) {
    nodes({{{"matrix", {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1}}},
           {{"translation", {1, 2, 3}}, {"rotation", {0, 0, 0, 2}}, {"scale", {-1, 2, 0}}}});
    const Scene scene = builder.load();
    ASSERT_TRUE(scene.nodes[0].matrix);
    EXPECT_EQ((*scene.nodes[0].matrix)[3], glm::dvec4(10, 11, 12, 1));
    EXPECT_FALSE(scene.nodes[1].matrix);
    EXPECT_EQ(scene.nodes[1].scale, glm::dvec3(-1, 2, 0));
    EXPECT_EQ(scene.nodes[1].rotation, glm::dquat(1, 0, 0, 0));
    EXPECT_TRUE(hasNote(scene, "/nodes/1/rotation"));
}

TEST_F(GltfNodes, FaultyTransformsAreErrorsAtTheirPlace) {
    nodes(json::array({json::object()}));
    const auto expect = [&](const char* key, const json& value, const std::string& pointer, const std::string& words) {
        node(0) = {{key, value}};
        expectGltfError(builder, "/nodes/0/" + pointer, words);
    };
    expect("rotation", {0, 0, 0, 0}, "rotation", "zero quaternion");
    expect("rotation", {0, 0, 1}, "rotation", "4 numbers");
    expect("translation", {0, 0, "x"}, "translation/2", "must be a number");
    expect("scale", {1, 1, 1e200}, "scale/2", "a float can hold");
    expect("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}, "matrix", "last row");
    expect("matrix", {1}, "matrix", "16 numbers");
    expect("mesh", 0, "mesh", "names mesh 0");
    expect("skin", 0, "skin", "names skin 0");
    expect("camera", 0, "camera", "names camera 0");
    node(0) = {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"scale", {1, 1, 1}}};
    expectGltfError(builder, "/nodes/0/scale", "either a matrix");
}

TEST_F(GltfNodes, JointsOutsideTheSceneKeepTheirTransformsOnly) {
    builder.triangle();
    builder.primitive()["attributes"]["JOINTS_0"] =
        builder.accessor<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12), 3);
    builder.primitive()["attributes"]["WEIGHTS_0"] = builder.vec4s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    nodes({{{"name", "Body"}, {"mesh", 0}, {"skin", 1}},
           {{"name", "Outside"}, {"mesh", 0}, {"children", {2, 3}}},
           {{"name", "Joint"}, {"mesh", 0}},
           {{"name", "Unneeded"}}});
    builder.document["skins"] = {{{"joints", {3}}}, {{"joints", {2}}}};
    builder.document["animations"] = {
        {{"samplers", {{{"input", builder.scalars({0})}, {"output", builder.vec3s({1, 2, 3})}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
           {{"sampler", 0}, {"target", {{"node", 3}, {"path", "scale"}}}}}}}};
    const Scene scene = builder.load();
    EXPECT_THAT(paths(scene), ElementsAre("/Body", "/Outside", "/Outside/Joint"));
    EXPECT_EQ(scene.nodes[0].mesh, 0);
    EXPECT_EQ(scene.nodes[1].mesh, kNone);
    EXPECT_EQ(scene.nodes[2].mesh, kNone);
    ASSERT_EQ(scene.skins.size(), 1);
    EXPECT_EQ(scene.nodes[0].skin, 0);
    EXPECT_THAT(scene.skins[0].joints, ElementsAre(2));
    ASSERT_EQ(scene.animations[0].channels.size(), 1) << "the channel of a node that is not kept must go";
    EXPECT_EQ(scene.animations[0].channels[0].node, 2);
}

TEST_F(GltfNodes, CamerasOfBothKindsAreLoaded) {
    builder.document["cameras"] = {
        {{"type", "perspective"}, {"name", "p"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"aspectRatio", 2}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", -3}, {"znear", 0}, {"zfar", 9}}}}};
    nodes({{{"camera", 1}}});
    const Scene scene = builder.load();
    ASSERT_EQ(scene.cameras.size(), 2);
    EXPECT_TRUE(scene.cameras[0].perspective);
    EXPECT_EQ(scene.cameras[0].yfov, 0.5);
    EXPECT_EQ(scene.cameras[0].zfar, 0.0);
    EXPECT_FALSE(scene.cameras[1].perspective);
    EXPECT_EQ(scene.cameras[1].ymag, 3.0);
    EXPECT_EQ(scene.nodes[0].camera, 1);
}

TEST_F(GltfNodes, CameraValuesAreChecked) {
    const auto expect = [&](const char* type, const json& lens, const std::string& pointer, const std::string& words) {
        builder.document["cameras"] = {{{"type", type}, {type, lens}}};
        expectGltfError(builder, "/cameras/0/" + pointer, words);
    };
    expect("perspective", {{"yfov", 0}, {"znear", 1}}, "perspective/yfov", "between 0 and pi");
    expect("perspective", {{"yfov", 3.2}, {"znear", 1}}, "perspective/yfov", "between 0 and pi");
    expect("perspective", {{"yfov", 1}, {"znear", 0}}, "perspective/znear", "greater than 0");
    expect("perspective", {{"yfov", 1}, {"znear", 2}, {"zfar", 2}}, "perspective/zfar", "greater than znear");
    expect("perspective", {{"yfov", 1}}, "perspective", "\"znear\" is missing");
    expect("orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}, "orthographic/xmag", "must not be 0");
    expect("orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", -1}, {"zfar", 1}}, "orthographic/znear", "negative");
    expect("orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 1}}, "orthographic", "\"zfar\" is missing");
    expect("fisheye", json::object(), "type", "fisheye");
}

class GltfLights : public GltfNodes {
protected:
    GltfLights() { builder.document["extensionsUsed"] = {"KHR_lights_punctual"}; }
    void lights(const json& list) { builder.document["extensions"]["KHR_lights_punctual"]["lights"] = list; }
};

TEST_F(GltfLights, AllKindsAreLoadedWithTheirDefaults) {
    lights({{{"type", "point"}},
            {{"type", "spot"},
             {"name", "s"},
             {"color", {1, .5, .25}},
             {"intensity", 7},
             {"range", 3},
             {"spot", {{"innerConeAngle", .1}, {"outerConeAngle", .2}}}},
            {{"type", "directional"}, {"range", 3.40282347e38}}});
    nodes({{{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}});
    const Scene scene = builder.load();
    ASSERT_EQ(scene.lights.size(), 3);
    EXPECT_EQ(scene.lights[0].type, LightType::Point);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1.0f));
    EXPECT_EQ(scene.lights[0].intensity, 1.0f);
    EXPECT_EQ(scene.lights[0].rangeMetres, 0.0f);
    EXPECT_EQ(scene.lights[1].type, LightType::Spot);
    EXPECT_EQ(scene.lights[1].color, glm::vec3(1, .5f, .25f));
    EXPECT_EQ(scene.lights[1].innerConeAngle, .1f);
    EXPECT_EQ(scene.lights[1].outerConeAngle, .2f);
    EXPECT_EQ(scene.lights[1].rangeMetres, 3.0f);
    EXPECT_EQ(scene.lights[2].rangeMetres, 0.0f) << "the largest float means unlimited";
    EXPECT_EQ(scene.nodes[0].light, 1);
}

TEST_F(GltfLights, ValuesAreChecked) {
    const std::string light = "/extensions/KHR_lights_punctual/lights/0";
    const auto expect = [&](json value, const std::string& pointer, const std::string& words) {
        if (!value.contains("type")) {
            value["type"] = "point";
        }
        lights(json::array({value}));
        expectGltfError(builder, light + pointer, words);
    };
    expect({{"type", "area"}}, "/type", "area");
    expect({{"intensity", -1}}, "/intensity", "-1");
    expect({{"color", {1, -1, 1}}}, "/color", "negative");
    expect({{"range", 0}}, "/range", "greater than 0");
    expect({{"type", "spot"}}, "", "\"spot\" is missing");
    expect({{"type", "spot"}, {"spot", {{"innerConeAngle", .3}, {"outerConeAngle", .2}}}}, "/spot",
           "inner is 0.3 and outer is 0.2");
    expect({{"type", "spot"}, {"spot", {{"outerConeAngle", 1.6}}}}, "/spot", "pi/2");
    lights({{{"type", "spot"}, {"spot", {{"outerConeAngle", 1.57079637}}}}});
    EXPECT_NO_THROW(builder.load());
    nodes({{{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}});
    expectGltfError(builder, "/nodes/0/extensions/KHR_lights_punctual/light", "names light 1");
}

class GltfMaterials : public testing::Test {
protected:
    GltfMaterials() {
        const json image = {{"uri", "data:image/png;base64,AAAA"}};
        builder.document["images"] = {image, image};
        builder.document["textures"] = {{{"source", 0}}, {{"source", 1}, {"sampler", 0}}};
        builder.document["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9984}}};
    }
    void material(const json& value) { builder.document["materials"] = json::array({value}); }

    GltfBuilder builder;
};

TEST_F(GltfMaterials, EveryCorePropertyIsLoaded) {
    material(
        {{"name", "m"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {.1, .2, .3, .4}},
           {"metallicFactor", .5},
           {"roughnessFactor", .6},
           {"baseColorTexture", {{"index", 0}}},
           {"metallicRoughnessTexture", {{"index", 1}, {"texCoord", 1}}}}},
         {"normalTexture", {{"index", 1}, {"scale", -2}}},
         {"occlusionTexture", {{"index", 0}, {"strength", .7}}},
         {"emissiveTexture", {{"index", 1}}},
         {"emissiveFactor", {.5, 1, 0}},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}, {"KHR_materials_unlit", json::object()}}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", .3},
         {"doubleSided", true}});
    const Material material = builder.load().materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(.1f, .2f, .3f, .4f));
    EXPECT_EQ(material.metallic, .5f);
    EXPECT_EQ(material.roughness, .6f);
    EXPECT_EQ(material.baseColorTexture.texture, 0);
    EXPECT_EQ(material.metallicRoughnessTexture.texCoordSet, 1);
    EXPECT_EQ(material.normalScale, -2.0f);
    EXPECT_EQ(material.occlusionStrength, .7f);
    EXPECT_EQ(material.emissive, glm::vec3(2, 4, 0));
    EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(material.alphaCutoff, .3f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(material.unlit);
}

TEST_F(GltfMaterials, DefaultsAreThoseOfTheSpecification) {
    material(json::object());
    const Material material = builder.load().materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(1.0f));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.emissive, glm::vec3(0.0f));
    EXPECT_EQ(material.alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(material.baseColorTexture.texture, kNone);
    EXPECT_FALSE(material.doubleSided || material.unlit);
}

TEST_F(GltfMaterials, SamplersAreTranslated) {
    const Scene scene = builder.load();
    EXPECT_EQ(scene.textures[0].sampler, Sampler{});
    const Sampler& sampler = scene.textures[1].sampler;
    EXPECT_EQ(sampler.wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(sampler.wrapT, Wrap::MirroredRepeat);
    EXPECT_EQ(sampler.magnify, Filter::Nearest);
    EXPECT_EQ(sampler.minify, Filter::Nearest);
    EXPECT_EQ(sampler.betweenMipmaps, Filter::Nearest);
    builder.document["samplers"][0]["minFilter"] = 9729;
    EXPECT_EQ(builder.load().textures[1].sampler.betweenMipmaps, std::nullopt);
    EXPECT_EQ(builder.load().textures[1].sampler.minify, Filter::Linear);
    builder.document["samplers"][0]["wrapS"] = 1;
    expectGltfError(builder, "/samplers/0/wrapS", "none of 33071, 33648, 10497");
}

TEST_F(GltfMaterials, TextureTransformsBecomeMatricesAndMayChooseTheSet) {
    material(
        {{"emissiveTexture",
          {{"index", 0},
           {"extensions",
            {{"KHR_texture_transform",
              {{"offset", {.5, .25}}, {"rotation", std::numbers::pi / 2}, {"scale", {2, 3}}, {"texCoord", 1}}}}}}}});
    const TextureUse use = builder.load().materials.at(0).emissiveTexture;
    EXPECT_EQ(use.texCoordSet, 1);
    // Worked out by hand from the extension: u' = 3 v + 0.5, v' = -2 u + 0.25.
    const glm::vec2 uv = use.uvFromTexCoord * glm::vec3(.1f, .2f, 1.0f);
    EXPECT_NEAR(uv.x, 1.1f, 1e-6f);
    EXPECT_NEAR(uv.y, 0.05f, 1e-6f);
}

TEST_F(GltfMaterials, TexturesThatCannotBeUsedAreLeftOutWithANote) {
    builder.document["textures"].push_back({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
    material({{"normalTexture", {{"index", 2}}}, {"emissiveTexture", {{"index", 0}, {"texCoord", 2}}}});
    const Scene scene = builder.load();
    EXPECT_EQ(scene.materials[0].normalTexture.texture, kNone);
    EXPECT_EQ(scene.materials[0].emissiveTexture.texture, kNone);
    EXPECT_TRUE(hasNote(scene, "without an image"));
    EXPECT_TRUE(hasNote(scene, "texture coordinate set 2"));
}

TEST_F(GltfMaterials, WebpWinsOverItsFallback) {
    builder.document["textures"][0]["extensions"]["EXT_texture_webp"] = {{"source", 1}};
    EXPECT_EQ(builder.load().textures[0].image, 1);
    builder.document["textures"][0]["extensions"]["EXT_texture_webp"] = {{"source", 2}};
    expectGltfError(builder, "/textures/0/extensions/EXT_texture_webp/source", "names image 2");
}

TEST_F(GltfMaterials, FactorsOutOfRangeAreClampedWithANote) {
    material({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}, {"emissiveFactor", {3, 0, 0}}});
    const Scene scene = builder.load();
    EXPECT_EQ(scene.materials[0].metallic, 1.0f);
    EXPECT_EQ(scene.materials[0].emissive, glm::vec3(1, 0, 0));
    EXPECT_TRUE(hasNote(scene, "/materials/0/pbrMetallicRoughness/metallicFactor: 1.5 is out of range"));
}

TEST_F(GltfMaterials, FaultyReferencesAndTypesAreErrorsAtTheirPlace) {
    material({{"normalTexture", {{"index", 2}}}});
    expectGltfError(builder, "/materials/0/normalTexture/index", "names texture 2");
    material({{"alphaMode", "GLASS"}});
    expectGltfError(builder, "/materials/0/alphaMode", "GLASS");
    material({{"emissiveFactor", {1, 1}}});
    expectGltfError(builder, "/materials/0/emissiveFactor", "3 numbers");
    builder.document.erase("materials");
    builder.document["textures"][0]["source"] = 5;
    expectGltfError(builder, "/textures/0/source", "names image 5");
    builder.document["textures"][0]["source"] = 0;
    builder.document["images"][0] = json::object();
    expectGltfError(builder, "/images/0", "either a \"uri\" or a \"bufferView\"");
    builder.document["images"][0] = {{"bufferView", builder.view<std::uint8_t>({1, 2, 3})}, {"mimeType", "image/jpeg"}};
    const Scene scene = builder.load();
    EXPECT_EQ(scene.images[0].encoded.size(), 3);
    EXPECT_EQ(scene.images[0].mimeType, "image/jpeg");
}

}  // namespace
}  // namespace umbrage
