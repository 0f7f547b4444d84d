// SPDX-License-Identifier: Apache-2.0
#include "image/codec/read.h"

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "error.h"
#include "image/codec/decode.h"
#include "image/codec/exr_header.h"

namespace umbrage {
namespace {

std::vector<std::byte> bytesOf(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw Error(ErrorKind::Input, file.string(), "there is no such file");
    if (!std::filesystem::is_regular_file(status)) throw Error(ErrorKind::Input, file.string(), "is not a file");
    const auto size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::byte> bytes(error ? 0 : size);
    if (!stream || !stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) {
        throw Error(ErrorKind::Input, file.string(), "cannot be read");
    }
    return bytes;
}

bool startsWith(std::span<const std::byte> bytes, std::string_view text) {
    return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

Metadata metadataOf(const OIIO::ParamValueList& attributes) {
    Metadata metadata;
    for (const auto& attribute : attributes) {
        const std::string name = attribute.name().string();
        const OIIO::TypeDesc type = attribute.type();
        if (type == OIIO::TypeDesc::STRING) metadata.emplace_back(name, attribute.get_string());
        if (type == OIIO::TypeDesc::INT) metadata.emplace_back(name, attribute.get_int());
        if (type == OIIO::TypeDesc::FLOAT) metadata.emplace_back(name, double(attribute.get_float()));
        if (type == OIIO::TypeDesc::DOUBLE) metadata.emplace_back(name, *static_cast<const double*>(attribute.data()));
    }
    std::sort(metadata.begin(), metadata.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return metadata;
}

/// Every `stride`-th byte group of Stored from `first` on, as Value.
template <class Value, class Stored>
std::vector<Value> separated(const std::byte* first, std::size_t stride, std::size_t count, Value scale = 1) {
    std::vector<Value> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        Stored stored;
        std::memcpy(&stored, first + i * stride, sizeof stored);
        values[i] = static_cast<Value>(stored) / scale;
    }
    return values;
}

StoredImage readPng(std::span<const std::byte> encoded, const std::string& name) {
    OIIO::ParamValueList attributes;
    const DecodedImage decoded = decodeImage(encoded, name, &attributes);
    const char* const names[] = {"Y", "YA", "RGB", "RGBA"};
    const bool wide = decoded.type == PixelType::UInt16;
    const std::size_t bytes = wide ? 2 : 1, stride = bytes * decoded.channelCount;

    StoredImage image;
    image.data = image.display = {0, 0, decoded.width, decoded.height};
    image.displayEncoded = true;
    image.metadata = metadataOf(attributes);
    for (int c = 0; c < decoded.channelCount; ++c) {
        const std::byte* first = decoded.pixels.data() + c * bytes;
        StoredChannel& channel = image.channels.emplace_back();
        channel.name = names[decoded.channelCount - 1][c];
        channel.type = decoded.type;
        channel.values = wide ? separated<float, std::uint16_t>(first, stride, image.pixelCount(), 65535.0f)
                              : separated<float, std::uint8_t>(first, stride, image.pixelCount(), 255.0f);
    }
    return image;
}

StoredChannel channelOf(const OIIO::ImageSpec& spec, int index, const std::vector<std::byte>& pixels,
                        const std::string& name) {
    const std::size_t count = std::size_t(spec.width) * spec.height, stride = spec.pixel_bytes(true);
    const std::byte* first = pixels.data() + spec.pixel_bytes(0, index, true);
    const std::string& channel = spec.channelnames[index];
    switch (spec.channelformat(index).basetype) {
        case OIIO::TypeDesc::HALF:
            return {channel, PixelType::Half, separated<float, half>(first, stride, count)};
        case OIIO::TypeDesc::FLOAT:
            return {channel, PixelType::Float, separated<float, float>(first, stride, count)};
        case OIIO::TypeDesc::UINT32:
            return {channel, PixelType::UInt32, separated<std::uint32_t, std::uint32_t>(first, stride, count)};
        default:
            throw Error(ErrorKind::Input, name, fmt::format("EXR channel {} has an unknown type", channel));
    }
}

StoredImage readExr(std::span<const std::byte> encoded, const std::string& name) {
    const ExrHeader header = readExrHeader(encoded, name);
    OIIO::Filesystem::IOMemReader memory(encoded.data(), encoded.size());
    const auto input = OIIO::ImageInput::create("openexr");
    const auto damaged = [&](std::string reason) {
        while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
        return Error(ErrorKind::Input, name, "the EXR is damaged: " + reason, "render or export the picture again");
    };
    OIIO::ImageSpec spec;
    if (!input || !input->set_ioproxy(&memory) || !input->open("memory.exr", spec)) {
        throw damaged(input ? input->geterror() : OIIO::geterror());
    }
    if (spec.width != header.data.width || spec.height != header.data.height || spec.depth != 1 || spec.deep ||
        spec.nchannels != int(header.channelCount) || spec.pixel_bytes(true) != header.pixelBytes) {
        throw damaged("its pixels are not those that its header declares");
    }
    std::vector<std::byte> pixels(spec.image_bytes(true));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN, pixels.data())) {
        throw damaged(input->geterror());
    }

    StoredImage image;
    image.data = header.data;
    image.display = header.display;
    image.metadata = metadataOf(spec.extra_attribs);
    for (int c = 0; c < spec.nchannels; ++c) image.channels.push_back(channelOf(spec, c, pixels, name));
    return image;
}

}  // namespace

StoredImage readStored(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::vector<std::byte> encoded = bytesOf(file);
    const bool png = startsWith(encoded, "\x89PNG\r\n\x1a\n");
    if (!png && !startsWith(encoded, kExrMagic)) {
        throw Error(ErrorKind::Input, name, "the picture is neither PNG nor EXR", "convert it to one of these");
    }
    StoredImage image = png ? readPng(encoded, name) : readExr(encoded, name);
    const auto byName = [](const StoredChannel& a, const StoredChannel& b) { return a.name < b.name; };
    std::sort(image.channels.begin(), image.channels.end(), byName);
    return image;
}

}  // namespace umbrage
