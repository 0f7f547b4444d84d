// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "commands.h"
#include "exit_codes.h"
#include "job/job.h"

namespace umbrage {

int runSchema(const SchemaOptions& options) {
    std::fputs((options.markdown ? jobReference() : jobSchema()).c_str(), stdout);
    return kOk;
}

}  // namespace umbrage
