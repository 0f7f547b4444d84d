// SPDX-License-Identifier: Apache-2.0
// Containers, JSON, versions, extensions: what happens before any mesh is looked at.
#include <gmock/gmock.h>

#include "gltf_builder.h"

namespace umbrage {
namespace {

const std::string kEmpty = R"({"asset":{"version":"2.0"}})";

TEST(GltfDocument, TheSmallestDocumentIsAnEmptyScene) {
    const Scene scene = loadGltf(asBytes(kEmpty), "test.gltf");
    EXPECT_TRUE(scene.nodes.empty());
    EXPECT_TRUE(scene.notes.empty());
}

TEST(GltfDocument, WhatIsNotJsonIsAnErrorWithLineAndColumn) {
    const auto where = [](const std::string& text) -> std::string {
        try {
            loadGltf(asBytes(text), "test.gltf");
        } catch (const Error& e) {
            return e.where();
        }
        return "loaded";
    };
    EXPECT_EQ(where("{\n  \"asset\": oops\n}"), "test.gltf:2:12");
    EXPECT_EQ(where(kEmpty + " x"), "test.gltf:1:" + std::to_string(kEmpty.size() + 2));
    EXPECT_EQ(where(R"({"a": NaN})"), "test.gltf:1:7");
    EXPECT_EQ(where("{\"a\": \"\xff\"}"), "test.gltf:1:8");
    EXPECT_EQ(where("  \n "), "test.gltf:2:2");
}

TEST(GltfDocument, ByteOrderMarksNulBytesEmptyFilesAndNonObjectsAreErrors) {
    expectGltfError("\xEF\xBB\xBF" + kEmpty, "", "byte order mark");
    expectGltfError(kEmpty + std::string("\0{", 2), "", "NUL");
    expectGltfError(std::string(), "", "empty");
    expectGltfError("[]", "", "object");
    expectGltfError(R"({"asset": 1e999})", "", "cannot be read");
}

TEST(GltfDocument, DeepNestingIsFoundBeforeItCanOverflowTheStack) {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    expectGltfError(R"({"asset":{"version":"2.0"},"extras":)" + deep + "}", "", "nested more than 512");
    const std::string inString = R"({"asset":{"version":"2.0","generator":")" + std::string(2000, '[') + "\\\"{\"}}";
    EXPECT_NO_THROW(loadGltf(asBytes(inString), "test.gltf"));
    const std::string fine = std::string(500, '[') + std::string(500, ']');
    EXPECT_NO_THROW(loadGltf(asBytes(R"({"asset":{"version":"2.0"},"extras":)" + fine + "}"), "test.gltf"));
}

TEST(GltfDocument, OnlyVersion2IsRead) {
    expectGltfError("{}", "", "\"asset\" is missing");
    expectGltfError(R"({"asset":{}})", "/asset", "\"version\" is missing");
    expectGltfError(R"({"asset":{"version":2.0}})", "/asset/version", "must be a string");
    expectGltfError(R"({"asset":{"version":"1.0"}})", "/asset/version", "only 2.x");
    expectGltfError(R"({"asset":{"version":"3.7"}})", "/asset/version", "only 2.x");
    expectGltfError(R"({"asset":{"version":"two"}})", "/asset/version", "not a version");
    expectGltfError(R"({"asset":{"version":"2.5","minVersion":"2.5"}})", "/asset/minVersion", "needs glTF");
    EXPECT_NO_THROW(loadGltf(asBytes(R"({"asset":{"version":"2.5","minVersion":"2.0"}})"), "test.gltf"));
}

TEST(GltfDocument, EveryUnsupportedRequiredExtensionIsNamed) {
    GltfBuilder builder;
    builder.document["extensionsUsed"] = {"FOO_a", "FOO_b", "KHR_materials_unlit"};
    builder.document["extensionsRequired"] = builder.document["extensionsUsed"];
    expectGltfError(builder, "/extensionsRequired", R"("FOO_a", "FOO_b")");
    builder.document["extensionsRequired"] = {"KHR_materials_unlit"};
    EXPECT_EQ(builder.load().extensionsIgnored, (std::vector<std::string>{"FOO_a", "FOO_b"}));
}

TEST(GltfDocument, AnUnsupportedOptionalExtensionGetsExactlyOneNote) {
    GltfBuilder builder;
    builder.document["extensionsUsed"] = {"FOO_a", "FOO_a", "KHR_lights_punctual"};
    const Scene scene = builder.load();
    ASSERT_EQ(scene.notes.size(), 1);
    EXPECT_THAT(scene.notes[0], testing::HasSubstr("FOO_a"));
}

TEST(GltfDocument, SupportedExtensionsAreSorted) {
    const auto names = supportedExtensions();
    EXPECT_EQ(names.size(), 7);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(GltfDocument, IntegersWrittenAsFractionsAreErrorsInsteadOfSilentDefaults) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"][0]["mesh"] = 0.0;
    expectGltfError(builder, "/nodes/0/mesh", "must be an integer");
}

class Glb : public testing::Test {
protected:
    Glb() {
        builder.triangle();
        bytes = builder.glb();
    }
    void setWord(std::size_t offset, std::uint32_t value) { std::memcpy(bytes.data() + offset, &value, 4); }
    std::size_t jsonLength() const {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, 4);
        return length;
    }

    GltfBuilder builder;
    std::string bytes;
};

TEST_F(Glb, LoadsTheSameMeshAsTheTextForm) {
    const Scene binary = loadGltf(asBytes(bytes), "test.glb"), text = builder.load();
    ASSERT_EQ(binary.meshes.size(), 1);
    EXPECT_EQ(binary.meshes[0].positions, text.meshes[0].positions);
}

TEST_F(Glb, ContainerFaultsAreErrors) {
    const std::string whole = bytes;
    setWord(4, 1);
    expectGltfError(bytes, "", "version 1 of the .glb container");
    bytes = whole;
    setWord(8, static_cast<std::uint32_t>(whole.size()) + 1);
    expectGltfError(bytes, "", "declares");
    bytes = whole;
    setWord(12, 0x7FFFFFF0);
    expectGltfError(bytes, "", "chunk 0 declares");
    bytes = whole;
    setWord(16, 0x004E4942);
    expectGltfError(bytes, "", "the first chunk");
    bytes = whole;
    setWord(20 + jsonLength(), 0xFFFFFFFC);
    expectGltfError(bytes, "", "chunk 1 declares 4294967292");
    expectGltfError(whole.substr(0, 12), "", "too few");
    for (std::size_t length = 20; length < whole.size(); ++length) {
        EXPECT_THROW(loadGltf(asBytes(whole.substr(0, length)), "test.glb"), Error) << length;
    }
}

TEST_F(Glb, UnknownChunksAreSkippedAndASecondBinaryChunkIsAnError) {
    const std::string extra = std::string("\4\0\0\0", 4) + "XXXX" + "data";
    std::string longer = bytes + extra;
    bytes = longer;
    setWord(8, static_cast<std::uint32_t>(longer.size()));
    EXPECT_EQ(loadGltf(asBytes(bytes), "test.glb").meshes.size(), 1);
    bytes.replace(longer.size() - 8, 4, std::string("BIN\0", 4));
    expectGltfError(bytes, "", "chunk 2 is binary");
}

TEST_F(Glb, ABufferMayNotDeclareMoreThanTheChunkHas) {
    builder.document["bufferViews"][0]["byteLength"] = 36;
    std::string text = builder.glb();
    const auto place = text.find("\"byteLength\":36}]");
    ASSERT_NE(place, std::string::npos);
    text.replace(place, 17, "\"byteLength\":99}]");
    expectGltfError(text, "/buffers/0/byteLength", "declares 99 bytes, but only 36");
}

}  // namespace
}  // namespace umbrage
