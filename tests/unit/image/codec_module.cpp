// SPDX-License-Identifier: Apache-2.0
#include "image/codec_module.h"

#include <gmock/gmock.h>

#include <thread>

#include "error.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

void expectNotOpened(const std::vector<std::filesystem::path>& candidates, const std::vector<std::string>& parts) {
    try {
        openCodecModule(candidates);
        ADD_FAILURE() << "was opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Device);
        for (const auto& part : parts) EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

TEST(CodecModule, IsOneForAllThreads) {
    const std::future<void> prefetch = prefetchCodec();
    std::vector<const Codec*> seen(8);
    {
        std::vector<std::jthread> threads;
        for (auto& place : seen) threads.emplace_back([&place] { place = &codec(); });
    }
    EXPECT_THAT(seen, testing::Each(&codec()));
}

TEST(CodecModule, WhenMissingTheFilesLookedForAreNamed) {
    const TemporaryFolder folder;
    expectNotOpened({folder / kCodecModuleName, "libumbrage_no_such_codec.so"},
                    {(folder / kCodecModuleName).string(), "libumbrage_no_such_codec.so", "missing"});
}

TEST(CodecModule, WhenBrokenTheReasonIsGiven) {
    const TemporaryFolder folder;
    writeWhole(folder / kCodecModuleName, "this is no shared object");
    expectNotOpened({folder / kCodecModuleName}, {(folder / kCodecModuleName).string(), "does not open"});
}

TEST(CodecModule, AnotherLibraryOfThatNameIsRefused) {
    expectNotOpened({"libm.so.6"}, {"libm.so.6", kCodecFactoryName});
}

}  // namespace
}  // namespace umbrage
