// SPDX-License-Identifier: Apache-2.0
// The house stays a house: a room of renderer/ includes only rooms that renderer/CMakeLists.txt lists before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Rooms from the ground up, as the build lists them.
std::vector<std::string> roomsInOrder() {
    std::vector<std::string> rooms;
    std::istringstream lines(textOf(fs::path(UMBRAGE_SOURCE_DIR) / "renderer/CMakeLists.txt"));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("room(", 0) == 0) rooms.push_back(line.substr(5, line.find_first_of(" )") - 5));
    }
    return rooms;
}

TEST(Rooms, IncludeOnlyRoomsBelow) {
    const std::vector<std::string> rooms = roomsInOrder();
    ASSERT_GE(rooms.size(), 9u);
    std::size_t includes = 0;
    for (std::size_t r = 0; r < rooms.size(); ++r) {
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(UMBRAGE_SOURCE_DIR) / "renderer" / rooms[r])) {
            const fs::path kind = entry.path().extension();
            if (kind != ".cpp" && kind != ".h" && kind != ".inl") continue;
            std::istringstream lines(textOf(entry.path()));
            for (std::string line; std::getline(lines, line);) {
                if (line.rfind("#include \"", 0) != 0) continue;
                const std::string room = line.substr(10, line.find('/') - 10);
                const auto used = std::find(rooms.begin(), rooms.end(), room);
                if (used == rooms.end()) continue;  // error.h, shaders/shared.h, the room's own folder
                ++includes;
                EXPECT_LE(std::size_t(used - rooms.begin()), r) << entry.path().string() << ": " << line;
            }
        }
    }
    EXPECT_GT(includes, 100u);
}

/// What judges the renderer shares no code with it (docs/exactness.md).
TEST(Rooms, OnlyTheJudgeKnowsTheOracle) {
    for (const char* room : {"shadow", "shading", "frame"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(UMBRAGE_SOURCE_DIR) / "renderer" / room)) {
            if (!entry.is_regular_file()) continue;
            EXPECT_EQ(textOf(entry.path()).find("#include \"oracle/"), std::string::npos) << entry.path();
        }
    }
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(UMBRAGE_SOURCE_DIR) / "renderer" / "oracle")) {
        for (const char* room : {"shadow", "shading", "frame", "gpu"}) {
            EXPECT_EQ(textOf(entry.path()).find("#include \"" + std::string(room) + "/"), std::string::npos)
                << entry.path();
        }
    }
}

TEST(Rooms, SceneNeedsNoImageOrColourLibrary) {
    for (const char* room : {"scene", "job"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(UMBRAGE_SOURCE_DIR) / "renderer" / room)) {
            if (!entry.is_regular_file()) continue;
            const std::string text = textOf(entry.path());
            EXPECT_EQ(text.find("#include \"image/"), std::string::npos) << entry.path();
            EXPECT_EQ(text.find("#include <OpenImageIO"), std::string::npos) << entry.path();
            EXPECT_EQ(text.find("#include <OpenColorIO"), std::string::npos) << entry.path();
        }
    }
}

}  // namespace
