// SPDX-License-Identifier: Apache-2.0
// generate_scenes OUTDIR [SCENE...]: writes our own scenes, the same bytes at every run, and says what is in them.
// Exit code 1 if a figure that a scene promises is not met, 2 on wrong usage.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "scenes.h"

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

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream << bytes;
    stream.close();
    if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
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
    for (const std::string& promise : document.broken()) fmt::print(stderr, "{}: {}\n", name, promise);
    return document.broken().empty();
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string_view> names(argv + std::min(argc, 2), argv + argc);
    const bool known = std::ranges::all_of(names, [](std::string_view name) {
        return std::ranges::any_of(kScenes, [&](const auto& scene) { return scene.name == name; });
    });
    if (argc < 2 || !known) {
        fmt::print(stderr, "usage: generate_scenes OUTDIR [SCENE...]\n");
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    fmt::print("{:16} {:>9} {:>9} {:>9} {:>9} {:>6} {:>6} {:>8} {:>9}\n", "scene", "triangles", "casters'", "vertices",
               "edges", "pieces", "open", "non-man.", "bytes");
    bool kept = true;
    for (const auto& [name, fill] : kScenes)
        if (names.empty() || std::ranges::find(names, name) != names.end()) kept &= generate(argv[1], name, fill);
    return kept ? 0 : 1;
} catch (const std::exception& error) {
    fmt::print(stderr, "generate_scenes: {}\n", error.what());
    return 1;
}
