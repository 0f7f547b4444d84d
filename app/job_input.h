// SPDX-License-Identifier: Apache-2.0
// What commands that work on sequences have in common: a sequence or a bare scene, and options that override it.
#pragma once

#include <string>

#include "job/job.h"
#include "options.h"

namespace umbrage {

/// @param input  a sequence (.yaml) or a scene (.gltf, .glb)
/// @throws Error(Usage, Input)
Job jobOf(const std::string& input, const JobOptions& options);

}  // namespace umbrage
