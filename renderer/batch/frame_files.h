// SPDX-License-Identifier: Apache-2.0
// From a frame's pixels to its files: which AOVs and overlays a job wants, what they need from the frame, and how
// each becomes an image.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "image/image.h"
#include "job/job.h"

namespace umbrage {

/// What the job's files need read back.
FrameOutputs neededOutputs(const Job& job);

struct FrameFile {
    std::filesystem::path path;
    std::string aov;  // or overlay, as the name has it; "layers" of the file of all
};

/// The files of a frame, in the order they are written.
std::vector<FrameFile> frameFiles(const Job& job, int frame);

/// What only the EXR of an AOV holds, by the AOV's name.
using AovMetadata = std::map<std::string, Metadata, std::less<>>;

/// What the numbers of the AOV ids mean: {"1": "/Path", ...} of objects and of materials, as JSON.
AovMetadata idMetadata(const Scene& scene, const Moment& moment);

/// Encodes and writes all files of a frame. Thread-safe.
/// @param display  for what people look at
/// @param against  the same frame by techniqueAgainst(), where an overlay compares with it; else null
/// @throws Error(Output)
void writeFrameFiles(const Job& job, int frame, const FramePixels& pixels, const DisplayTransform& display,
                     const Metadata& metadata, const AovMetadata& metadataOf, const FramePixels* against);

/// Gives a frame the files of an earlier one, which are all there. Thread-safe.
/// @throws Error(Output)
void repeatFrameFiles(const Job& job, int frame, int earlier);

/// Whether an overlay compares two techniques.
bool comparesTechniques(const Job& job);

}  // namespace umbrage
