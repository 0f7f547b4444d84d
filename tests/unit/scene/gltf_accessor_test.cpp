// SPDX-License-Identifier: Apache-2.0
// Every form of accessor, seen through the mesh that uses it, and every way to point beyond the data.
#include <limits>

#include "gltf_builder.h"

namespace umbrage {
namespace {

class GltfAccessor : public testing::Test {
protected:
    GltfAccessor() { builder.triangle(); }

    json& attributes() { return builder.primitive()["attributes"]; }
    json& firstAccessor() { return builder.document["accessors"][0]; }
    Mesh mesh() const { return builder.load().meshes.at(0); }

    GltfBuilder builder;
};

TEST_F(GltfAccessor, NormalisedIntegersBecomeFloatsAsTheSpecificationSays) {
    attributes()["TEXCOORD_0"] = builder.accessor<std::uint8_t>("VEC2", {0, 255, 51, 128, 1, 254}, 3, true);
    attributes()["TEXCOORD_1"] = builder.accessor<std::uint16_t>("VEC2", {0, 65535, 1, 2, 32768, 65534}, 3, true);
    // Elements of one or two bytes: the views are packed, so offsets stay multiples of the component.
    const Mesh mesh = this->mesh();
    EXPECT_EQ(mesh.texCoords[0][0], glm::vec2(0.0f, 1.0f));
    EXPECT_EQ(mesh.texCoords[0][1], glm::vec2(0.2f, 128.0f / 255.0f));
    EXPECT_EQ(mesh.texCoords[1][0], glm::vec2(0.0f, 1.0f));
    EXPECT_EQ(mesh.texCoords[1][2], glm::vec2(32768.0f / 65535.0f, 65534.0f / 65535.0f));
}

TEST_F(GltfAccessor, SignedNormalisedIntegersReachMinusOneTwice) {
    builder.document["extensionsUsed"] = {"KHR_mesh_quantization"};
    attributes()["NORMAL"] =
        builder.accessor({{"bufferView", builder.view<std::int8_t>({-128, -127, 127, 0, 0, 64, 0, 0, 0, 0, 0, 0}, 4)},
                          {"componentType", kByte},
                          {"count", 3},
                          {"type", "VEC3"},
                          {"normalized", true}});
    const Mesh mesh = this->mesh();
    EXPECT_EQ(mesh.normals[0], glm::vec3(-1.0f, -1.0f, 1.0f));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0.0f, 64.0f / 127.0f, 0.0f));
}

TEST_F(GltfAccessor, QuantisedPositionsNeedTheirExtension) {
    attributes()["POSITION"] =
        builder.accessor({{"bufferView", builder.view<std::int16_t>({-3, 2, 1, 0, 300, 0, 0, 0, -32768, 0, 0, 0}, 8)},
                          {"componentType", kShort},
                          {"count", 3},
                          {"type", "VEC3"}});
    expectGltfError(builder, "/meshes/0/primitives/0/attributes/POSITION", "VEC3 of SHORT");
    builder.document["extensionsUsed"] = {"KHR_mesh_quantization"};
    EXPECT_EQ(mesh().positions, (std::vector<glm::vec3>{{-3, 2, 1}, {300, 0, 0}, {-32768, 0, 0}}));
}

TEST_F(GltfAccessor, InterleavedAttributesAreTakenApart) {
    const int view = builder.view<float>({0, 0, 0, 7, 8, 9, 1, 0, 0, 17, 18, 19, 0, 1, 0, 27, 28, 29}, 24);
    attributes()["POSITION"] =
        builder.accessor({{"bufferView", view}, {"componentType", kFloatComponent}, {"count", 3}, {"type", "VEC3"}});
    attributes()["NORMAL"] = builder.accessor(
        {{"bufferView", view}, {"byteOffset", 12}, {"componentType", kFloatComponent}, {"count", 3}, {"type", "VEC3"}});
    const Mesh mesh = this->mesh();
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[2], glm::vec3(27, 28, 29));
}

TEST_F(GltfAccessor, SparseValuesReplaceThoseOfTheView) {
    for (const int indexType : {kUnsignedByte, kUnsignedShort, kUnsignedInt}) {
        const int indices = indexType == kUnsignedByte    ? builder.view<std::uint8_t>({0, 2})
                            : indexType == kUnsignedShort ? builder.view<std::uint16_t>({0, 2})
                                                          : builder.view<std::uint32_t>({0, 2});
        firstAccessor()["sparse"] = {{"count", 2},
                                     {"indices", {{"bufferView", indices}, {"componentType", indexType}}},
                                     {"values", {{"bufferView", builder.view<float>({9, 9, 9, 5, 6, 7})}}}};
        EXPECT_EQ(mesh().positions, (std::vector<glm::vec3>{{9, 9, 9}, {1, 0, 0}, {5, 6, 7}}));
    }
}

TEST_F(GltfAccessor, WithoutAViewAllElementsAreZeroExceptSparseOnes) {
    firstAccessor().erase("bufferView");
    EXPECT_EQ(mesh().positions, std::vector<glm::vec3>(3, glm::vec3(0.0f)));
    firstAccessor()["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", builder.view<std::uint8_t>({1})}, {"componentType", kUnsignedByte}}},
        {"values", {{"bufferView", builder.view<float>({1, 2, 3})}}}};
    EXPECT_EQ(mesh().positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}}));
}

TEST_F(GltfAccessor, IndicesMayBeSparseOrZeroToo) {
    builder.primitive()["indices"] =
        builder.accessor({{"componentType", kUnsignedShort}, {"count", 3}, {"type", "SCALAR"}});
    EXPECT_EQ(mesh().indices, (std::vector<std::uint32_t>{0, 0, 0}));
    builder.document["accessors"].back()["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", builder.view<std::uint8_t>({1, 2})}, {"componentType", kUnsignedByte}}},
        {"values", {{"bufferView", builder.view<std::uint16_t>({1, 2})}}}};
    EXPECT_EQ(mesh().indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST_F(GltfAccessor, SparseIndicesMustIncreaseAndStayInRange) {
    for (const std::vector<std::uint8_t>& indices : {std::vector<std::uint8_t>{2, 1}, {1, 1}, {1, 3}}) {
        firstAccessor()["sparse"] = {
            {"count", 2},
            {"indices", {{"bufferView", builder.view(indices)}, {"componentType", kUnsignedByte}}},
            {"values", {{"bufferView", builder.view<float>({9, 9, 9, 5, 6, 7})}}}};
        expectGltfError(builder, "/accessors/0/sparse/indices", "must increase");
    }
    firstAccessor()["sparse"]["count"] = 4;
    expectGltfError(builder, "/accessors/0/sparse/count", "from 1 to 3");
    firstAccessor()["sparse"]["count"] = 3;
    expectGltfError(builder, "/accessors/0/sparse/indices", "do not fit");
    firstAccessor()["sparse"]["indices"]["componentType"] = kFloatComponent;
    expectGltfError(builder, "/accessors/0/sparse/indices/componentType", "unsigned");
}

TEST_F(GltfAccessor, RangesBeyondTheViewAreErrorsEvenWhenTheArithmeticWouldWrap) {
    const json accessor = firstAccessor();
    for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{4294967295}}) {
        firstAccessor()["count"] = count;
        expectGltfError(builder, "/accessors/0", "do not fit");
    }
    firstAccessor()["count"] = 0;
    expectGltfError(builder, "/accessors/0/count", "from 1");
    firstAccessor()["count"] = -1;
    expectGltfError(builder, "/accessors/0/count", "is -1");
    firstAccessor() = accessor;
    firstAccessor()["byteOffset"] = 4;
    expectGltfError(builder, "/accessors/0", "do not fit");
    firstAccessor()["byteOffset"] = 9007199254740988;
    expectGltfError(builder, "/accessors/0", "do not fit");
    firstAccessor()["byteOffset"] = 18446744073709551612u;
    expectGltfError(builder, "/accessors/0/byteOffset", "must be an integer");
}

TEST_F(GltfAccessor, ViewsBeyondTheBufferAreErrors) {
    json& view = builder.document["bufferViews"][0];
    view["byteOffset"] = 4;
    expectGltfError(builder, "/bufferViews/0", "do not fit into the 36 bytes of buffer 0");
    view["byteOffset"] = 4294967280u;
    expectGltfError(builder, "/bufferViews/0", "do not fit");
    view["buffer"] = 1;
    expectGltfError(builder, "/bufferViews/0/buffer", "names buffer 1");
}

TEST_F(GltfAccessor, StridesAndOffsetsMustSuitTheComponents) {
    json& view = builder.document["bufferViews"][0];
    view["byteStride"] = 8;
    expectGltfError(builder, "/accessors/0", "byteStride of 8");
    view["byteStride"] = 14;
    expectGltfError(builder, "/bufferViews/0/byteStride", "multiple of 4");
    view["byteStride"] = 256;
    expectGltfError(builder, "/bufferViews/0/byteStride", "from 4 to 252");
    view.erase("byteStride");
    firstAccessor()["byteOffset"] = 2;
    expectGltfError(builder, "/accessors/0", "not a multiple of 4");
}

TEST_F(GltfAccessor, UnknownTypesAreErrors) {
    const json accessor = firstAccessor();
    firstAccessor()["type"] = "VEC9";
    expectGltfError(builder, "/accessors/0/type", "VEC9");
    firstAccessor() = accessor;
    firstAccessor()["componentType"] = 5124;
    expectGltfError(builder, "/accessors/0/componentType", "5124");
    firstAccessor() = accessor;
    firstAccessor()["normalized"] = true;
    expectGltfError(builder, "/accessors/0/normalized", "only 8-bit");
    firstAccessor() = accessor;
    firstAccessor()["bufferView"] = 7;
    expectGltfError(builder, "/accessors/0/bufferView", "names buffer view 7");
}

TEST_F(GltfAccessor, NumbersThatAreNotFiniteAreErrorsNamingAccessorAndElement) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
        attributes()["POSITION"] = builder.vec3s({0, 0, 0, 1, 0, 0, 0, bad, 0});
        expectGltfError(builder, "/meshes/0/primitives/0/attributes/POSITION",
                        "element 2 of accessor " + attributes()["POSITION"].dump());
    }
}

TEST_F(GltfAccessor, AMorphTargetThatIsNotFiniteIsAnErrorToo) {
    builder.primitive()["targets"] = {
        {{"POSITION", builder.vec3s({0, 0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0})}}};
    expectGltfError(builder, "/meshes/0/primitives/0/targets/0/POSITION", "element 2 of accessor");
}

TEST_F(GltfAccessor, HugeAccessorsWithoutDataAreErrorsBeforeTheyAreAllocated) {
    firstAccessor() = {{"componentType", kFloatComponent}, {"count", 2000000000}, {"type", "VEC3"}};
    expectGltfError(builder, "/meshes/0/primitives/0/attributes/POSITION", "24000000000 more bytes");
    firstAccessor()["count"] = 4000000000u;
    expectGltfError(builder, "/meshes/0/primitives/0", "more than 2147483647 vertices");
}

TEST_F(GltfAccessor, ManySmallZeroFilledAccessorsAreBoundedTogether) {
    json& primitives = builder.document["meshes"][0]["primitives"];
    const json primitive = primitives[0];
    for (int i = 0; i < 100; ++i) {
        json another = primitive;
        another["attributes"]["POSITION"] =
            builder.accessor({{"componentType", kFloatComponent}, {"count", 100000}, {"type", "VEC3"}});
        primitives.push_back(another);
    }
    try {
        builder.load();
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(e.message().find("more bytes of memory"), std::string::npos);
    }
}

TEST_F(GltfAccessor, ABufferWithoutDataMayExistButNotBeRead) {
    const std::string text = builder.text();
    json document = json::parse(text);
    document["buffers"].push_back(
        {{"byteLength", 100}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    document["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 100}});
    EXPECT_EQ(loadGltf(asBytes(document.dump()), "test.gltf").meshes[0].positions[1], glm::vec3(1, 0, 0));
    document["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", kFloatComponent}, {"count", 1}, {"type", "SCALAR"}});
    expectGltfError(document.dump(), "/accessors/1", "has no data");
}

}  // namespace
}  // namespace umbrage
