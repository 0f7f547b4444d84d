// SPDX-License-Identifier: Apache-2.0
// The commands, one file each. They throw Error; main() maps it.
#pragma once

#include "options.h"

namespace umbrage {

int runRender(const RenderOptions& options, bool quiet);
int runCompare(const CompareCommandOptions& options, bool quiet);
int runAccept(const AcceptCommandOptions& options, bool quiet);
int runVerify(const VerifyCommandOptions& options, bool quiet);
int runBench(const BenchCommandOptions& options, bool quiet);
int runInspect(const InspectOptions& options);
int runStats(const StatsOptions& options);
int runDevices();
int runSchema(const SchemaOptions& options);

}  // namespace umbrage
