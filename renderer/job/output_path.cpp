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

bool has(const std::vector<Piece>& pieces, const char* field) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.isField && p.text == field; });
}

/// Throws unless a template for several images tells them apart.
void require(bool present, const std::string& where, const char* field, const std::string& reason, const char* hint) {
    if (present) return;
    throw Error(ErrorKind::Input, where, fmt::format("the output path has no {{{}}}, but {}", field, reason), hint);
}

void requireFrame(const Job& job, const std::vector<Piece>& pieces, const std::string& where) {
    const std::size_t frameCount = job.time.frames.frames().size();
    if (frameCount <= 1 && !job.time.wholeAnimation) return;
    const std::string count = job.time.wholeAnimation ? "all" : std::to_string(frameCount);
    require(has(pieces, "frame"), where, "frame", fmt::format("{} frames would have this name", count),
            "add {frame:04}");
}

/// Length of the template's folder, as far as it is the same for all images.
std::size_t commonFolder(const std::string& path, const char* where) {
    std::size_t kept = path.rfind('/') + 1;  // 0 without one
    for (const Piece& piece : piecesOf(path, where))
        if (piece.isField && piece.text != "scene") kept = std::min(kept, path.rfind('/', piece.begin) + 1);
    return kept;
}

/// That folder replaced by `folder`.
std::string redirected(const std::string& path, const std::filesystem::path& folder, const char* where) {
    return outputTemplateIn(folder, path.substr(commonFolder(path, where)));
}

std::filesystem::path filled(const std::string& path, const char* where, const Job& job, const std::string& aov,
                             int frame, const std::string& ext) {
    std::string name;
    for (const Piece& piece : piecesOf(path, where)) {
        if (!piece.isField)
            name += piece.text;
        else if (piece.text == "aov")
            name += aov;
        else if (piece.text == "frame")
            name += fmt::format("{:0{}}", frame, piece.digits);
        else if (piece.text == "ext")
            name += ext;
        else
            name += job.file.stem().string();
    }
    return name;
}

}  // namespace

std::filesystem::path outputPath(const Job& job, const std::string& aov, int frame, const std::string& ext) {
    return filled(job.output.path, "output.path", job, aov, frame, ext);
}

std::filesystem::path layersPath(const Job& job, int frame) {
    return filled(job.output.layers, "output.layers", job, "", frame, "");
}

std::filesystem::path outputFolder(const Job& job) {
    const auto folderOf = [&](const std::string& path, const char* where) {
        return filled(path.substr(0, commonFolder(path, where)), where, job, "", 0, "");
    };
    const std::filesystem::path folder = folderOf(job.output.path, "output.path");
    if (job.output.layers.empty()) return folder;
    const std::filesystem::path other = folderOf(job.output.layers, "output.layers");
    std::filesystem::path common;
    for (auto a = folder.begin(), b = other.begin(); a != folder.end() && b != other.end() && *a == *b; ++a, ++b) {
        common /= *a;
    }
    return common;
}

void checkOutputPath(const Job& job, const std::string& where) {
    const std::vector<Piece> pieces = piecesOf(job.output.path, where);
    requireFrame(job, pieces, where);
    const auto ofItsOwn = [&](const auto& aov) { return aov.second != "exr" || job.output.layers.empty(); };
    const auto imageCount = std::count_if(job.output.aovs.begin(), job.output.aovs.end(), ofItsOwn) +
                            std::ptrdiff_t(job.diagnostics.overlays.size());
    if (imageCount > 1)
        require(has(pieces, "aov"), where, "aov", fmt::format("{} images would have this name", imageCount),
                "add {aov}");
    const Piece& last = pieces.back();
    for (const auto& [aov, kind] : job.output.aovs) {
        if (ofItsOwn(std::pair(aov, kind)) && (last.isField || !last.text.ends_with("." + kind)))
            require(has(pieces, "ext"), where, "ext", fmt::format("{} is written as {}", aov, kind),
                    "end the path with .{ext}");
    }
    if (!last.isField && last.text.ends_with('/'))
        throw Error(ErrorKind::Input, where, "the output path is a folder", "add {aov}.{frame:04}.{ext}");
}

void checkLayersPath(const Job& job, const std::string& where) {
    if (job.output.layers.empty()) return;
    const std::vector<Piece> pieces = piecesOf(job.output.layers, where);
    for (const char* field : {"aov", "ext"}) {
        if (has(pieces, field))
            throw Error(ErrorKind::Input, where, fmt::format("the file of all AOVs has no {{{}}}", field),
                        "name it layers.{frame:04}.exr");
    }
    if (pieces.back().isField || !pieces.back().text.ends_with(".exr"))
        throw Error(ErrorKind::Input, where, "only EXR files have layers", "end the path with .exr");
    requireFrame(job, pieces, where);
    const auto isExr = [](const auto& aov) { return aov.second == "exr"; };
    if (std::none_of(job.output.aovs.begin(), job.output.aovs.end(), isExr))
        throw Error(ErrorKind::Input, where, "there is no AOV for this file", "ask for some as exr in output.aovs");
}

std::string outputTemplateIn(const std::filesystem::path& folder, const std::string& relativeTemplate) {
    if (std::filesystem::path(relativeTemplate).is_absolute()) return relativeTemplate;
    std::string escaped;
    for (const char c : folder.string()) escaped.append(c == '{' || c == '}' ? 2 : 1, c);
    return (std::filesystem::path(escaped) / relativeTemplate).lexically_normal().string();
}

void redirectOutput(Job& job, const std::filesystem::path& folder) {
    job.output.path = redirected(job.output.path, folder, "output.path");
    if (!job.output.layers.empty()) job.output.layers = redirected(job.output.layers, folder, "output.layers");
    for (std::string* path : {&job.statistics.path, &job.statistics.page}) {
        if (!path->empty()) *path = (folder / std::filesystem::path(*path).filename()).string();
    }
}

}  // namespace umbrage
