// SPDX-License-Identifier: Apache-2.0
#include "workspace.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

namespace umbrage::cli {

void Workspace::SetUp() {
    std::string name = (std::filesystem::temp_directory_path() / "umbrage-cli-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
}

void Workspace::TearDown() {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
}

void Workspace::writeSequence(const std::string& more) const {
    writeFile("seq.yaml",
              "umbrage: 1\n"
              "scene: [{gltf: \"" +
                  sceneFile("lantern") +
                  "\"}]\n"
                  "time: {frames: 1-3}\n"
                  "image: {size: [64, 48]}\n" +
                  more);
}

void Workspace::writeFile(const std::filesystem::path& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

Result Workspace::umbrage(const std::vector<std::string>& arguments) const {
    return umbrage(Launch{}, arguments);
}

Result Workspace::umbrage(Launch launch, const std::vector<std::string>& arguments) const {
    launch.folder = folder_;
    const Result result = run(launch, arguments);
    EXPECT_FALSE(result.killed) << "it did not end within " << launch.limitSeconds << " s";
    return result;
}

std::vector<std::string> Workspace::filesIn(const std::filesystem::path& name) const {
    std::vector<std::string> files;
    if (!std::filesystem::exists(folder_ / name)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / name)) {
        const bool isManifest = entry.path().filename() == "manifest.json";
        if (!entry.is_directory() && !isManifest)
            files.push_back(entry.path().lexically_relative(folder_ / name).string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string contentsOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file << " cannot be read";
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string sceneFile(const std::string& name) {
    return std::string(UMBRAGE_SOURCE_DIR) + "/scenes/" + name + ".glb";
}

std::vector<std::string> channelsOf(const std::filesystem::path& image) {
    const auto input = OIIO::ImageInput::open(image.string());
    EXPECT_TRUE(input) << OIIO::geterror();
    return input ? input->spec().channelnames : std::vector<std::string>{};
}

std::vector<double> valuesOf(const std::filesystem::path& image) {
    const auto input = OIIO::ImageInput::open(image.string());
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input) return {};
    const OIIO::ImageSpec& spec = input->spec();
    const std::size_t count = std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels);
    const auto read = [&](auto type, const OIIO::TypeDesc& description) {
        std::vector<decltype(type)> values(count);
        EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, description, values.data())) << input->geterror();
        return std::vector<double>(values.begin(), values.end());
    };
    return spec.format == OIIO::TypeDesc::UINT ? read(std::uint32_t{}, OIIO::TypeDesc::UINT)
                                               : read(float{}, OIIO::TypeDesc::FLOAT);
}

}  // namespace umbrage::cli
