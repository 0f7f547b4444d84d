// SPDX-License-Identifier: Apache-2.0
#include "job_input.h"

#include <fmt/format.h>

#include <filesystem>

#include "error.h"

namespace umbrage {
namespace {

bool isScene(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".gltf" || extension == ".glb";
}

/// A YAML string, whatever is in it.
std::string quoted(const std::string& text) {
    std::string made = "'";
    for (const char c : text) made.append(c == '\'' ? 2 : 1, c);
    return made + "'";
}

/// WIDTHxHEIGHT as the sequence file has it.
std::string sizeList(const std::string& text) {
    const std::size_t x = text.find('x');
    const std::string width = text.substr(0, x), height = x == std::string::npos ? "" : text.substr(x + 1);
    for (const std::string& number : {width, height}) {
        if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) {
            throw Error(ErrorKind::Usage, "--size", fmt::format("\"{}\" is not WIDTHxHEIGHT", text),
                        "two numbers of pixels, such as 640x480");
        }
    }
    return fmt::format("[{}, {}]", width, height);
}

/// Command-line options as the values of the sequence file that they override.
JobOverrides overridesOf(const JobOptions& options) {
    JobOverrides overrides;
    overrides.wholeAnimation = options.frames == "all";
    if (!options.frames.empty() && !overrides.wholeAnimation) {
        overrides.options.push_back({"--frames", "time.frames=" + quoted(options.frames)});
    }
    if (!options.size.empty()) overrides.options.push_back({"--size", "image.size=" + sizeList(options.size)});
    if (!options.camera.empty()) overrides.options.push_back({"--camera", "camera=" + quoted(options.camera)});
    overrides.set = options.set;
    overrides.budgets = options.budgets;
    return overrides;
}

}  // namespace

Job jobOf(const std::string& input, const JobOptions& options) {
    const std::filesystem::path file = input;
    std::error_code failed;
    if (!std::filesystem::exists(file, failed)) {
        throw Error(ErrorKind::Input, input, failed ? failed.message() : "there is no such file");
    }
    const JobOverrides overrides = overridesOf(options);
    return isScene(file) ? jobForScene(file, overrides) : readJob(file, overrides);
}

}  // namespace umbrage
