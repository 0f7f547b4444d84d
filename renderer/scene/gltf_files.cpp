// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "error.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

int hexDigit(char c) {
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// A '%' that starts no escape stays as it is: exporters that forget to escape write file names with it.
std::string percentDecoded(std::string_view uri) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 && hexDigit(uri[i + 2]) >= 0) {
            result += static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
            i += 2;
        } else {
            result += uri[i];
        }
    }
    return result;
}

// The scheme with its colon, or nothing (RFC 3986 3.1).
std::string_view schemeOf(std::string_view uri) {
    const auto isAlpha = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
    if (uri.empty() || !isAlpha(uri[0])) {
        return {};
    }
    for (std::size_t i = 1; i < uri.size(); ++i) {
        const char c = uri[i];
        if (c == ':') {
            return uri.substr(0, i + 1);
        }
        if (!isAlpha(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') {
            return {};
        }
    }
    return {};
}

constexpr int kNotBase64 = 64;

constexpr std::array<std::uint8_t, 256> base64Values() {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(kNotBase64);
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}
constexpr auto kBase64Values = base64Values();

GltfSource resolveDataUri(const JsonView& uri) {
    const std::string_view text = uri.text();
    constexpr std::string_view kMarker = ";base64";
    const auto comma = text.find(',');
    if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(kMarker)) {
        uri.fail(fmt::format("the data URI {} is not base64", inQuotes(text.substr(0, 60))),
                 "only base64 data URIs are read");
    }
    const auto header = text.substr(5, comma - kMarker.size() - 5);
    auto digits = text.substr(comma + 1);
    // Padding is checked by counting: decoders differ in what they accept, and a size must be certain.
    const auto end = digits.find_last_not_of('=');
    const std::size_t digitCount = end == std::string_view::npos ? 0 : end + 1;
    const std::size_t paddingCount = digits.size() - digitCount;
    digits = digits.substr(0, digitCount);
    const auto bad = std::find_if(digits.begin(), digits.end(),
                                  [](char c) { return kBase64Values[static_cast<unsigned char>(c)] == kNotBase64; });
    if (bad != digits.end()) {
        uri.fail(fmt::format("character {} of the base64 data is invalid", bad - digits.begin()));
    }
    if (digitCount % 4 == 1 || (paddingCount > 0 && (digitCount + paddingCount) % 4 != 0) || paddingCount > 2) {
        uri.fail(fmt::format("{} base64 digits with {} '=' are not whole bytes", digitCount, paddingCount));
    }
    GltfSource source;
    source.origin = GltfSource::DataUri{digits};
    source.sizeBytes = digitCount / 4 * 3 + (digitCount % 4 == 0 ? 0 : digitCount % 4 - 1);
    source.mimeType = header.substr(0, header.find(';'));
    return source;
}

std::vector<unsigned char> decodeBase64(std::string_view digits, std::uint64_t sizeBytes) {
    std::vector<unsigned char> bytes;
    bytes.reserve(sizeBytes);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (const char digit : digits) {
        if (bytes.size() == sizeBytes) {
            break;
        }
        bits = bits << 6 | kBase64Values[static_cast<unsigned char>(digit)];
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<unsigned char>(bits >> bitCount));
        }
    }
    return bytes;
}

std::vector<unsigned char> readFile(const fs::path& file, std::uint64_t sizeBytes) {
    std::ifstream stream(file, std::ios::binary);
    std::vector<unsigned char> bytes(sizeBytes);
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(sizeBytes))) {
        throw Error(ErrorKind::Input, file.string(), fmt::format("{} bytes of it cannot be read", sizeBytes));
    }
    return bytes;
}

bool isInside(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

}  // namespace

GltfFiles::GltfFiles(const fs::path& folder, bool allowExternalFiles) : allowExternalFiles_(allowExternalFiles) {
    if (!folder.empty()) {
        std::error_code error;
        folder_ = fs::canonical(folder, error);
    }
}

GltfSource GltfFiles::resolve(const JsonView& uri) {
    const std::string_view scheme = schemeOf(uri.text());
    if (scheme == "data:") {
        return resolveDataUri(uri);
    }
    if (!scheme.empty()) {
        uri.fail(fmt::format("URIs with the scheme {} are not read", inQuotes(scheme)),
                 "only data: URIs and paths relative to the scene's folder are; write a name with a colon as ./name");
    }
    return resolveFile(uri);
}

GltfSource GltfFiles::resolveFile(const JsonView& uri) {
    const std::string relative = percentDecoded(uri.text());
    if (relative.empty() || relative.find('\0') != std::string::npos) {
        uri.fail(fmt::format("{} names no file", inQuotes(relative)));
    }
    if (folder_.empty()) {
        uri.fail(fmt::format("the file {} cannot be read: this scene has no folder", inQuotes(relative)));
    }
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder_ / relative, error);
    if (error) {
        uri.fail(fmt::format("the file {} cannot be found: {}", inQuotes(relative), error.message()));
    }
    if (!allowExternalFiles_ && !isInside(file, folder_)) {
        uri.fail(fmt::format("{} lies outside the scene's folder", inQuotes(relative)),
                 "move the file beside the scene, or allow external files");
    }
    const auto status = fs::status(file, error);
    if (!fs::exists(status)) {
        uri.fail(fmt::format("the file {} does not exist", inQuotes(relative)));
    }
    if (!fs::is_regular_file(status)) {
        uri.fail(fmt::format("{} is not a regular file", inQuotes(relative)));
    }
    GltfSource source;
    source.sizeBytes = fs::file_size(file, error);
    if (error) {
        uri.fail(fmt::format("the size of the file {} cannot be found: {}", inQuotes(relative), error.message()));
    }
    source.fileName = relative;
    if (files_.insert(file).second) {
        fileBytes_ += source.sizeBytes;
    }
    source.origin = file;
    return source;
}

std::vector<unsigned char> readSource(const GltfSource& source, std::uint64_t sizeBytes) {
    struct Reader {
        std::uint64_t sizeBytes;
        std::vector<unsigned char> operator()(std::span<const std::byte> bytes) const {
            const auto* begin = reinterpret_cast<const unsigned char*>(bytes.data());
            return {begin, begin + sizeBytes};
        }
        std::vector<unsigned char> operator()(const GltfSource::DataUri& uri) const {
            return decodeBase64(uri.base64, sizeBytes);
        }
        std::vector<unsigned char> operator()(const fs::path& file) const { return readFile(file, sizeBytes); }
    };
    return std::visit(Reader{std::min(sizeBytes, source.sizeBytes)}, source.origin);
}

}  // namespace umbrage
