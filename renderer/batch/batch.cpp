// SPDX-License-Identifier: Apache-2.0
#include "batch/batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "batch/frame_files.h"
#include "batch/frame_maker.h"
#include "batch/frame_reuse.h"
#include "batch/write_queue.h"
#include "error.h"
#include "frame/record.h"
#include "frame/settings.h"
#include "golden/provenance.h"
#include "gpu/context.h"
#include "image/image.h"
#include "image/thumbnail.h"
#include "job/output_path.h"
#include "report/statistics_page.h"
#include "version.h"

namespace umbrage {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

GltfOptions gltfOptionsOf(const BatchOptions& options) {
    GltfOptions gltf;
    gltf.allowExternalFiles = options.allowExternalFiles;
    return gltf;
}

/// Nothing in it changes from frame to frame of a picture that stands still.
Metadata metadataOf(const Composition& composition, const gpu::DeviceInfo& device, const DisplayTransform& display,
                    const Moment& moment) {
    std::vector<std::string> lights;
    for (const PlacedLight& light : moment.lights) lights.push_back(light.id);
    return {{"umbrage:version", std::string(kVersion)},
            {"umbrage:device", device.renderer + ", " + device.version},
            {"umbrage:camera", composition.scene.nodes[std::size_t(composition.cameraNode)].path},
            {"umbrage:lights", fmt::format("{}", fmt::join(lights, " "))},
            {"umbrage:display", display.description()}};
}

void say(const Composition& composition, const gpu::Context& context, const FrameOutputs& outputs,
         BatchObserver& observer) {
    for (const std::string& note : composition.scene.notes) observer.note(note);
    observer.note(fmt::format("device: {} ({})", context.info().renderer, context.info().version));
    if (outputs.counts) {
        observer.note("counts are asked for, so the skips that change them are off: halve, range, view, extent");
    }
}

/// Small pictures of the frames, made by the threads that write.
class Thumbnails {
public:
    void add(const Job& job, const WriteQueue::Item& item, const DisplayTransform& display) {
        Thumbnail thumbnail = thumbnailOf(job.image.width, job.image.height, item.pixels->radiance);
        display.apply(thumbnail.rgba);
        std::string png = thumbnail.png();
        const std::lock_guard lock(mutex_);
        pngs_[item.frame] = std::move(png);
    }

    void repeat(int frame, int earlier) {
        const std::lock_guard lock(mutex_);
        if (const auto found = pngs_.find(earlier); found != pngs_.end()) pngs_[frame] = found->second;
    }

    /// By frame; only when all threads are done.
    const std::map<int, std::string>& pngs() const { return pngs_; }

private:
    std::mutex mutex_;
    std::map<int, std::string> pngs_;
};

void writeStatistics(const Job& job, const StatisticsFile& file, const Thumbnails& thumbnails) {
    if (!job.statistics.path.empty()) {
        const bool csv = std::filesystem::path(job.statistics.path).extension() == ".csv";
        writeWhole(job.statistics.path, csv ? file.csv() : file.json());
    }
    if (!job.statistics.page.empty()) writeWhole(job.statistics.page, statisticsPage(file, thumbnails.pngs()));
}

/// Whether a frame can still be given to others: those who wait for frames may take away what is written.
bool isThere(const Job& job, int frame, const std::vector<int>& written) {
    if (std::ranges::find(written, frame) == written.end()) return true;
    return std::ranges::all_of(frameFiles(job, frame), [](const FrameFile& file) {
        std::error_code failed;
        return std::filesystem::exists(file.path, failed);
    });
}

std::map<std::string, ManifestImage> imagesOf(const Job& job, const std::vector<int>& frames) {
    const std::filesystem::path folder = outputFolder(job);
    std::map<std::string, ManifestImage> images;
    for (const int frame : frames) {
        for (const FrameFile& file : frameFiles(job, frame)) {
            images[file.path.lexically_relative(folder.empty() ? "." : folder).generic_string()] = {file.aov, frame};
        }
    }
    return images;
}

/// Beside the pictures, for those who compare them later.
void noteProvenance(const Job& job, const std::vector<int>& frames, const Provenance& from) {
    const Manifest manifest{from, imagesOf(job, frames)};
    if (!manifest.images.empty()) updateManifest(outputFolder(job), manifest);
}

}  // namespace

BatchSummary runBatch(const Job& asked, const BatchOptions& options, BatchObserver& observer,
                      const std::atomic<bool>& interrupted) {
    const Clock::time_point start = Clock::now();
    const std::future<void> prefetch = prefetchCodec();
    BatchSummary summary;

    const Composition composition = compose(asked, gltfOptionsOf(options));
    const FrameRange range = framesOf(asked, composition);
    const std::vector<int>& frames = range.frames();
    summary.requested = frames.size();
    summary.images = imagesOf(asked, frames);
    const gpu::Context context(options.device);
    const Job job = chosenFor(asked, context.info(), neededOutputs(asked));
    const Moment first = evaluate(composition.scene, composition.animations, frameSeconds(job, frames.front()));
    FrameMaker maker(job, composition, first, context, options.explain);
    const FrameOutputs& outputs = maker.outputs();
    const std::unique_ptr<DisplayTransform> display =
        codec().displayTransform({options.ocioConfig.empty() ? job.color.config : options.ocioConfig, job.color.display,
                                  job.color.view, job.color.exposureStops});
    say(composition, context, outputs, observer);
    if (job.time.wholeAnimation && composition.animations.empty()) {
        observer.note("the scene has no animation, so all its frames are frame 1");
    }
    observer.note(fmt::format("colour: {}", display->description()));
    const Metadata metadata = metadataOf(composition, context.info(), *display, first);
    const AovMetadata metadataOfAovs = outputs.wants("ids") ? idMetadata(composition.scene, first) : AovMetadata{};
    const std::string fingerprint = fingerprintOf(job.shape, composition.scene.sources, display->cacheId());
    summary.loadSeconds = secondsSince(start);
    observer.started(frames.size());

    const Clock::time_point renderStart = Clock::now();
    Statistics statistics;
    const bool needsMemory = job.diagnostics.profile || anyNeeds(job.statistics.budgets, BudgetNeeds::Memory);
    Thumbnails thumbnails;
    FrameReuse reuse(job, composition);
    {
        WriteQueue queue(options.workers, [&](const WriteQueue::Item& item) {
            if (item.sameAs) {
                repeatFrameFiles(job, item.frame, *item.sameAs);
                thumbnails.repeat(item.frame, *item.sameAs);
                return;
            }
            writeFrameFiles(job, item.frame, *item.pixels, *display, metadata, metadataOfAovs, item.against.get());
            if (!job.statistics.page.empty() && !item.pixels->radiance.empty()) thumbnails.add(job, item, *display);
        });
        const auto collect = [&](const std::vector<WriteQueue::Done>& done) {
            for (const WriteQueue::Done& frame : done) {
                summary.written.push_back(frame.frame);
                if (job.diagnostics.profile) statistics.record(frame.frame, {}, "time.encode", frame.milliseconds);
                if (needsMemory) statistics.record(frame.frame, {}, "memory.peak", peakHostMemoryMebibytes());
                observer.frameWritten(frame.frame, summary.written.size(), frames.size());
            }
        };
        for (const int frame : frames) {
            if (interrupted) break;
            const gpu::Activity begin = gpu::activity();
            const FrameMaker::Placed placed = maker.place(frame);
            const std::optional<int> earlier = reuse.find(frame, placed, maker.deforms());
            const bool reused = earlier && isThere(job, *earlier, summary.written);
            if (reused) {
                statistics.repeat(frame, *earlier);
                queue.push({frame, nullptr, nullptr, earlier});
            } else {
                WriteQueue::Item item = maker.make(frame, placed, statistics);
                for (const std::string& note : item.pixels->notes) observer.note(note);
                queue.push(std::move(item));
            }
            if (outputs.figures) {
                if (reused) recordActivity(frame, begin, statistics);
                statistics.record(frame, {}, "frames.reused", reused ? 1.0 : 0.0);
                statistics.record(frame, {}, "channels.idle", double(composition.idleChannels));
            }
            collect(queue.takeDone());
        }
        collect(queue.finish());
    }
    std::sort(summary.written.begin(), summary.written.end());
    std::set_difference(frames.begin(), frames.end(), summary.written.begin(), summary.written.end(),
                        std::back_inserter(summary.missing));
    summary.interrupted = interrupted && !summary.missing.empty();
    summary.renderSeconds = secondsSince(renderStart);
    summary.peakMemoryMebibytes = peakHostMemoryMebibytes();
    if (!summary.written.empty()) {
        const std::vector<FrameFile> files = frameFiles(job, summary.written.front());
        if (!files.empty()) summary.example = files.front().path;
    }
    const std::string processor = context.info().software ? processorFlags() : "";
    noteProvenance(job, summary.written,
                   {context.info().renderer, context.info().version, processor, std::string(kVersion), fingerprint});
    if (job.statistics.isWanted() || options.explain) {
        StatisticsFile& file = summary.statistics;
        file = statistics.file(
            {{"sequence", job.file.filename().string()},
             {"version", std::string(kVersion)},
             {"device", context.info().renderer},
             {"clock", context.info().software ? "wall clock between glFinish calls" : "GPU timer queries"}});
        file.budgets = checkBudgets(file, job.statistics.budgets);
        writeStatistics(job, file, thumbnails);
        summary.budgets = file.budgets;
    }
    return summary;
}

std::vector<std::filesystem::path> checkBatch(const Job& job, const BatchOptions& options) {
    const FrameRange range = framesOf(job, compose(job, gltfOptionsOf(options)));
    std::vector<std::filesystem::path> files;
    for (const int frame : range.frames()) {
        for (const FrameFile& file : frameFiles(job, frame)) files.push_back(file.path);
    }
    return files;
}

}  // namespace umbrage
