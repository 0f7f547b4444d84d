// SPDX-License-Identifier: Apache-2.0
#include "golden_input.h"

#include <fmt/format.h>

#include "command_line.h"
#include "error.h"
#include "job/output_path.h"
#include "job_input.h"
#include "render_job.h"

namespace umbrage {
namespace {

/// Options that shape the pictures or say where they go, as a shell takes them.
std::string jobArguments(const RenderOptions& render) {
    std::string text;
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) text += fmt::format(" {} {}", option, quotedForShell(value));
    };
    add("--frames", render.job.frames);
    add("--size", render.job.size);
    add("--camera", render.job.camera);
    for (const std::string& set : render.job.set) add("--set", set);
    add("--out", render.out);
    add("--ocio", render.ocio);
    return text;
}

}  // namespace

GoldenInput goldenInput(const std::vector<std::string>& inputs, const RenderOptions& render, bool quiet) {
    if (inputs.size() == 2) {
        const std::string accept =
            fmt::format("umbrage accept {} {}", quotedForShell(inputs[0]), quotedForShell(inputs[1]));
        return {inputs[0], inputs[1], {}, {}, {}, accept};
    }
    Job job = jobOf(inputs[0], render.job);
    if (job.golden.path.empty()) {
        throw Error(ErrorKind::Usage, inputs[0], "names no goldens",
                    "add golden: {path: FOLDER}, or give two places: GOLDEN OUT");
    }
    if (!render.out.empty()) redirectOutput(job, render.out);
    const std::string arguments = quotedForShell(inputs[0]) + jobArguments(render);
    BatchSummary summary = renderWatched(job, render, quiet);
    return {job.golden.path,
            outputFolder(job),
            job.golden.rules,
            std::move(summary.images),
            "umbrage render " + arguments,
            "umbrage accept " + arguments,
            std::move(summary.budgets),
            summary.interrupted};
}

}  // namespace umbrage
