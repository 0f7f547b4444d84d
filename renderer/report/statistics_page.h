// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "diagnostics/statistics_file.h"

namespace umbrage {

/// One HTML file that needs nothing else: curves, histograms, tables and terms, the numbers inside as JSON.
/// @param thumbnails  PNG files by frame; frames may lack one
std::string statisticsPage(const StatisticsFile& file, const std::map<int, std::string>& thumbnails);

}  // namespace umbrage
