// SPDX-License-Identifier: Apache-2.0
#include "batch/frame_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "error.h"
#include "image/overlay.h"
#include "job/output_path.h"

namespace umbrage {
namespace {

/// One frame being written.
struct Writing {
    const Job& job;
    int frame;
    const FramePixels& pixels;
    const DisplayTransform& display;
    const Metadata& metadata;
    std::vector<float> displayed;  // RGBA display values, where a file shows them

    int width() const { return job.image.width; }
    int height() const { return job.image.height; }
    std::size_t pixelCount() const { return pixels.radiance.size() / 4; }

    void write(const std::string& aov, const std::string& ext, std::vector<Channel2D> channels) const {
        codec().write(outputPath(job, aov, frame, ext), {width(), height(), std::move(channels), metadata});
    }
};

Channel2D channel(std::string name, PixelType type, const float* pixels, int stride) {
    return {std::move(name), type, pixels, stride};
}

void writeBeauty(const Writing& w, const std::string& ext) {
    if (ext == "exr") {
        const PixelType type = w.job.output.exrHalf ? PixelType::Half : PixelType::Float;
        const float* rgba = w.pixels.radiance.data();
        w.write("beauty", ext,
                {channel("R", type, rgba, 4), channel("G", type, rgba + 1, 4), channel("B", type, rgba + 2, 4)});
        return;
    }
    const PixelType type = w.job.output.pngBits == 16 ? PixelType::UInt16 : PixelType::UInt8;
    const float* p = w.displayed.data();
    w.write("beauty", ext, {channel("R", type, p, 4), channel("G", type, p + 1, 4), channel("B", type, p + 2, 4)});
}

void writeDepth(const Writing& w, const std::string& ext) {
    w.write("depth", ext, {channel("Z", PixelType::Float, w.pixels.normalAndDepth.data() + 3, 4)});
}

void writeNormal(const Writing& w, const std::string& ext) {
    const float* n = w.pixels.normalAndDepth.data();
    const PixelType type = w.job.output.exrHalf ? PixelType::Half : PixelType::Float;
    w.write("normal", ext,
            {channel("N.X", type, n, 4), channel("N.Y", type, n + 1, 4), channel("N.Z", type, n + 2, 4)});
}

void writeShadow(const Writing& w, const std::string& ext) {
    std::vector<Channel2D> channels;
    for (const LightPlanes& light : w.pixels.lights) {
        channels.push_back(channel("shadow." + light.id, PixelType::Half, light.shadow.data(), 1));
    }
    w.write("shadow", ext, std::move(channels));
}

void writeStencil(const Writing& w, const std::string& ext) {
    std::vector<Channel2D> channels;
    for (const LightPlanes& light : w.pixels.lights) {
        channels.push_back({"stencil." + light.id, PixelType::UInt32, light.counts.data(), 1});
    }
    w.write("stencil", ext, std::move(channels));
}

void writeOverdraw(const Writing& w, const std::string& ext) {
    w.write("overdraw", ext,
            {channel("overdraw.fragments", PixelType::Float, w.pixels.overdrawFragments.data(), 1),
             channel("overdraw.updates", PixelType::Float, w.pixels.overdrawUpdates.data(), 1)});
}

/// An AOV: what it needs, how it is written. A new one is one line (its name and meaning are in job/names.h).
struct Aov {
    std::string_view name;
    bool FrameOutputs::*needs;  // null: the radiance every frame has
    void (*write)(const Writing&, const std::string& ext);
};
constexpr Aov kAovWriters[] = {
    {"beauty", nullptr, writeBeauty},
    {"depth", &FrameOutputs::geometry, writeDepth},
    {"normal", &FrameOutputs::geometry, writeNormal},
    {"shadow", &FrameOutputs::shadows, writeShadow},
    {"stencil", &FrameOutputs::counts, writeStencil},
    {"overdraw", &FrameOutputs::overdraw, writeOverdraw},
};

std::vector<float> largestCounts(const Writing& w) {
    std::vector<float> largest(w.pixelCount(), 0.0f);
    for (const LightPlanes& light : w.pixels.lights) {
        for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], float(light.counts[i]));
    }
    return largest;
}

std::vector<float> fragmentsPerLight(const Writing& w) {
    std::vector<float> mean = w.pixels.overdrawFragments;
    for (float& fragments : mean) fragments /= float(std::max<std::size_t>(1, w.pixels.lights.size()));
    return mean;
}

struct Overlay {
    std::string_view name;
    bool FrameOutputs::*needs;
    std::vector<float> (*counts)(const Writing&);
    std::string_view title;
    float scaleMaximum;
};
constexpr Overlay kOverlayWriters[] = {
    {"stencil", &FrameOutputs::counts, largestCounts, "shadow count, highest of all lights", 16.0f},
    {"overdraw", &FrameOutputs::overdraw, fragmentsPerLight, "shadow volume fragments per light", 64.0f},
};

std::string overlayFileName(std::string_view overlay) {
    return fmt::format("overlay-{}", overlay);
}

void writeOverlay(const Writing& w, const Overlay& overlay) {
    const OverlayStyle style{std::string(overlay.title), overlay.scaleMaximum};
    const RgbPicture picture = drawOverlay(w.width(), w.height(), overlay.counts(w), rgbBytes(w.displayed), style);
    codec().write(outputPath(w.job, overlayFileName(overlay.name), w.frame, "png"), picture.file(w.metadata));
}

template <class Visit>
void forEachAov(const Job& job, Visit visit) {
    for (const Aov& aov : kAovWriters) {
        const auto wanted = job.output.aovs.find(std::string(aov.name));
        if (wanted != job.output.aovs.end()) visit(aov, wanted->second);
    }
}

template <class Visit>
void forEachOverlay(const Job& job, Visit visit) {
    for (const Overlay& overlay : kOverlayWriters) {
        const auto& wanted = job.diagnostics.overlays;
        if (std::find(wanted.begin(), wanted.end(), overlay.name) != wanted.end()) visit(overlay);
    }
}

}  // namespace

FrameOutputs neededOutputs(const Job& job) {
    FrameOutputs outputs;
    forEachAov(job, [&](const Aov& aov, const std::string&) {
        if (aov.needs) outputs.*aov.needs = true;
    });
    forEachOverlay(job, [&](const Overlay& overlay) { outputs.*overlay.needs = true; });
    outputs.figures = !job.statistics.path.empty();
    return outputs;
}

std::vector<std::filesystem::path> frameFiles(const Job& job, int frame) {
    std::vector<std::filesystem::path> files;
    forEachAov(job, [&](const Aov& aov, const std::string& ext) {
        files.push_back(outputPath(job, std::string(aov.name), frame, ext));
    });
    forEachOverlay(job, [&](const Overlay& overlay) {
        files.push_back(outputPath(job, overlayFileName(overlay.name), frame, "png"));
    });
    return files;
}

void writeFrameFiles(const Job& job, int frame, const FramePixels& pixels, const DisplayTransform& display,
                     const Metadata& metadata) {
    Writing writing{job, frame, pixels, display, metadata, {}};
    const auto beauty = job.output.aovs.find("beauty");
    if (!job.diagnostics.overlays.empty() || (beauty != job.output.aovs.end() && beauty->second == "png")) {
        writing.displayed = pixels.radiance;
        display.apply(writing.displayed);
    }
    forEachAov(job, [&](const Aov& aov, const std::string& ext) { aov.write(writing, ext); });
    forEachOverlay(job, [&](const Overlay& overlay) { writeOverlay(writing, overlay); });
}

}  // namespace umbrage
