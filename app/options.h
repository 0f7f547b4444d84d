// SPDX-License-Identifier: Apache-2.0
// The command line as plain data. options.cpp alone knows how it is written.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace umbrage {

enum class ProgressKind { Auto, Bar, Lines, None };

struct RenderOptions {
    std::string input;  // a sequence (.yaml, .yml) or a scene (.gltf, .glb)
    std::string frames, size, camera, out, device = "auto", ocio;
    std::vector<std::string> set;
    int workers = 0;
    bool dryRun = false, allowExternalFiles = false;
    ProgressKind progress = ProgressKind::Auto;
};

struct InspectOptions {
    std::string scene;
    bool allowExternalFiles = false;
};

struct SchemaOptions {
    bool markdown = false;
};

struct Options {
    std::optional<RenderOptions> render;
    std::optional<InspectOptions> inspect;
    std::optional<SchemaOptions> schema;
    bool devices = false;
    bool quiet = false;
};

/// @return nothing when the program is done (help, version, or a usage error, which is printed); `exitCode` says so
std::optional<Options> parseOptions(int argc, char** argv, int& exitCode);

}  // namespace umbrage
