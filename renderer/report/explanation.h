// SPDX-License-Identifier: Apache-2.0
// A run's statistics told as what each frame left out and why, and what each light cost: for `umbrage render
// --explain`.
#pragma once

#include <string>

#include "diagnostics/statistics_file.h"

namespace umbrage {

/// A table a frame with a line for each light; frames of which the same can be said share one. What the columns mean
/// stands at the end.
std::string explanation(const StatisticsFile& file);

}  // namespace umbrage
