// SPDX-License-Identifier: Apache-2.0
// Two pictures: what closes a gate before any threshold (size, channels, NaN), and which limit decides.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "golden/comparison.h"
#include "golden/metrics.h"
#include "image/image.h"
#include "job/golden_rules.h"

namespace umbrage {

/// What holds for one picture.
struct ImageRules {
    MeasureSettings measure;
    std::vector<GoldenLimit> all, any;
    std::string skip, expectFailure;
};

/// Later rules win, key by key. Without any limit: equal.
/// @param name  of the file, with '/', for globs; or without folders
ImageRules rulesFor(std::span<const GoldenRule> rules, const std::string& name, const std::string& aov);

/// What is asked of another device's pictures where no pair says otherwise.
std::vector<GoldenRule> rulesOfOtherDevices();

/// Fills everything but name, aov and frame. Gates first, in the order size, channels and types, NaN and infinities;
/// infinities that are in both are equal (the depth of what is infinitely far). Integer channels must be equal unless a
/// limit on uint-different says otherwise. Limits on what a picture does not have (colours, integers) do not count.
/// @param equalFiles  byte by byte: nothing is measured
ImageResult compareImages(const StoredImage& golden, const StoredImage& output, const ImageRules& rules,
                          bool equalFiles = false);

}  // namespace umbrage
