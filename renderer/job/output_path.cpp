// SPDX-License-Identifier: Apache-2.0
#include "job/output_path.h"

#include <fmt/core.h>

#include <algorithm>

#include "error.h"
#include "job/nearest.h"

namespace umbrage {
namespace {

/// A literal, or a field with its number of digits.
struct Piece {
    std::string text;
    bool isField = false;
    int digits = 0;
    std::size_t begin = 0;  // of a field in the template
};

const std::vector<std::string> kFields = {"aov", "frame", "ext", "scene"};

Piece fieldPiece(const std::string& inside, const std::string& where) {
    const auto fail = [&](const std::string& message, const std::string& hint) {
        throw Error(ErrorKind::Input, where, message, hint);
    };
    const auto colon = inside.find(':');
    Piece piece{.text = inside.substr(0, colon), .isField = true};
    if (std::find(kFields.begin(), kFields.end(), piece.text) == kFields.end())
        fail(fmt::format("unknown field {{{}}} in the output path", inside), hintForName(piece.text, kFields));
    if (colon == std::string::npos) return piece;
    const std::string format = inside.substr(colon + 1);
    const bool isWidth = format.size() == 2 && format[0] == '0' && format[1] >= '1' && format[1] <= '9';
    if (piece.text != "frame" || !isWidth)
        fail(fmt::format("\"{}\" is not a format of {{{}}}", format, piece.text),
             "only {frame} has one: 0 and a number of digits, such as {frame:04}");
    piece.digits = format[1] - '0';
    return piece;
}

std::vector<Piece> piecesOf(const std::string& path, const std::string& where) {
    std::vector<Piece> pieces;
    std::string literal;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const char c = path[i];
        const bool doubled = i + 1 < path.size() && path[i + 1] == c;
        if (c != '{' && c != '}') {
            literal += c;
        } else if (doubled) {
            literal += c;
            ++i;
        } else {
            const auto end = path.find('}', i);
            if (c == '}' || end == std::string::npos)
                throw Error(ErrorKind::Input, where, fmt::format("a '{}' without its partner in the output path", c),
                            "fields are {aov}, {frame:04}, {ext}, {scene}; {{ and }} are braces");
            pieces.push_back({.text = std::exchange(literal, {})});
            pieces.push_back(fieldPiece(path.substr(i + 1, end - i - 1), where));
            pieces.back().begin = i;
            i = end;
        }
    }
    pieces.push_back({.text = literal});
    return pieces;
}

}  // namespace

std::filesystem::path outputPath(const Job& job, const std::string& aov, int frame, const std::string& ext) {
    std::string path;
    for (const Piece& piece : piecesOf(job.output.path, "output.path")) {
        if (!piece.isField)
            path += piece.text;
        else if (piece.text == "aov")
            path += aov;
        else if (piece.text == "frame")
            path += fmt::format("{:0{}}", frame, piece.digits);
        else if (piece.text == "ext")
            path += ext;
        else
            path += job.file.stem().string();
    }
    return path;
}

void checkOutputPath(const Job& job, const std::string& where) {
    const std::vector<Piece> pieces = piecesOf(job.output.path, where);
    const auto has = [&](const char* name) {
        return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.isField && p.text == name; });
    };
    const auto require = [&](const char* name, const std::string& reason, const char* hint) {
        if (!has(name))
            throw Error(ErrorKind::Input, where, fmt::format("the output path has no {{{}}}, but {}", name, reason),
                        hint);
    };
    const std::size_t frameCount = job.time.frames.frames().size();
    if (frameCount > 1 || job.time.wholeAnimation) {
        const std::string count = job.time.wholeAnimation ? "all" : std::to_string(frameCount);
        require("frame", fmt::format("{} frames would have this name", count), "add {frame:04}");
    }
    const std::size_t imageCount = job.output.aovs.size() + job.diagnostics.overlays.size();
    if (imageCount > 1) require("aov", fmt::format("{} images would have this name", imageCount), "add {aov}");
    const Piece& last = pieces.back();
    for (const auto& [aov, kind] : job.output.aovs)
        if (last.isField || !last.text.ends_with("." + kind))
            require("ext", fmt::format("{} is written as {}", aov, kind), "end the path with .{ext}");
    if (!last.isField && last.text.ends_with('/'))
        throw Error(ErrorKind::Input, where, "the output path is a folder", "add {aov}.{frame:04}.{ext}");
}

std::string outputTemplateIn(const std::filesystem::path& folder, const std::string& relativeTemplate) {
    if (std::filesystem::path(relativeTemplate).is_absolute()) return relativeTemplate;
    std::string escaped;
    for (const char c : folder.string()) escaped.append(c == '{' || c == '}' ? 2 : 1, c);
    return (std::filesystem::path(escaped) / relativeTemplate).lexically_normal().string();
}

void redirectOutput(Job& job, const std::filesystem::path& folder) {
    const std::string path = job.output.path;
    std::size_t kept = path.rfind('/') + 1;  // 0 without one
    for (const Piece& piece : piecesOf(path, "output.path"))
        if (piece.isField && piece.text != "scene") kept = std::min(kept, path.rfind('/', piece.begin) + 1);
    job.output.path = outputTemplateIn(folder, path.substr(kept));
    if (!job.statistics.path.empty())
        job.statistics.path = (folder / std::filesystem::path(job.statistics.path).filename()).string();
}

}  // namespace umbrage
