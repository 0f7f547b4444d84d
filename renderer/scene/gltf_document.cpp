// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "error.h"

namespace umbrage {
namespace {

// Deep nesting overflows the stack of any recursive reader or writer of JSON. Real files stay below 20.
constexpr int kDeepestNesting = 512;
// tinygltf takes the length of the text as a 32-bit number.
constexpr std::size_t kLongestJson = 0x7fffffff;

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"

std::uint32_t littleEndian32(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        result |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return result;
}

// A scan instead of a parser's callback, because it must happen before anything recursive does.
void checkNesting(std::string_view text, const std::string& name) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                inString = false;
            }
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepestNesting) {
                failAt(name, "",
                       fmt::format("the JSON is nested more than {} levels deep at byte {}", kDeepestNesting, i));
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

// The parser's own words after "parse error at line 3, column 7: ". They may quote any byte of the file.
std::string parserWords(std::string_view what) {
    const auto column = what.find("column ");
    const auto begin = column == std::string_view::npos ? column : what.find(": ", column);
    std::string words(begin == std::string_view::npos ? what : what.substr(begin + 2, 160));
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return words;
}

nlohmann::json parseJson(std::string_view text, const std::string& name) {
    if (text.size() > kLongestJson) {
        failAt(name, "", fmt::format("the JSON is {} bytes long; at most {} can be read", text.size(), kLongestJson));
    }
    if (text.starts_with("\xEF\xBB\xBF")) {
        failAt(name, "", "begins with a byte order mark, which glTF forbids", "save it as UTF-8 without BOM");
    }
    // The parser takes a NUL for the end of the text and would not see what follows; as padding it is harmless.
    text = text.substr(0, text.find_last_not_of('\0') + 1);
    if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
        failAt(name, "", fmt::format("the JSON has a NUL byte at byte {}", nul));
    }
    checkNesting(text, name);
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::parse_error& e) {
        const std::size_t end = std::min(text.size(), e.byte > 0 ? e.byte - 1 : 0);
        const auto before = text.substr(0, end);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const auto lineBegin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
        throw Error(ErrorKind::Input, fmt::format("{}:{}:{}", name, line, end - lineBegin + 1),
                    "is not valid JSON: " + parserWords(e.what()));
    } catch (const nlohmann::json::exception& e) {
        failAt(name, "", "the JSON cannot be read: " + parserWords(e.what()));
    }
    if (!json.is_object()) {
        failAt(name, "", "a glTF document must be a JSON object");
    }
    return json;
}

struct GlbChunks {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary;
};

GlbChunks splitGlb(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() < 20) {
        failAt(name, "", fmt::format("{} bytes are too few for a .glb file", bytes.size()));
    }
    if (const auto version = littleEndian32(bytes, 4); version != 2) {
        failAt(name, "", fmt::format("version {} of the .glb container is not supported, only version 2 is", version));
    }
    if (const auto declared = littleEndian32(bytes, 8); declared != bytes.size()) {
        failAt(name, "", fmt::format("the header declares {} bytes, but the file has {}", declared, bytes.size()),
               declared > bytes.size() ? "the file is cut off" : "");
    }
    GlbChunks result;
    for (std::size_t offset = 12, number = 0; offset < bytes.size(); ++number) {
        if (bytes.size() - offset < 8) {
            failAt(name, "", fmt::format("chunk {} ends within its header", number));
        }
        const std::size_t length = littleEndian32(bytes, offset);
        const std::uint32_t type = littleEndian32(bytes, offset + 4);
        offset += 8;
        if (length > bytes.size() - offset) {
            failAt(
                name, "",
                fmt::format("chunk {} declares {} bytes, but only {} follow", number, length, bytes.size() - offset));
        }
        if (length % 4 != 0) {
            failAt(name, "", fmt::format("chunk {} has {} bytes, which is not a multiple of 4", number, length));
        }
        const auto data = bytes.subspan(offset, length);
        if ((number == 0) != (type == kJsonChunk)) {
            failAt(name, "",
                   fmt::format("chunk {} has the type {:#010x}; the first chunk, and no other, must be JSON", number,
                               type));
        }
        if (type == kJsonChunk) {
            result.json = {reinterpret_cast<const char*>(data.data()), data.size()};
        } else if (type == kBinChunk) {
            if (number != 1) {
                failAt(name, "", fmt::format("chunk {} is binary, but only the second chunk may be", number));
            }
            result.binary = data;
        }
        offset += length;
    }
    return result;
}

}  // namespace

std::vector<std::byte> readRegularFile(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        throw Error(ErrorKind::Input, file.string(), "there is no such file");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw Error(ErrorKind::Input, file.string(), "is not a regular file");
    }
    const auto size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) {
        throw Error(ErrorKind::Input, file.string(), "cannot be opened for reading");
    }
    std::vector<std::byte> bytes(size);
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
        throw Error(ErrorKind::Input, file.string(), "cannot be read to its end");
    }
    return bytes;
}

GltfDocument parseGltfDocument(std::vector<std::byte> bytes, std::string_view name) {
    GltfDocument document;
    document.name = name;
    document.sizeBytes = bytes.size();
    if (bytes.empty()) {
        failAt(document.name, "", "the file is empty");
    }
    if (bytes.size() >= 4 && littleEndian32(bytes, 0) == kGlbMagic) {
        document.bytes = std::move(bytes);
        const GlbChunks chunks = splitGlb(document.bytes, document.name);
        document.json = parseJson(chunks.json, document.name);
        document.binary = chunks.binary;
    } else {
        document.json = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, document.name);
    }
    return document;
}

}  // namespace umbrage
