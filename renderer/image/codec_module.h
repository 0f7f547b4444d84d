// SPDX-License-Identifier: Apache-2.0
// The door between the library and the codec's module: where the module is looked for and what it exports.
#pragma once

#include <filesystem>
#include <span>

#include "image/image.h"

namespace umbrage {

inline constexpr const char* kCodecModuleName = "libumbrage_codec.so";
inline constexpr const char* kCodecFactoryName = "umbrageCodec";
using CodecFactory = const Codec* (*)();

/// Opens the first of `candidates` that exists and returns its codec, which lives as long as the process. A name
/// without a folder is looked for on the library path.
/// @throws Error(Device) that names the files looked for, or says why the one found does not open
const Codec& openCodecModule(std::span<const std::filesystem::path> candidates);

}  // namespace umbrage
