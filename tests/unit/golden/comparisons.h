// SPDX-License-Identifier: Apache-2.0
// Made-up comparisons with known figures and pictures.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "golden/comparison.h"
#include "golden/comparison_page.h"

namespace umbrage {

/// An image of each outcome, frame 1 of AOV "beauty" with the outcome's name; names that every form has to escape; four
/// budgets of which the second alone holds.
inline Comparison everyOutcome() {
    Comparison made;
    made.golden = "tests/golden/courtyard";
    made.output = "out/courtyard";
    made.goldenFrom = Provenance{"llvmpipe", "4.5 <Mesa>", "avx2 fma", "0.1.0", "cafe"};
    made.outputFrom = Provenance{"llvmpipe", "4.5 <Mesa>", "avx512", "0.1.0", "cafe"};
    made.foreignDevice = true;
    made.notes = {"no manifest.json beside \"stills\""};
    for (std::size_t o = 0; o < kOutcomes.size(); ++o) {
        ImageResult& image = made.images.emplace_back();
        image.name = fmt::format("beauty/{}.0001.png", kOutcomes[o].name);
        image.aov = "beauty";
        image.frame = 1;
        image.outcome = Outcome(o);
        image.width = 4;
        image.height = 3;
        image.channels = {"R", "G", "B", "A"};
    }
    ImageResult& pass = made.images[0];
    pass.decision = Decision{"default", "max-abs", 0.004, 0.0};
    pass.figures = {{"max-abs", 0.0}, {"psnr", std::numeric_limits<double>::infinity()}};
    ImageResult& fail = made.images[std::size_t(Outcome::Fail)];
    fail.decision = Decision{"shadows", "max-abs", 0.004, 0.7000000000000001};
    fail.figures = {{"max-abs", 0.7000000000000001}, {"psnr", 24.25}, {"flip", 0.1}};
    fail.reason = "more than the limit:\n50%, <a> & \"b\"";
    fail.worst = {3, 2};
    made.images[std::size_t(Outcome::Warn)].decision = Decision{"near", "psnr", 40.0, 39.5};
    made.images[std::size_t(Outcome::Skipped)].reason = "noise is skipped by \"noise*\"";
    made.images[std::size_t(Outcome::SizeMismatch)].reason = "5 x 3 instead of 4 x 3";
    made.images[std::size_t(Outcome::ExtraOutput)].aov = "";
    made.images[std::size_t(Outcome::ExtraOutput)].name = "odd, ]]> name%::file.png";
    made.statistics = {{"overdraw.fragments Lamp", 3, Outcome::Fail, 100.0, 125.5, 0.01, ""},
                       {"triangles", 0, Outcome::Pass, 12.0, 12.0, 0.0, ""}};
    made.budgets = {
        {.name = "overdraw.p95", .unit = "fragments/pixel", .limit = 6, .value = 7.25, .frame = 12, .exceeded = true},
        {.name = "triangles", .unit = "count", .limit = 456, .atLeast = true, .value = 456, .frame = 1},
        {.name = "caps.dark", .unit = "count", .limit = 2.5, .exceeded = true},
        {.name = "stencil.max",
         .unit = "layers",
         .limit = 2,
         .value = 3,
         .frame = 1,
         .light = "Lamp, <left>",
         .exceeded = true}};
    made.renderCommand = "umbrage render court\\ yard.yaml --out out/courtyard";
    made.acceptCommand = "umbrage accept tests/golden/courtyard out/courtyard";
    return made;
}

/// Frames 1 to `frames` of the AOVs beauty (PNG), depth and shadow.Lamp (EXR) and stencil.Lamp; those of beauty and
/// shadow fail in every sixteenth frame.
inline Comparison sequence(int frames) {
    Comparison made;
    made.golden = "tests/golden/courtyard";
    made.output = "out/courtyard";
    made.renderCommand = "umbrage render courtyard.yaml --out out/courtyard";
    made.acceptCommand = "umbrage accept tests/golden/courtyard out/courtyard";
    for (const std::string aov : {"beauty", "depth", "shadow.Lamp", "stencil.Lamp"}) {
        for (int frame = 1; frame <= frames; ++frame) {
            const bool isColor = aov == "beauty";
            const bool fails = frame % 16 == 0 && (isColor || aov == "shadow.Lamp");
            ImageResult& image = made.images.emplace_back();
            image.name = fmt::format("{}.{:04}.{}", aov, frame, isColor ? "png" : "exr");
            image.aov = aov;
            image.frame = frame;
            image.outcome = fails ? Outcome::Fail : Outcome::Pass;
            image.width = 64;
            image.height = 48;
            image.channels = isColor ? std::vector<std::string>{"R", "G", "B", "A"} : std::vector<std::string>{aov};
            const double value = fails ? 0.5 : 0.001 * (1.0 + std::sin(frame * 0.3));
            image.figures = {{"max-abs", value}, {"flip", value / 4.0}, {"psnr", 20.0 - 10.0 * std::log10(value)}};
            image.decision = Decision{"default", "max-abs", 0.004, value};
            if (fails) image.worst = {40, 30};
        }
    }
    return made;
}

/// All pictures pass, and one of two budgets does not hold.
inline Comparison overBudget() {
    Comparison made = sequence(15);
    const Comparison other = everyOutcome();
    made.budgets = {other.budgets[0], other.budgets[1]};
    return made;
}

/// Smooth bands with some noise, as a render has them; 0.5 more in a square of 8 x 8 at (40, 30) of an output that
/// fails.
inline PagePicture pictureOf(const ImageResult& image, int width, int height, bool isOutput) {
    PagePicture made{width, height, image.channels, {}, image.aov == "beauty"};
    const bool isDamaged = isOutput && !infoOf(image.outcome).passes;
    std::uint32_t noise = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool isHit = isDamaged && x >= 40 && x < 48 && y >= 30 && y < 38;
            for (std::size_t c = 0; c < image.channels.size(); ++c) {
                noise = noise * 1664525u + 1013904223u;
                const double wave =
                    0.4 + 0.3 * std::sin(x * 0.02 * double(c + 1) + image.frame * 0.1) * std::cos(y * 0.03);
                double value = wave + 0.02 * double(noise >> 24) / 255.0;
                if (image.aov == "stencil.Lamp") value = std::floor(value * 12.0);
                if (image.aov == "depth") value = 3.0 + 10.0 * wave;
                if (image.aov == "shadow.Lamp") value = wave > 0.45 ? 1.0 : 0.0;
                if (isHit) value = value > 0.5 ? value - 0.5 : value + 0.5;
                if (c == 3) value = 1.0;
                made.values.push_back(made.isDisplayEncoded ? float(std::lround(std::min(value, 1.0) * 255.0)) / 255.0f
                                                            : float(value));
            }
        }
    }
    return made;
}

inline PagePictures picturesOf(const ImageResult& image, int width, int height) {
    return {pictureOf(image, width, height, false), pictureOf(image, width, height, true)};
}

}  // namespace umbrage
