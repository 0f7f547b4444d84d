// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "bench/bench_file.h"
#include "commands.h"
#include "diagnostics/statistics_file.h"
#include "exit_codes.h"
#include "golden/reports.h"
#include "job/aovs.h"
#include "job/job.h"

namespace umbrage {

int runSchema(const SchemaOptions& options) {
    const bool page = options.markdown;
    const std::string text = options.aovs         ? aovReference()
                             : options.comparison ? comparisonSchema()
                             : options.bench      ? (page ? benchReference() : benchSchema())
                             : options.statistics ? (page ? statisticsReference() : statisticsSchema())
                                                  : (page ? jobReference() : jobSchema());
    std::fputs(text.c_str(), stdout);
    return kOk;
}

}  // namespace umbrage
