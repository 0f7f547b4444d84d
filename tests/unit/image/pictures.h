// SPDX-License-Identifier: Apache-2.0
// Encoded pictures made by the tests: PNG by hand, so that no encoder of ours is believed; JPEG and WebP by
// OpenImageIO; and a reader of EXR.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace umbrage::test {

using Bytes = std::vector<std::uint8_t>;

inline std::span<const std::byte> asSpan(const Bytes& bytes) {
    return std::as_bytes(std::span(bytes));
}

/// A folder of the test's own that goes away with it.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "umbrage-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t entryCount() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

inline Bytes readBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void append32(Bytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

inline void appendChunk(Bytes& png, const std::string& type, const Bytes& data) {
    append32(png, static_cast<std::uint32_t>(data.size()));
    Bytes body(type.begin(), type.end());
    body.insert(body.end(), data.begin(), data.end());
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint8_t byte : body) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0u);
    }
    png.insert(png.end(), body.begin(), body.end());
    append32(png, ~crc);
}

/// zlib data of one uncompressed block.
inline Bytes storedZlib(const Bytes& raw) {
    const auto length = static_cast<std::uint16_t>(raw.size());
    const auto inverse = static_cast<std::uint16_t>(~length);
    Bytes out{0x78, 0x01, 0x01};
    for (const std::uint16_t value : {length, inverse}) {
        out.push_back(static_cast<std::uint8_t>(value & 0xFF));
        out.push_back(static_cast<std::uint8_t>(value >> 8));
    }
    out.insert(out.end(), raw.begin(), raw.end());
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
    append32(out, b << 16 | a);
    return out;
}

struct PngParts {
    std::uint32_t width = 1, height = 1;
    std::uint8_t bitDepth = 8, colorType = 2;           // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    Bytes rows = {};                                    // every row begins with a 0 (no filter)
    Bytes palette = {}, transparency = {}, gamma = {};  // PLTE, tRNS, gAMA where not empty
};

inline Bytes makePng(const PngParts& parts) {
    Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    Bytes header;
    append32(header, parts.width);
    append32(header, parts.height);
    header.insert(header.end(), {parts.bitDepth, parts.colorType, 0, 0, 0});
    appendChunk(png, "IHDR", header);
    if (!parts.gamma.empty()) appendChunk(png, "gAMA", parts.gamma);
    if (!parts.palette.empty()) appendChunk(png, "PLTE", parts.palette);
    if (!parts.transparency.empty()) appendChunk(png, "tRNS", parts.transparency);
    appendChunk(png, "IDAT", storedZlib(parts.rows));
    appendChunk(png, "IEND", {});
    return png;
}

/// @param format  jpeg or webp; `pixels` are interleaved, unassociated
inline Bytes encodeWithOiio(const std::string& format, int width, int height, int channelCount, const Bytes& pixels,
                            const std::string& compression = "", int orientation = 1) {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    OIIO::ImageSpec spec(width, height, channelCount, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("Orientation", orientation);
    if (!compression.empty()) spec.attribute("compression", compression);
    const auto output = OIIO::ImageOutput::create(format);
    if (!output || !output->set_ioproxy(&memory) || !output->open("test." + format, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) || !output->close()) {
        throw std::runtime_error(output ? output->geterror() : OIIO::geterror());
    }
    return bytes;
}

/// A lossless WebP, 2x1, of two colours that differ in green alone. OpenImageIO 2.4 divides colours by alpha when it
/// writes WebP, so one that is to be trusted is put together bit by bit: VP8L with prefix codes of one or two symbols.
/// @param extended  wraps it into a VP8X container
inline Bytes makeWebp(std::array<std::uint8_t, 4> rgba, std::uint8_t secondGreen, bool extended) {
    Bytes bits;
    int used = 0;
    const auto put = [&](std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i, ++used) {
            if (used % 8 == 0) bits.push_back(0);
            bits.back() = static_cast<std::uint8_t>(bits.back() | (value >> i & 1) << used % 8);
        }
    };
    const auto putOneSymbolCode = [&](std::uint8_t symbol) { put(0b101, 3), put(symbol, 8); };
    put(0x2F, 8), put(2 - 1, 14), put(1 - 1, 14), put(1, 1), put(0, 3);  // signature, width, height, alpha, version
    put(0, 3);                                                           // no transform, no cache, no meta codes
    put(0b111, 3), put(rgba[1], 8), put(secondGreen, 8);                 // green: two symbols of one bit
    for (const std::size_t channel : {0, 2, 3}) putOneSymbolCode(rgba[channel]);
    putOneSymbolCode(0);  // distances
    // The smaller symbol's code is 0.
    put(rgba[1] > secondGreen, 1), put(rgba[1] < secondGreen, 1);
    if (bits.size() % 2) bits.push_back(0);

    Bytes body{'W', 'E', 'B', 'P'};
    if (extended) body.insert(body.end(), {'V', 'P', '8', 'X', 10, 0, 0, 0, 0x10, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    body.insert(body.end(), {'V', 'P', '8', 'L', static_cast<std::uint8_t>(bits.size()), 0, 0, 0});
    body.insert(body.end(), bits.begin(), bits.end());
    Bytes webp{'R', 'I', 'F', 'F', static_cast<std::uint8_t>(body.size()), 0, 0, 0};
    webp.insert(webp.end(), body.begin(), body.end());
    return webp;
}

struct ExrFile {
    OIIO::ImageSpec spec;
    std::vector<std::byte> native;

    std::size_t channel(const std::string& name) const {
        const int index = spec.channelindex(name);
        if (index < 0) throw std::runtime_error("no channel " + name);
        return static_cast<std::size_t>(index);
    }

    /// The value a channel holds, read as the type it must be stored as.
    template <class T>
    T value(const std::string& name, OIIO::TypeDesc type, int x, int y) const {
        const std::size_t index = channel(name);
        if (spec.channelformat(static_cast<int>(index)) != type) throw std::runtime_error(name + " has another type");
        std::size_t at = (std::size_t(y) * spec.width + x) * spec.pixel_bytes(true);
        for (std::size_t c = 0; c < index; ++c) at += spec.channelformat(static_cast<int>(c)).size();
        T result;
        std::memcpy(&result, native.data() + at, sizeof result);
        return result;
    }
};

inline ExrFile readExr(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw std::runtime_error(OIIO::geterror());
    ExrFile result{input->spec(), {}};
    result.native.resize(result.spec.image_bytes(true));
    if (!input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeDesc::UNKNOWN, result.native.data())) {
        throw std::runtime_error(input->geterror());
    }
    return result;
}

}  // namespace umbrage::test
