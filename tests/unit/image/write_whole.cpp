// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <random>
#include <thread>

#include "error.h"
#include "image/image.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

std::string textOf(const std::filesystem::path& file) {
    const auto bytes = test::readBytes(file);
    return {bytes.begin(), bytes.end()};
}

void expectUnwritable(const std::filesystem::path& file, const std::string& bytes, const std::string& reason) {
    try {
        writeWhole(file, bytes);
        ADD_FAILURE() << "was written";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Output);
        EXPECT_EQ(error.where(), file.string());
        EXPECT_THAT(error.what(), HasSubstr(reason));
    }
}

/// Makes this process's writes beyond `bytes` fail, as on a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST(WriteWhole, WritesAndReplaces) {
    const TemporaryFolder folder;
    writeWhole(folder / "new/file.txt", "first");
    writeWhole(folder / "new/file.txt", std::string_view("a\0b", 3));
    EXPECT_EQ(textOf(folder / "new/file.txt"), std::string("a\0b", 3));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "new"), {}), 1);
}

TEST(WriteWhole, WorksWithoutAFolderInTheName) {
    const TemporaryFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    writeWhole("bare.txt", "x");
    std::filesystem::current_path(before);
    EXPECT_EQ(textOf(folder / "bare.txt"), "x");
}

TEST(WriteWhole, AFullDiskLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    writeWhole(folder / "file.txt", "old");
    {
        const FileSizeLimit limit(4096);
        expectUnwritable(folder / "file.txt", std::string(100000, 'x'), "File too large");
        expectUnwritable(folder / "other.txt", std::string(100000, 'x'), "File too large");
    }
    EXPECT_EQ(textOf(folder / "file.txt"), "old");
    EXPECT_EQ(folder.entryCount(), 1u);
}

TEST(WriteWhole, APictureThatDoesNotFitLeavesNothing) {
    const TemporaryFolder folder;
    std::vector<float> noise(128 * 128);
    std::mt19937 random(1);  // nothing that compression could shrink below the limit
    for (float& value : noise) value = static_cast<float>(random() % 100000) / 100000.0f;
    const FileSizeLimit limit(4096);
    for (const auto& [name, type] : {std::pair{"a.png", PixelType::UInt8}, {"a.exr", PixelType::Float}}) {
        const ImageFile image{128, 128, {{"Y", type, noise.data(), 1}}, {}};
        EXPECT_THROW(codec().write(folder / name, image), Error);
    }
    EXPECT_EQ(folder.entryCount(), 0u);
}

TEST(WriteWhole, AFolderThatCannotBeMadeIsNamedWithTheReason) {
    const TemporaryFolder folder;
    writeWhole(folder / "file", "x");
    expectUnwritable(folder / "file/inside.txt", "x", "Not a directory");
    expectUnwritable("/proc/umbrage/inside.txt", "x", "cannot make the folder");
}

TEST(WriteWhole, AFolderUnderTheNameIsKept) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "name/full");
    expectUnwritable(folder / "name", "x", "cannot put the file in place");
    EXPECT_TRUE(std::filesystem::exists(folder / "name/full"));
    EXPECT_EQ(folder.entryCount(), 1u);
}

TEST(WriteWhole, AReaderNeverSeesHalfAFileOfManyWriters) {
    const TemporaryFolder folder;
    const auto file = folder / "shared.txt";
    writeWhole(file, std::string(200000, 'a'));
    std::atomic<bool> done = false;
    std::vector<std::jthread> writers;
    for (const char letter : {'a', 'b'}) {
        writers.emplace_back([&, letter] {
            for (int i = 0; i < 200; ++i) writeWhole(file, std::string(200000, letter));
            done = true;
        });
    }
    while (!done) {
        const std::string seen = textOf(file);
        ASSERT_EQ(seen.size(), 200000u);
        ASSERT_EQ(seen.find_first_not_of(seen[0]), std::string::npos);
    }
    writers.clear();
    EXPECT_EQ(folder.entryCount(), 1u);
}

}  // namespace
}  // namespace umbrage
