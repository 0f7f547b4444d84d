// SPDX-License-Identifier: Apache-2.0
// Where a document's bytes may come from: nothing outside the scene's folder, whatever the document says.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "gltf_builder.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

class GltfFolder : public testing::Test {
protected:
    GltfFolder()
        : base(fs::temp_directory_path() / ("umbrage_files_" + std::to_string(getpid()))), folder(base / "scene") {
        fs::remove_all(base);
        fs::create_directories(folder / "sub");
        builder.triangle();
        data.assign(builder.bytes.begin(), builder.bytes.end());
        write(base / "outside.bin", data);
        write(folder / "inside.bin", data);
        write(folder / "sub/with space%.bin", data);
    }
    ~GltfFolder() override { fs::remove_all(base); }

    static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

    Scene load(const std::string& uri, const GltfOptions& options = {}, std::size_t byteLength = 36) {
        json document = builder.document;
        document["buffers"] = {{{"byteLength", byteLength}, {"uri", uri}}};
        write(folder / "test.gltf", document.dump());
        return loadGltf(folder / "test.gltf", options);
    }

    void expectRefused(const std::string& uri, const std::string& words, const GltfOptions& options = {}) {
        try {
            load(uri, options);
            ADD_FAILURE() << uri << " was read";
        } catch (const Error& e) {
            EXPECT_EQ(e.where(), (folder / "test.gltf").string() + ": /buffers/0/uri");
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
        }
    }

    fs::path base, folder;
    GltfBuilder builder;
    std::string data;
};

TEST_F(GltfFolder, FilesBesideTheSceneAndBelowItAreRead) {
    EXPECT_EQ(load("inside.bin").meshes[0].positions.size(), 3);
    EXPECT_EQ(load("./inside%2Ebin").meshes[0].positions.size(), 3);
    EXPECT_EQ(load("sub/with%20space%.bin").meshes[0].positions.size(), 3);
    EXPECT_EQ(load("sub/../inside.bin").meshes[0].positions.size(), 3);
}

TEST_F(GltfFolder, EveryWayOutOfTheFolderIsRefused) {
    expectRefused("../outside.bin", "outside the scene's folder");
    expectRefused("%2e%2e%2foutside.bin", "outside the scene's folder");
    expectRefused("sub/../../outside.bin", "outside the scene's folder");
    expectRefused((base / "outside.bin").string(), "outside the scene's folder");
    expectRefused("/dev/zero", "outside the scene's folder");
    fs::create_symlink(base / "outside.bin", folder / "link.bin");
    fs::create_directory_symlink(base, folder / "linked");
    expectRefused("link.bin", "outside the scene's folder");
    expectRefused("linked/outside.bin", "outside the scene's folder");
    expectRefused("../scene2/x.bin", "outside the scene's folder");
}

TEST_F(GltfFolder, AFolderWhoseNameBeginsLikeTheScenesIsOutside) {
    fs::create_directories(base / "scene-other");
    write(base / "scene-other/a.bin", data);
    expectRefused("../scene-other/a.bin", "outside the scene's folder");
}

TEST_F(GltfFolder, ALinkThatStaysInsideIsRead) {
    fs::create_symlink("inside.bin", folder / "link.bin");
    EXPECT_EQ(load("link.bin").meshes[0].positions.size(), 3);
}

TEST_F(GltfFolder, ExternalFilesAreReadWhenAllowed) {
    EXPECT_EQ(load("../outside.bin", {.scene = "", .allowExternalFiles = true}).meshes[0].positions.size(), 3);
}

TEST_F(GltfFolder, SchemesDevicesFoldersAndMissingFilesAreRefused) {
    const GltfOptions external{.scene = "", .allowExternalFiles = true};
    expectRefused("file:" + (folder / "inside.bin").string(), "\"file:\"", external);
    expectRefused("http://localhost/a.bin", "\"http:\"", external);
    expectRefused("/dev/zero", "not a regular file", external);
    expectRefused("sub", "not a regular file");
    expectRefused("missing.bin", "does not exist");
    expectRefused("inside.bin%00.txt", "names no file");
    expectRefused("", "names no file");
}

TEST_F(GltfFolder, TheCurrentFolderIsNoFallBack) {
    const fs::path before = fs::current_path();
    fs::current_path(base);
    expectRefused("outside.bin", "does not exist");
    fs::current_path(before);
}

TEST_F(GltfFolder, AFileShorterThanItsBufferIsAnErrorBeforeAnythingIsAllocated) {
    try {
        load("inside.bin", {}, 1000000000000);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.where(), (folder / "test.gltf").string() + ": /buffers/0/byteLength");
        EXPECT_EQ(e.message(), "declares 1000000000000 bytes, but only 36 are there");
    }
}

TEST_F(GltfFolder, AMissingImageIsAnErrorAndAPresentOneKeepsItsBytes) {
    write(folder / "picture.png", "\x89PNG and so on");
    builder.document["images"] = {{{"uri", "picture.png"}}};
    const Scene scene = load("inside.bin");
    ASSERT_EQ(scene.images.size(), 1);
    EXPECT_EQ(scene.images[0].encoded.size(), 14);
    EXPECT_EQ(scene.images[0].mimeType, "image/png");
    builder.document["images"] = {{{"uri", "absent.png"}}};
    EXPECT_THROW(
        {
            try {
                load("inside.bin");
            } catch (const Error& e) {
                EXPECT_NE(e.where().find("/images/0/uri"), std::string::npos);
                throw;
            }
        },
        Error);
}

TEST_F(GltfFolder, ASceneFileThatIsMissingOrADeviceIsAnError) {
    EXPECT_THROW(loadGltf(folder / "absent.gltf"), Error);
    EXPECT_THROW(loadGltf("/dev/zero"), Error);
    EXPECT_THROW(loadGltf(folder), Error);
}

TEST(GltfDataUri, AnyMediaTypeIsReadAndBadBase64IsNot) {
    GltfBuilder builder;
    builder.triangle();
    const auto withUri = [&](const std::string& uri) {
        json document = builder.document;
        document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        return document.dump();
    };
    const std::string digits = base64(builder.bytes);
    for (const std::string type : {"", "application/gltf-buffer", "image/ktx2;foo=bar", "nonsense"}) {
        EXPECT_EQ(
            loadGltf(asBytes(withUri("data:" + type + ";base64," + digits)), "test.gltf").meshes[0].positions.size(), 3)
            << type;
    }
    expectGltfError(withUri("data:text/plain,abc"), "/buffers/0/uri", "not base64");
    expectGltfError(withUri("data:;base64,AB*D"), "/buffers/0/uri", "character 2");
    expectGltfError(withUri("data:;base64,AAAAA"), "/buffers/0/uri", "whole bytes");
    expectGltfError(withUri("data:;base64,AA==="), "/buffers/0/uri", "whole bytes");
    expectGltfError(withUri("data:;base64,AAAA"), "/buffers/0/byteLength", "only 3");
    expectGltfError(withUri("data:;base64,"), "/buffers/0/byteLength", "only 0");
}

TEST(GltfDataUri, ImagesOfEveryKindKeepTheirBytes) {
    GltfBuilder builder;
    const auto image = [](std::string_view bytes) {
        return json{{"uri", "data:application/x;base64," + base64({bytes.begin(), bytes.end()})}};
    };
    builder.document["images"] = {image("RIFF1234WEBPxx"), image("\xFF\xD8\xFFjpeg"), image("???")};
    const Scene scene = builder.load();
    EXPECT_EQ(scene.images[0].mimeType, "image/webp");
    EXPECT_EQ(scene.images[0].encoded.size(), 14);
    EXPECT_EQ(scene.images[1].mimeType, "image/jpeg");
    EXPECT_EQ(scene.images[2].encoded.size(), 3);
    EXPECT_EQ(scene.images[2].name, "image 2 of test.gltf");
}

TEST(GltfFromMemory, NoFileCanBeRead) {
    GltfBuilder builder;
    builder.document["buffers"] = {{{"byteLength", 1}, {"uri", "a.bin"}}};
    expectGltfError(builder.document.dump(), "/buffers/0/uri", "has no folder");
}

}  // namespace
}  // namespace umbrage
