// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "diagnostics/statistics_file.h"
#include "report/plot.h"

namespace umbrage {

/// A counter over the frames: a line for each light that has it, else one for the whole frame.
/// @throws Error(Usage) with the nearest name where the file has no number of this counter
Plot statisticsPlot(const StatisticsFile& file, const std::string& counter);

}  // namespace umbrage
