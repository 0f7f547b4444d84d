// SPDX-License-Identifier: Apache-2.0
// The forms of a comparison's report. The JSON has all of it; the others are views of the same model.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "golden/comparison.h"

namespace umbrage {

/// The comparison with its folders as they are seen from the folder of a report, so that the two can move together.
/// @param folder  where the report will be; relative paths start at the working directory
Comparison relativeTo(const std::filesystem::path& folder, Comparison comparison);

/// By comparisonSchema(). Numbers are in their shortest form; one that is not finite is null (an infinite PSNR is that
/// of equal pictures), and the outcome and its reason say why.
std::string comparisonJson(const Comparison& comparison);

/// @param name  of the file, for errors
/// @throws Error(Input) with the JSON pointer of what is not as comparisonJson() writes it
Comparison readComparison(std::string_view json, const std::string& name);

/// The JSON Schema (draft 2020-12) of comparisonJson().
std::string comparisonSchema();

/// JUnit's XML as Jenkins, GitLab and others read it: a suite for each AOV, one for the statistics and one for the
/// budgets. An expected failure counts as skipped. It has no times: equal comparisons are equal files.
std::string comparisonJunit(const Comparison& comparison);

/// One row an image, a column for every figure that some image has; empty where one has it not, "inf" and "nan". Then
/// one row a budget: "budget FIGURE", its worst frame, the rule "max" or "min", and the figure as the metric.
std::string comparisonCsv(const Comparison& comparison);

/// GitHub's workflow commands: an error for each that fails, a warning for each that warns, one a line.
std::string comparisonAnnotations(const Comparison& comparison);

/// A summary of a screenful in Markdown: the verdict, counts, the worst failures and what to do.
std::string comparisonMarkdown(const Comparison& comparison);

}  // namespace umbrage
