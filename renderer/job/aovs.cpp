// SPDX-License-Identifier: Apache-2.0
#include "job/aovs.h"

#include <fmt/core.h>

#include <sstream>

namespace umbrage {
namespace {

constexpr const char* kIntroduction =
    "# AOVs\n\n"
    "What `output.aovs` can ask for, from the table that the renderer itself uses: `umbrage schema --aovs` wrote this\n"
    "page. An AOV that nobody asks for costs nothing.\n\n"
    "| AOV | channels | EXR type | of a pixel | meaning | background |\n|---|---|---|---|---|---|\n";

constexpr const char* kRest =
    "\n`LIGHT` is a light's id: the path of its node with `/` turned to `_`. half/float: half, or float where\n"
    "`output.exrHalf` is off. Each AOV is a file of its own; with `output.layers: FILE.exr` all that are asked for as\n"
    "exr are channels of one file. A light that is off, or a light's share where it does not reach, is 0.\n\n"
    "- Data is never colour-managed. Colours in EXR are linear Rec.709, before exposure and view.\n"
    "- \"first sample\" is the value at one of the pixel's samples and at its place in the pixel, the same one for "
    "all\n"
    "  AOVs; \"mean\" is over all of them. Counts of fragments are of samples, divided by their number.\n"
    "- With `image.accumulation`, beauty, light, ambient, emissive and shadow are means over all pictures of the "
    "frame,\n"
    "  all others are of the first one, which is that of a frame without accumulation.\n"
    "- What is blended is in beauty alone; all others show the opaque surface behind it.\n"
    "- Axes are the scene's: right-handed, +Y up. Rows of pixels run down, and so does motion.Y.\n"
    "- `stencil` asks for exact counts, so the skips that change them (`shadow.skips`) are off in frames that write "
    "it.\n"
    "- `motion` compares with frame - 1 at the sequence's frame rate, before the first frame too: camera, objects,\n"
    "  skins, morphs and displacement.\n";

std::string_view formatName(AovFormat format) {
    switch (format) {
        case AovFormat::Colour:
            return "half/float";
        case AovFormat::Half:
            return "half";
        case AovFormat::Float:
            return "float";
        default:
            return "uint";
    }
}

std::string channelName(const std::string& pattern, const std::string& light) {
    const std::size_t star = pattern.find('*');
    return star == std::string::npos ? pattern : pattern.substr(0, star) + light + pattern.substr(star + 1);
}

std::vector<std::string> patternsOf(const AovInfo& aov) {
    std::vector<std::string> patterns;
    std::istringstream words{std::string(aov.channels)};
    for (std::string word; words >> word;) patterns.push_back(word);
    return patterns;
}

}  // namespace

std::vector<std::string> channelNames(const AovInfo& aov, const std::vector<std::string>& lightIds) {
    std::vector<std::string> names;
    for (const std::string& light : aov.perLight() ? lightIds : std::vector<std::string>{""}) {
        for (const std::string& pattern : patternsOf(aov)) names.push_back(channelName(pattern, light));
    }
    return names;
}

std::string aovReference() {
    std::string text = kIntroduction;
    for (const AovInfo& aov : kAovs) {
        std::string channels;
        for (const std::string& name : channelNames(aov, {"LIGHT"})) channels += fmt::format(" `{}`", name);
        text += fmt::format("| `{}` |{} | {}{} | {} | {} | {} |\n", aov.name, channels, formatName(aov.format),
                            aov.isPicture ? "; png" : "", aov.sampling == AovSampling::Mean ? "mean" : "first sample",
                            aov.meaning, aov.background);
    }
    return text + kRest;
}

}  // namespace umbrage
