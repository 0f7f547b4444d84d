// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <filesystem>

#include "batch/batch.h"
#include "budgets.h"
#include "commands.h"
#include "exit_codes.h"
#include "interrupt.h"
#include "job/output_path.h"
#include "job_input.h"
#include "render_job.h"
#include "report/explanation.h"
#include "say.h"

namespace umbrage {
namespace {

void printSummary(const BatchSummary& summary) {
    const std::filesystem::path folder = summary.example.parent_path().lexically_normal();
    const std::string where = summary.example.empty() ? "no folder" : folder.empty() ? "." : folder.string();
    const std::size_t done = summary.written.size();
    say("{} of {} frames in {}: {:.2f} s to load, {:.2f} s to render ({:.3f} s a frame), {:.0f} MiB at most\n", done,
        summary.requested, where, summary.loadSeconds, summary.renderSeconds, summary.renderSeconds / double(done),
        summary.peakMemoryMebibytes);
}

}  // namespace

int runRender(const RenderOptions& options, bool quiet) {
    Job job = jobOf(options.input, options.job);
    job.diagnostics.only = job.diagnostics.only || options.onlyDiagnostics;
    if (!options.out.empty()) redirectOutput(job, options.out);
    if (options.dryRun) {
        for (const std::filesystem::path& file : checkBatch(job, batchOptionsOf(options)))
            fmt::print("{}\n", file.string());
        return kOk;
    }
    const BatchSummary summary = renderWatched(job, options, quiet);
    const std::size_t done = summary.written.size();
    if (done > 0 && !quiet) printSummary(summary);
    if (options.explain) fmt::print("{}", explanation(summary.statistics));
    const ExitCode budgets = sayBudgets(summary.budgets, "");
    if (summary.interrupted) {
        say("umbrage: interrupted; frames still to render: --frames {}\n", FrameRange::textOf(summary.missing));
        return interruptExitCode();
    }
    return done == summary.requested ? budgets : kFramesFailed;
}

}  // namespace umbrage
