// SPDX-License-Identifier: Apache-2.0
// Names of output files: output.path and output.layers are templates with the fields {aov}, {frame} or {frame:04},
// {ext} and {scene}; {{ and }} stand for braces.
#pragma once

#include <filesystem>
#include <string>

#include "job/job.h"

namespace umbrage {

/// The file of one image. {scene} is the name of the job's file without extension.
/// @param aov  an AOV or overlay, as it shall appear in the name
/// @throws Error(Input) if job.output.path is no valid template; jobs from readJob() have a valid one
std::filesystem::path outputPath(const Job& job, const std::string& aov, int frame, const std::string& ext);

/// The file that holds all EXR AOVs of a frame; job.output.layers is its template.
std::filesystem::path layersPath(const Job& job, int frame);

/// The folder that all images of the job lie in or below.
std::filesystem::path outputFolder(const Job& job);

/// Throws Error(Input) at `where` if the template is malformed or would give two images of the job the same name.
void checkOutputPath(const Job& job, const std::string& where);
/// The same of job.output.layers, where there is one.
void checkLayersPath(const Job& job, const std::string& where);

/// Puts `folder` in front of a relative template.
std::string outputTemplateIn(const std::filesystem::path& folder, const std::string& relativeTemplate);

/// Replaces the folder part of output.path and output.layers, as far as it is the same for all images, and of
/// statistics.path: --out.
void redirectOutput(Job& job, const std::filesystem::path& folder);

}  // namespace umbrage
