// SPDX-License-Identifier: Apache-2.0
// The one table of everything a sequence file may say. The parser (job_read.cpp), the JSON Schema and the reference
// page (job_schema.cpp) come from it; a new key is one line there.
#pragma once

#include "job/field_table.h"
#include "job/job.h"

namespace umbrage {

/// The whole file; paths are still as they are written.
Type<Job> sequenceType();

}  // namespace umbrage
