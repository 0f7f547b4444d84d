// SPDX-License-Identifier: Apache-2.0
// From a frame's pixels to its files: which AOVs and overlays a job wants, what they need from the frame, and how
// each becomes an image.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "frame/frame.h"
#include "image/image.h"
#include "job/job.h"

namespace umbrage {

/// What the job's files need read back.
FrameOutputs neededOutputs(const Job& job);

/// The files of a frame, in the order they are written.
std::vector<std::filesystem::path> frameFiles(const Job& job, int frame);

/// Encodes and writes all files of a frame. Thread-safe.
/// @param display  for what people look at
/// @throws Error(Output)
void writeFrameFiles(const Job& job, int frame, const FramePixels& pixels, const DisplayTransform& display,
                     const Metadata& metadata);

}  // namespace umbrage
