// SPDX-License-Identifier: Apache-2.0
// Rendering a job with its progress on stderr: for every command that renders.
#pragma once

#include "batch/batch.h"
#include "options.h"

namespace umbrage {

BatchOptions batchOptionsOf(const RenderOptions& options);

/// @throws Error
BatchSummary renderWatched(const Job& job, const RenderOptions& options, bool quiet);

}  // namespace umbrage
