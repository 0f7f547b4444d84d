// SPDX-License-Identifier: Apache-2.0
#include "golden/accept.h"

#include <fmt/core.h>
#include <unistd.h>

#include <iostream>
#include <string>

#include "commands.h"
#include "exit_codes.h"
#include "golden_input.h"
#include "interrupt.h"
#include "say.h"

namespace umbrage {
namespace {

void print(const AcceptPlan& plan) {
    for (const GoldenChange& change : plan.changes) {
        const char* what = change.kind == GoldenChange::Kind::Added     ? "added"
                           : change.kind == GoldenChange::Kind::Changed ? "changed"
                                                                        : "removed";
        fmt::print("{:8} {}{}{}\n", what, change.name, change.difference.empty() ? "" : ": ", change.difference);
    }
    fmt::print("{} pictures of {} would change, {} stay\n", plan.changes.size(), plan.golden.string(), plan.unchanged);
}

bool agrees(const AcceptPlan& plan) {
    if (isatty(STDIN_FILENO) == 0) {
        throw Error(ErrorKind::Usage, plan.golden.string(), "nothing was changed: there is nobody to ask",
                    "--yes does it without asking");
    }
    say("make this the golden frames? [y/N] ");
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "yes";
}

}  // namespace

int runAccept(const AcceptCommandOptions& options, bool quiet) {
    const GoldenInput input = goldenInput(options.inputs, options.render, quiet);
    if (input.interrupted) return interruptExitCode();
    const AcceptPlan plan = planAccept(input.golden, input.output, input.asked, options.statistics);
    if (plan.isForeign() && !options.force) {
        throw Error(ErrorKind::Input, plan.golden.string(),
                    fmt::format("the goldens were made by \"{}\", the output by \"{}\"",
                                deviceOf(plan.goldenFrom->from), deviceOf(plan.outputFrom->from)),
                    "--force-device replaces them nevertheless");
    }
    print(plan);
    if (plan.changes.empty()) return kOk;
    if (!options.yes && !agrees(plan)) {
        say("umbrage: nothing was changed\n");
        return kOk;
    }
    accept(plan);
    if (!quiet) say("umbrage: {} is up to date\n", plan.golden.string());
    return kOk;
}

}  // namespace umbrage
