// SPDX-License-Identifier: Apache-2.0
// Thousands of damaged copies of a document that uses every part of the loader: each must load or end in an Error.
#include <random>

#include "gltf_builder.h"
#include "scene/moment.h"

namespace umbrage {
namespace {

GltfBuilder everything() {
    GltfBuilder builder;
    builder.triangle();
    json& attributes = builder.primitive()["attributes"];
    attributes["NORMAL"] = builder.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1});
    attributes["TEXCOORD_0"] = builder.accessor<std::uint16_t>("VEC2", {0, 0, 65535, 0, 0, 65535}, 3, true);
    attributes["COLOR_0"] = builder.vec3s({1, 0, 0, 0, 1, 0, 0, 0, 1});
    attributes["JOINTS_0"] = builder.accessor<std::uint8_t>("VEC4", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, 3);
    attributes["WEIGHTS_0"] = builder.vec4s({.5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    builder.primitive()["targets"] = {
        {{"POSITION",
          builder.accessor(
              {{"componentType", kFloatComponent},
               {"count", 3},
               {"type", "VEC3"},
               {"sparse",
                {{"count", 1},
                 {"indices", {{"bufferView", builder.view<std::uint8_t>({1})}, {"componentType", kUnsignedByte}}},
                 {"values", {{"bufferView", builder.view<float>({1, 2, 3})}}}}}})}}};
    builder.primitive()["indices"] = builder.accessor<std::uint16_t>("SCALAR", {0, 1, 2}, 3);
    builder.primitive()["material"] = 0;
    builder.document["images"] = {
        {{"bufferView", builder.view<std::uint8_t>({1, 2, 3, 4})}, {"mimeType", "image/png"}}};
    builder.document["textures"] = {{{"source", 0}, {"sampler", 0}}};
    builder.document["samplers"] = {{{"wrapS", 33071}}};
    builder.document["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"alphaMode", "MASK"}}};
    builder.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"outerConeAngle", .5}}}}};
    builder.document["skins"] = {{{"joints", {1, 2}}}};
    builder.document["nodes"] = {{{"mesh", 0}, {"skin", 0}},
                                 {{"children", {2}}, {"rotation", {0, 0, 0, 1}}},
                                 {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    builder.document["scenes"] = {{{"nodes", {0, 1}}}};
    builder.document["animations"] = {
        {{"samplers",
          {{{"input", builder.scalars({0, 1})}, {"output", builder.vec4s({0, 0, 0, 1, 0, 0, 1, 0})}},
           {{"input", 0}, {"output", builder.scalars({0, 0, 0, 0, 1, 0})}, {"interpolation", "CUBICSPLINE"}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}},
           {{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    builder.document["animations"][0]["samplers"][1]["input"] =
        builder.document["animations"][0]["samplers"][0]["input"];
    return builder;
}

// Writes random bytes, takes pieces out and puts digits where they hurt.
std::string damaged(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); };
    constexpr std::string_view kHurtful = "0123456789-e.,:[]{}\"\\\xff";
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) {
        const std::size_t place = below(bytes.size());
        switch (below(5)) {
            case 0:
                bytes[place] = static_cast<char>(random());
                break;
            case 1:
                bytes[place] = kHurtful[below(kHurtful.size())];
                break;
            case 2:
                bytes.erase(place, 1 + below(8));
                break;
            case 3:
                bytes.insert(place, bytes.substr(below(bytes.size()), below(16)));
                break;
            default:
                bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
                break;
        }
    }
    return bytes;
}

// Digits of the JSON only, so that the document still parses and the validator has to do the work.
std::string withOtherNumbers(std::string text, std::mt19937& random) {
    for (int i = 0; i < 2; ++i) {
        const auto digit = text.find_first_of("0123456789", random() % text.size());
        if (digit != std::string::npos) {
            constexpr const char* kNumbers[] = {"0",          "1",    "2",   "3",    "7",    "-1",  "65535",
                                                "4294967295", "1e30", "0.5", "5126", "5121", "null"};
            text.replace(digit, 1, kNumbers[random() % std::size(kNumbers)]);
        }
    }
    return text;
}

struct Outcome {
    int loaded = 0, refused = 0;
};

void tryLoading(const std::string& bytes, Outcome& outcome) {
    try {
        const Scene scene = loadGltf(asBytes(bytes), "fuzz.gltf");
        std::vector<Index> animations;
        for (std::size_t i = 0; i < scene.animations.size(); ++i) {
            animations.push_back(static_cast<Index>(i));
        }
        const Moment moment = evaluate(scene, animations, 0.5);
        boundsOf(scene, moment);
        ++outcome.loaded;
    } catch (const Error& e) {
        ASSERT_NE(e.where().find("fuzz.gltf"), std::string::npos);
        ++outcome.refused;
    }
}

TEST(GltfFuzz, TheDocumentItselfLoads) {
    const Scene scene = everything().load();
    EXPECT_EQ(scene.animations.at(0).channels.size(), 2);
    EXPECT_EQ(evaluate(scene, std::vector<Index>{0}, 1.0).instances.at(0).morphWeights, std::vector<float>{1.0f});
}

TEST(GltfFuzz, DamagedTextEndsInAnErrorOrLoads) {
    std::mt19937 random(20240601);
    const std::string text = everything().text();
    Outcome outcome;
    for (int i = 0; i < 4000; ++i) {
        tryLoading(damaged(text, random), outcome);
    }
    EXPECT_GT(outcome.loaded, 100);
    EXPECT_GT(outcome.refused, 1000);
}

TEST(GltfFuzz, DamagedBinariesEndInAnErrorOrLoad) {
    std::mt19937 random(20240602);
    const std::string bytes = everything().glb();
    Outcome outcome;
    for (int i = 0; i < 4000; ++i) {
        tryLoading(damaged(bytes, random), outcome);
    }
    EXPECT_GT(outcome.loaded, 100);
    EXPECT_GT(outcome.refused, 1000);
}

TEST(GltfFuzz, OtherNumbersEndInAnErrorOrLoad) {
    std::mt19937 random(20240603);
    const GltfBuilder builder = everything();
    json buffers = json::parse(builder.text())["buffers"];
    const std::string text = builder.document.dump();
    Outcome outcome;
    for (int i = 0; i < 6000; ++i) {
        std::string changed = withOtherNumbers(text, random);
        changed.pop_back();
        tryLoading(changed + ",\"buffers\":" + buffers.dump() + "}", outcome);
    }
    EXPECT_GT(outcome.loaded, 100);
    EXPECT_GT(outcome.refused, 1000);
}

}  // namespace
}  // namespace umbrage
