// SPDX-License-Identifier: Apache-2.0
#include "golden_input.h"

#include <fmt/format.h>

#include "error.h"
#include "job/output_path.h"
#include "job_input.h"
#include "render_job.h"

namespace umbrage {
namespace {

/// Options that shape the job, as they were typed.
std::string jobArguments(const RenderOptions& render) {
    std::string text;
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) text += fmt::format(" {} '{}'", option, value);
    };
    add("--frames", render.job.frames);
    add("--size", render.job.size);
    add("--camera", render.job.camera);
    for (const std::string& set : render.job.set) add("--set", set);
    add("--out", render.out);
    return text;
}

}  // namespace

GoldenInput goldenInput(const std::vector<std::string>& inputs, const RenderOptions& render, bool quiet) {
    if (inputs.size() == 2) {
        return {inputs[0], inputs[1], {}, {}, {}, fmt::format("umbrage accept {} {}", inputs[0], inputs[1])};
    }
    Job job = jobOf(inputs[0], render.job);
    if (job.golden.path.empty()) {
        throw Error(ErrorKind::Usage, inputs[0], "names no goldens",
                    "add golden: {path: FOLDER}, or give two places: GOLDEN OUT");
    }
    if (!render.out.empty()) redirectOutput(job, render.out);
    const std::string arguments = inputs[0] + jobArguments(render);
    GoldenInput input{job.golden.path,
                      outputFolder(job),
                      job.golden.rules,
                      imagesOf(job, batchOptionsOf(render)),
                      "umbrage render " + arguments,
                      "umbrage accept " + arguments};
    BatchSummary summary = renderWatched(job, render, quiet);
    input.budgets = std::move(summary.budgets);
    input.interrupted = summary.interrupted;
    return input;
}

}  // namespace umbrage
