// SPDX-License-Identifier: Apache-2.0
// Real glTF files: sample assets, whose figures a table states, and broken ones, for which an index says what must
// happen. Both folders lie beside the source tree; without them the tests are skipped.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "error.h"
#include "scene/load_gltf.h"
#include "scene/moment.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

const fs::path kAssets = fs::path(UMBRAGE_ASSETS_DIR) / "assets";
const fs::path kMalformed = fs::path(UMBRAGE_ASSETS_DIR) / "assets-malformed";

struct Row {
    std::string file;
    int triangles = 0, nodes = 0, meshes = 0, lights = 0, animations = 0, cameras = 0;
    int pointLights = 0, spotLights = 0, directionalLights = 0;
    std::vector<double> size;  // three significant digits
};

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::stringstream stream(line);
    std::string cell;
    std::getline(stream, cell, '|');
    while (std::getline(stream, cell, '|')) {
        const auto begin = cell.find_first_not_of(' ');
        result.push_back(begin == std::string::npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
    }
    return result;
}

// "4 spot, 1 directional": the number before the noun.
int countBefore(const std::string& text, const std::string& noun) {
    const auto place = text.find(' ' + noun);
    if (place == std::string::npos) {
        return 0;
    }
    const auto begin = text.find_last_not_of("0123456789", place - 1);
    return std::stoi(text.substr(begin == std::string::npos ? 0 : begin + 1));
}

// "8.6×2.4×1.3"
std::vector<double> extents(const std::string& text) {
    std::vector<double> result;
    std::stringstream stream(text);
    for (double extent = 0.0; stream >> extent;) {
        result.push_back(extent);
        stream.ignore(std::string_view("×").size());
    }
    return result;
}

Row parseRow(const std::vector<std::string>& cell) {
    Row row;
    row.file = cell[0].substr(1, cell[0].size() - 2);
    row.triangles = std::stoi(cell[1]);
    row.nodes = std::stoi(cell[2]);
    row.meshes = std::stoi(cell[3]);
    row.pointLights = countBefore(cell[4], "point");
    row.spotLights = countBefore(cell[4], "spot");
    row.directionalLights = countBefore(cell[4], "directional");
    row.lights = row.pointLights + row.spotLights + row.directionalLights;
    row.animations = std::stoi(cell[5]);
    row.cameras = std::stoi(cell[6]);
    row.size = extents(cell[9]);
    return row;
}

std::vector<Row> readTable() {
    std::vector<Row> rows;
    std::ifstream readme(kAssets / "README.md");
    bool inFigures = false;
    for (std::string line; std::getline(readme, line);) {
        inFigures = line.starts_with("## ") ? line == "## Figures" : inFigures;
        if (inFigures && line.starts_with("| `")) {
            rows.push_back(parseRow(cells(line)));
        }
    }
    return rows;
}

std::vector<std::string> requiredExtensions(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    if (text.starts_with("glTF")) {
        std::uint32_t length = 0;
        std::memcpy(&length, text.data() + 12, 4);
        text = text.substr(20, length);
    }
    return nlohmann::json::parse(text).value("extensionsRequired", std::vector<std::string>{});
}

int lightNodes(const Scene& scene, LightType type) {
    return static_cast<int>(std::count_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
        return node.light != kNone && scene.lights[static_cast<std::size_t>(node.light)].type == type;
    }));
}

void expectFigures(const Scene& scene, const Row& row) {
    int triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += static_cast<int>(mesh.triangleCount());
    }
    EXPECT_EQ(triangles, row.triangles);
    EXPECT_EQ(scene.meshes.size(), row.meshes);
    EXPECT_EQ(scene.animations.size(), row.animations);
    EXPECT_EQ(scene.cameras.size(), row.cameras);
    EXPECT_EQ(lightNodes(scene, LightType::Point), row.pointLights);
    EXPECT_EQ(lightNodes(scene, LightType::Spot), row.spotLights);
    EXPECT_EQ(lightNodes(scene, LightType::Directional), row.directionalLights);
    // The table counts the nodes of all scenes; MultipleScenes has one in each of two.
    EXPECT_EQ(scene.nodes.size(), row.file.starts_with("MultipleScenes") ? 1 : row.nodes);
}

// Two rows do not describe what we see: instancing is an extension we ignore, and in AnimationPointer the table
// measures the cylinder as it is before its skin bends it.
void expectSize(const Scene& scene, const Row& row) {
    if (row.file.starts_with("SimpleInstancing") || row.file.starts_with("AnimationPointer")) {
        return;
    }
    const auto [low, high] = boundsOf(scene, evaluate(scene, {}, 0.0));
    for (int axis = 0; axis < 3; ++axis) {
        const double expected = row.size.at(static_cast<std::size_t>(axis));
        EXPECT_NEAR(high[axis] - low[axis], expected, 0.006 * expected + 1e-6) << "axis " << axis;
    }
}

void expectFinite(const Moment& moment) {
    for (const glm::dmat4& matrix : moment.worldFromNode) {
        for (int column = 0; column < 4; ++column) {
            EXPECT_TRUE(std::isfinite(glm::dot(matrix[column], glm::dvec4(1.0))));
        }
    }
}

void evaluateAll(const Scene& scene) {
    std::vector<Index> animations;
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        animations.push_back(static_cast<Index>(i));
    }
    expectFinite(evaluate(scene, animations, 0.0));
    expectFinite(evaluate(scene, animations, 0.5));
}

long peakKilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST(GltfCorpus, EveryBrokenFileIsTreatedAsItsIndexDemandsInBoundedTimeAndMemory) {
    if (!fs::exists(kMalformed / "index.json")) {
        GTEST_SKIP() << "no " << kMalformed;
    }
    const auto index = nlohmann::json::parse(std::ifstream(kMalformed / "index.json"));
    const long before = peakKilobytes();
    int loaded = 0, rejected = 0;
    for (const auto& entry : index) {
        const std::string file = entry["file"], expected = entry["expect"];
        SCOPED_TRACE(file);
        const auto start = std::chrono::steady_clock::now();
        try {
            const Scene scene = loadGltf(kMalformed / file);
            evaluateAll(scene);
            EXPECT_NE(expected, "reject");
            ++loaded;
        } catch (const Error& e) {
            EXPECT_NE(expected, "load") << e.what();
            EXPECT_NE(e.where().find(fs::path(file).filename().string()), std::string::npos) << e.what();
            EXPECT_FALSE(e.message().empty());
            ++rejected;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    }
    EXPECT_EQ(loaded + rejected, index.size());
    EXPECT_LT(peakKilobytes() - before, 64 * 1024) << "peak memory must follow the files' real sizes";
    RecordProperty("loaded", loaded);
    RecordProperty("rejected", rejected);
}

TEST(GltfCorpus, EveryAssetLoadsWithTheTablesFiguresOrIsRefusedForItsRequiredExtension) {
    if (!fs::exists(kAssets / "README.md")) {
        GTEST_SKIP() << "no " << kAssets;
    }
    const auto rows = readTable();
    ASSERT_EQ(rows.size(), 49);
    const auto supported = supportedExtensions();
    int refused = 0;
    for (const Row& row : rows) {
        SCOPED_TRACE(row.file);
        std::vector<std::string> missing;
        for (const std::string& extension : requiredExtensions(kAssets / row.file)) {
            if (std::find(supported.begin(), supported.end(), extension) == supported.end()) {
                missing.push_back(extension);
            }
        }
        try {
            const Scene scene = loadGltf(kAssets / row.file);
            EXPECT_TRUE(missing.empty());
            expectFigures(scene, row);
            expectSize(scene, row);
            evaluateAll(scene);
        } catch (const Error& e) {
            EXPECT_FALSE(missing.empty()) << e.what();
            for (const std::string& extension : missing) {
                EXPECT_NE(e.message().find(extension), std::string::npos) << e.what();
            }
            ++refused;
        }
    }
    EXPECT_EQ(refused, 4) << "Box and RiggedSimple with Draco, the two meshopt boxes";
}

TEST(GltfCorpus, TheSecondOfTwoScenesCanBeChosen) {
    const fs::path file = kAssets / "MultipleScenes/MultipleScenes.gltf";
    if (!fs::exists(file)) {
        GTEST_SKIP() << "no " << file;
    }
    const Scene first = loadGltf(file, {.scene = "0"}), second = loadGltf(file, {.scene = "1"});
    ASSERT_EQ(first.nodes.size(), 1);
    ASSERT_EQ(second.nodes.size(), 1);
    EXPECT_NE(first.nodes[0].mesh, second.nodes[0].mesh);
}

TEST(GltfCorpus, EveryIgnoredExtensionOfAnAssetIsNotedOnce) {
    const fs::path file = kAssets / "AnimationPointer/24_animation_pointer.gltf";
    if (!fs::exists(file)) {
        GTEST_SKIP() << "no " << file;
    }
    const Scene scene = loadGltf(file);
    EXPECT_EQ(
        std::count_if(scene.notes.begin(), scene.notes.end(),
                      [](const std::string& note) { return note.find("KHR_animation_pointer") != std::string::npos; }),
        1);
    EXPECT_EQ(std::set<std::string>(scene.extensionsIgnored.begin(), scene.extensionsIgnored.end())
                  .count("KHR_animation_pointer"),
              1);
}

}  // namespace
}  // namespace umbrage
