// SPDX-License-Identifier: Apache-2.0
// generate_scenes OUTDIR [SCENE...]: writes our own scenes, the same bytes at every run, and says what is in them.
// generate_scenes --stress ROOT [ID...]: the same for stress cases, as scenes/stress/ID.glb and configs/stress/ID.yaml.
// Exit code 1 if a figure that a scene promises is not met, 2 on wrong usage.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "scenes.h"
#include "stress/stress.h"

namespace {

constexpr struct {
    const char* name;
    void (*fill)(generator::Document&);
} kScenes[] = {
    {"courtyard", generator::courtyard},
    {"knight", generator::knight},
    {"knights", generator::knights},
    {"tree", generator::tree},
    {"tree-decomposed", generator::treeDecomposed},
    {"noise-spheres", generator::noiseSpheres},
    {"brabec-seidel-a", generator::brabecSeidelA},
    {"brabec-seidel-b", generator::brabecSeidelB},
    {"teapot-like", generator::teapotLike},
    {"pole", generator::pole},
    {"pipe", generator::pipe},
    {"lantern", generator::lantern},
    {"nested", generator::nested},
    {"hall", generator::hall},
};

using Names = std::vector<std::string_view>;

int usage() {
    fmt::print(stderr, "usage: generate_scenes OUTDIR [SCENE...]\n       generate_scenes --stress ROOT [ID...]\n");
    return 2;
}

bool wanted(const Names& names, std::string_view name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
}

bool allKnown(const Names& names, const auto& all, const auto& nameOf) {
    return std::ranges::all_of(names, [&](std::string_view name) {
        return std::ranges::any_of(all, [&](const auto& one) { return nameOf(one) == name; });
    });
}

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream << bytes;
    stream.close();
    if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

bool printBroken(std::string_view name, const generator::Document& document) {
    for (const std::string& promise : document.broken()) fmt::print(stderr, "{}: {}\n", name, promise);
    return document.broken().empty();
}

bool generate(const std::filesystem::path& folder, const char* name, void (*fill)(generator::Document&)) {
    generator::Document document;
    fill(document);
    const std::string glb = document.glb();
    write(folder / fmt::format("{}.glb", name), glb);
    const generator::Topology casters = document.casters();
    fmt::print("{:16} {:9} {:9} {:9} {:9} {:6} {:6} {:8} {:9}\n", name, document.everything().triangles,
               casters.triangles, casters.vertices, casters.edges, casters.pieces, casters.openEdges,
               casters.nonManifoldEdges, glb.size());
    return printBroken(name, document);
}

int generateScenes(const std::filesystem::path& folder, const Names& names) {
    if (!allKnown(names, kScenes, [](const auto& scene) { return scene.name; })) return usage();
    std::filesystem::create_directories(folder);
    fmt::print("{:16} {:>9} {:>9} {:>9} {:>9} {:>6} {:>6} {:>8} {:>9}\n", "scene", "triangles", "casters'", "vertices",
               "edges", "pieces", "open", "non-man.", "bytes");
    bool kept = true;
    for (const auto& [name, fill] : kScenes)
        if (wanted(names, name)) kept &= generate(folder, name, fill);
    return kept ? 0 : 1;
}

/// A comment of lines of up to 110 characters, each with `# ` in front.
std::string commentOf(const std::string& text) {
    constexpr std::size_t kWidth = 110;
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = text.size();
        if (end - begin > kWidth) end = text.rfind(' ', begin + kWidth);
        result += fmt::format("# {}\n", text.substr(begin, end - begin));
        begin = end + 1;
    }
    return result;
}

std::string yamlOf(const generator::stress::Case& one) {
    return commentOf(fmt::format("Stress case {}: {}", one.id, one.what)) +
           commentOf(fmt::format("Right: {}", one.answer)) + commentOf(fmt::format("Catches: {}", one.catches)) +
           fmt::format("umbrage: 1\nscene: [{{gltf: ../../scenes/stress/{}.glb}}]\n", one.id) + one.sequence;
}

bool generate(const std::filesystem::path& root, const generator::stress::Case& one) {
    generator::Document document(generator::Digits::Exact);
    one.fill(document);
    const std::string glb = document.glb();
    write(root / "scenes/stress" / fmt::format("{}.glb", one.id), glb);
    write(root / "configs/stress" / fmt::format("{}.yaml", one.id), yamlOf(one));
    fmt::print("{:6} {:9} {:9}  {}\n", one.id, document.everything().triangles, glb.size(), one.what);
    return printBroken(one.id, document);
}

int generateStress(const std::filesystem::path& root, const Names& names) {
    const auto cases = generator::stress::cases();
    if (!allKnown(names, cases, [](const auto& one) { return one.id; })) return usage();
    std::filesystem::create_directories(root / "scenes/stress");
    std::filesystem::create_directories(root / "configs/stress");
    fmt::print("{:6} {:>9} {:>9}  {}\n", "case", "triangles", "bytes", "what");
    bool kept = true;
    for (const auto& one : cases)
        if (wanted(names, one.id)) kept &= generate(root, one);
    return kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool stress = argc > 1 && std::string_view(argv[1]) == "--stress";
    const int root = stress ? 2 : 1;
    if (argc <= root) return usage();
    const Names names(argv + root + 1, argv + argc);
    return stress ? generateStress(argv[root], names) : generateScenes(argv[root], names);
} catch (const std::exception& error) {
    fmt::print(stderr, "generate_scenes: {}\n", error.what());
    return 1;
}
