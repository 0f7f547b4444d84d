// SPDX-License-Identifier: Apache-2.0
#include "judge/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <set>

#include "commands.h"
#include "error.h"
#include "exit_codes.h"
#include "frame/settings.h"
#include "interrupt.h"
#include "job/names.h"
#include "job_input.h"
#include "progress.h"
#include "report/error_picture.h"
#include "report/verify_report.h"
#include "say.h"
#include "version.h"

namespace umbrage {
namespace {

struct Sequence {
    std::string name;  // of its file, made unique
    std::optional<Job> job;
    std::string problem;  // why there is no job
};

/// @throws Error(Usage); what is wrong with one of them is kept with it
std::vector<Sequence> readSequences(const VerifyCommandOptions& options) {
    std::vector<Sequence> sequences;
    std::set<std::string> taken;
    for (const std::string& input : options.inputs) {
        Sequence& sequence = sequences.emplace_back();
        const std::string stem = std::filesystem::path(input).stem().string();
        sequence.name = stem;
        for (int use = 2; !taken.insert(sequence.name).second; ++use) sequence.name = fmt::format("{}-{}", stem, use);
        try {
            sequence.job = jobOf(input, options.job);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Input) throw;
            sequence.problem = error.what();
        }
    }
    return sequences;
}

Fault faultOf(const std::string& name) {
    const auto found = std::find_if(kFaults.begin(), kFaults.end(), [&](const auto& f) { return f.name == name; });
    return found == kFaults.end() ? Fault::None : found->fault;
}

/// Some techniques claim nothing; the textbook's z-pass and pictures without shadows are wrong by choice.
bool claimsExactness(const std::optional<Job>& job, const std::string& technique) {
    const std::string name = Technique::named(technique).count;
    const Exact exact = std::ranges::find(kCounts, name, &CountName::name)->exact;
    if (exact == Exact::Never) return false;
    if (!job) return true;
    const bool forced = exact == Exact::UnlessItSaysSo && job->shadow.whenInexact == "allow";
    const bool textbook = !job->shadow.eyeConstant && (name == "z-pass" || name == "invert");
    return job->shadow.enabled && !forced && !textbook;
}

/// Puts verdicts of one sequence into the report and draws what is wrong.
class Watch : public VerifyObserver {
public:
    Watch(const Sequence& sequence, const DisplayTransform& display, const VerifyCommandOptions& options,
          VerifyReport& report, Progress& progress)
        : sequence_(sequence), display_(display), options_(options), report_(report), progress_(progress) {}

    void note(const std::string& text) override { progress_.note(sequence_.name + ": " + text); }

    void started(std::size_t verdictCount) override { progress_.started(verdictCount, sequence_.name); }

    void judged(const FrameVerdict& verdict, const VerdictPlanes& planes, const std::vector<float>& radiance) override {
        report_.add(sequence_.name, claimsExactness(sequence_.job, verdict.technique), verdict);
        if (options_.pictures != Pictures::None) drawPicture(verdict, planes, radiance);
        if (options_.random > 0 && verdict.hard() + verdict.hardCounts() > 0) {
            progress_.note(fmt::format("random scene {} is wrong by {}; again: umbrage verify --random 1 --seed {}",
                                       verdict.frame, verdict.technique,
                                       options_.seed + std::uint64_t(verdict.frame) - 1));
        }
        std::string errors = fmt::format("{} hard", verdict.hard());
        if (options_.counts) errors += fmt::format(", {} wrong counts", verdict.hardCounts());
        progress_.advanced(
            fmt::format("{} frame {}, {}: {}", sequence_.name, verdict.frame, verdict.technique, errors));
    }

private:
    void drawPicture(const FrameVerdict& verdict, const VerdictPlanes& planes, const std::vector<float>& radiance) {
        std::string technique = verdict.technique;
        std::replace(technique.begin(), technique.end(), ':', '-');
        const std::filesystem::path file = std::filesystem::path(options_.out) / sequence_.name /
                                           fmt::format("{}.{:04}.png", technique, verdict.frame);
        if (verdict.hard() == 0 && options_.pictures == Pictures::Failed) {
            // One of an earlier run would say that the frame is still wrong.
            std::error_code ignored;
            std::filesystem::remove(file, ignored);
            return;
        }
        std::vector<float> displayed = radiance;
        display_.apply(displayed);
        const RgbPicture picture = drawErrors(sequence_.name, verdict, planes, rgbBytes(displayed));
        codec().write(file, picture.file({}));
        progress_.note(fmt::format("picture: {}", file.string()));
    }

    const Sequence& sequence_;
    const DisplayTransform& display_;
    const VerifyCommandOptions& options_;
    VerifyReport& report_;
    Progress& progress_;
};

/// Random scenes, as if they were frames of one sequence.
void judgeRandom(const Sequence& random, const VerifyCommandOptions& options, const VerifyOptions& common,
                 const gpu::Context& context, VerifyReport& report, Progress& progress,
                 const std::atomic<bool>& interrupted) {
    const auto display = codec().displayTransform({});
    VerifyOptions own = common;
    if (own.techniques.empty()) own.techniques = allTechniques();
    Watch watch(random, *display, options, report, progress);
    verifyRandom(options.seed, options.random, context, *display, own, watch, interrupted);
}

void judge(const Sequence& sequence, const VerifyCommandOptions& options, const VerifyOptions& common,
           const gpu::Context& context, VerifyReport& report, Progress& progress,
           const std::atomic<bool>& interrupted) {
    const Job job = chosenFor(*sequence.job, context.info());
    const auto display =
        codec().displayTransform({job.color.config, job.color.display, job.color.view, job.color.exposureStops});
    VerifyOptions own = common;
    if (own.techniques.empty()) own.techniques = {techniqueOf(job)};
    Watch watch(sequence, *display, options, report, progress);
    verify(job, context, *display, own, watch, interrupted);
}

/// Files first: whoever reads stdout may go away in the middle. The table is printed even where a file cannot be
/// written.
void writeReports(const VerifyReport& report, const VerifyCommandOptions& options) {
    const VerifyDetail detail{options.perFrame, options.perLight, options.summary};
    std::exception_ptr failed;
    try {
        if (!options.json.empty()) writeWhole(options.json, report.json(detail));
        if (!options.csv.empty()) writeWhole(options.csv, report.csv());
        if (!options.markdown.empty()) writeWhole(options.markdown, report.markdown(detail));
    } catch (const Error&) {
        failed = std::current_exception();
    }
    fmt::print("{}", report.table(detail));
    if (failed) std::rethrow_exception(failed);
}

}  // namespace

int runVerify(const VerifyCommandOptions& options, bool quiet) {
    VerifyOptions common;
    if (!options.techniques.empty()) common.techniques = parseTechniques(options.techniques);
    common.othersEvery = options.othersEvery;
    common.counts = options.counts;
    common.allowExternalFiles = options.allowExternalFiles;
    common.fault = faultOf(options.fault);

    const std::vector<Sequence> sequences = readSequences(options);
    const std::atomic<bool>& interrupted = watchForInterrupts();
    const std::future<void> prefetch = prefetchCodec();
    const gpu::Context context(options.device);
    const gpu::DeviceInfo& device = context.info();
    VerifyReport report({std::string(kVersion), device.renderer, device.version, options.commandLine, options.fault,
                         toleranceOf(context.subPixelBits()), options.maxHard});
    std::exception_ptr ended;
    {
        Progress progress(options.progress, quiet);
        progress.note(fmt::format("device: {} ({})", device.renderer, device.version));
        if (options.random > 0) {
            const Sequence random{fmt::format("random-{}", options.seed), {}, {}};
            judgeRandom(random, options, common, context, report, progress, interrupted);
        }
        for (const Sequence& sequence : sequences) {
            if (interrupted || ended) break;
            try {
                if (!sequence.job) throw Error(ErrorKind::Input, "", sequence.problem);
                judge(sequence, options, common, context, report, progress, interrupted);
            } catch (const Error& error) {
                report.addProblem(sequence.name, error.what());
                if (error.kind() == ErrorKind::Input) {
                    progress.error(error.what());
                } else {
                    ended = std::current_exception();  // what was judged is still written
                }
            }
        }
    }
    if (interrupted) report.addProblem("the rest", "interrupted");
    writeReports(report, options);
    if (ended) std::rethrow_exception(ended);
    if (interrupted) return interruptExitCode();
    if (report.anyProblem()) return kBadInput;
    return report.passed() ? kOk : kFramesFailed;
}

}  // namespace umbrage
