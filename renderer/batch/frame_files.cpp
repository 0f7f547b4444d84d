// SPDX-License-Identifier: Apache-2.0
#include "batch/frame_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "batch/overlays.h"
#include "frame/settings.h"
#include "job/aovs.h"
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
    const AovMetadata& metadataOf;
    std::vector<float> displayed;  // RGBA display values, where a file shows them

    int width() const { return job.image.width; }
    int height() const { return job.image.height; }

    std::vector<std::string> lightIds() const {
        std::vector<std::string> ids;
        for (const LightPlanes& light : pixels.lights) ids.push_back(light.id);
        return ids;
    }
};

/// A channel's first value and the distance to the next.
struct Values {
    std::variant<const float*, const std::uint32_t*, const std::uint8_t*> first;
    int stride = 1;
};

/// Of an AOV that other parts of the program know by name, too: what it needs from a frame, and where a channel is.
struct Known {
    std::string_view aov;
    bool FrameOutputs::*needs;  // null: the radiance every frame has
    Values (*channel)(const FramePixels& pixels, const LightPlanes* light, int channel);
};
constexpr Known kKnown[] = {
    {"beauty", nullptr,
     [](const FramePixels& p, const LightPlanes*, int c) {
         return Values{p.radiance.data() + c, 4};
     }},
    {"depth", &FrameOutputs::geometry,
     [](const FramePixels& p, const LightPlanes*, int) {
         return Values{p.normalAndDepth.data() + 3, 4};
     }},
    {"normal", &FrameOutputs::geometry,
     [](const FramePixels& p, const LightPlanes*, int c) {
         return Values{p.normalAndDepth.data() + c, 4};
     }},
    {"shadow", &FrameOutputs::shadows,
     [](const FramePixels&, const LightPlanes* light, int) { return Values{light->shadow.data()}; }},
    {"stencil", &FrameOutputs::counts,
     [](const FramePixels&, const LightPlanes* light, int) { return Values{light->counts.data()}; }},
    {"overdraw", &FrameOutputs::overdraw,
     [](const FramePixels& p, const LightPlanes*, int c) {
         return Values{(c == 0 ? p.overdrawFragments : p.overdrawUpdates).data()};
     }},
    {"scene", &FrameOutputs::scene,
     [](const FramePixels& p, const LightPlanes*, int c) {
         return Values{(c == 0 ? p.scene.fragments : p.scene.shaded).data()};
     }},
};

const Known* knownAs(std::string_view aov) {
    const auto found = std::find_if(std::begin(kKnown), std::end(kKnown), [&](const Known& k) { return k.aov == aov; });
    return found == std::end(kKnown) ? nullptr : found;
}

/// @param light  of a channel of its own; else null
Values valuesOf(const FramePixels& pixels, const AovInfo& aov, const LightPlanes* light, int channel) {
    if (const Known* known = knownAs(aov.name)) return known->channel(pixels, light, channel);
    const AovPlane& plane = (light ? light->aovs : pixels.aovs).find(aov.name)->second;
    if (!plane.integers.empty()) return {plane.integers.data() + channel, plane.components};
    return {plane.values.data() + channel, plane.components};
}

PixelType storedType(const Job& job, const AovInfo& aov) {
    switch (aov.format) {
        case AovFormat::Colour:
            return job.output.exrHalf ? PixelType::Half : PixelType::Float;
        case AovFormat::Half:
            return PixelType::Half;
        case AovFormat::Float:
            return PixelType::Float;
        default:
            return PixelType::UInt32;
    }
}

/// Of one AOV, or of several as layers.
ImageFile exrOf(const Writing& w, const std::vector<const AovInfo*>& aovs) {
    ImageFile file{w.width(), w.height(), {}, w.metadata};
    std::string meaning, sampling;
    for (const AovInfo* aov : aovs) {
        const auto more = w.metadataOf.find(aov->name);
        if (more != w.metadataOf.end())
            file.metadata.insert(file.metadata.end(), more->second.begin(), more->second.end());
        const char* separator = meaning.empty() ? "" : "\n";
        meaning += fmt::format("{}{}: {}", separator, aov->name, aov->meaning);
        const bool first = aov->sampling == AovSampling::First;
        sampling += fmt::format("{}{}: {}", separator, aov->name, first ? "first sample" : "mean");
        const std::vector<std::string> names = channelNames(*aov, w.lightIds());
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::size_t light = i / std::size_t(aov->channelCount());
            const Values values = valuesOf(w.pixels, *aov, aov->perLight() ? &w.pixels.lights[light] : nullptr,
                                           int(i % std::size_t(aov->channelCount())));
            file.channels.push_back({names[i], storedType(w.job, *aov), values.first, values.stride});
        }
    }
    file.metadata.emplace_back("umbrage:aovs", meaning);
    file.metadata.emplace_back("umbrage:sampling", sampling);
    return file;
}

ImageFile pngOf(const Writing& w) {
    const PixelType type = w.job.output.pngBits == 16 ? PixelType::UInt16 : PixelType::UInt8;
    const float* p = w.displayed.data();
    return {w.width(), w.height(), {{"R", type, p, 4}, {"G", type, p + 1, 4}, {"B", type, p + 2, 4}}, w.metadata};
}

std::string overlayFileName(std::string_view overlay) {
    return fmt::format("overlay-{}", overlay);
}

void writeOverlays(const Writing& w, const FramePixels* against) {
    OverlayInput input{w.width(), w.height(), w.frame, w.pixels, techniqueOf(w.job).name()};
    input.against = against;
    if (against) input.againstTechnique = techniqueAgainst(w.job).name();
    if (!w.displayed.empty()) input.beautyRgb = rgbBytes(w.displayed);
    input.burnIn = w.job.diagnostics.burnIn;
    for (const std::string& overlay : w.job.diagnostics.overlays) {
        const RgbPicture picture = overlayPicture(overlay, input);
        codec().write(outputPath(w.job, overlayFileName(overlay), w.frame, "png"), picture.file(w.metadata));
    }
}

template <class Visit>
void forEachAov(const Job& job, Visit visit) {
    for (const AovInfo& aov : kAovs) {
        const auto wanted = job.output.aovs.find(std::string(aov.name));
        const bool left = job.diagnostics.only && aov.name == "beauty";
        if (wanted != job.output.aovs.end() && !left) visit(aov, wanted->second);
    }
}

bool isLayer(const Job& job, const std::string& ext) {
    return ext == "exr" && !job.output.layers.empty();
}

}  // namespace

FrameOutputs neededOutputs(const Job& job) {
    FrameOutputs outputs;
    forEachAov(job, [&](const AovInfo& aov, const std::string&) {
        const Known* known = knownAs(aov.name);
        if (!known) outputs.aovs.emplace(aov.name);
        if (known && known->needs) outputs.*known->needs = true;
    });
    addNeeds(job.diagnostics.overlays, outputs);
    outputs.radiance = !job.diagnostics.only;
    // Counting costs far more than the picture, so a budget on time or memory alone does without.
    const bool counts = anyNeeds(job.statistics.budgets, BudgetNeeds::Counts);
    outputs.counts = outputs.counts || counts;
    outputs.figures = job.statistics.isWritten() || counts || anyNeeds(job.statistics.budgets, BudgetNeeds::Figures);
    outputs.scene = outputs.scene || outputs.figures;
    return outputs;
}

std::vector<FrameFile> frameFiles(const Job& job, int frame) {
    std::vector<FrameFile> files;
    const auto add = [&](const std::string& aov, const std::string& ext) {
        files.push_back({outputPath(job, aov, frame, ext), aov});
    };
    forEachAov(job, [&](const AovInfo& aov, const std::string& ext) {
        if (!isLayer(job, ext)) add(std::string(aov.name), ext);
    });
    if (!job.output.layers.empty()) files.push_back({layersPath(job, frame), "layers"});
    for (const std::string& overlay : job.diagnostics.overlays) add(overlayFileName(overlay), "png");
    return files;
}

void repeatFrameFiles(const Job& job, int frame, int earlier) {
    const std::vector<FrameFile> files = frameFiles(job, frame), there = frameFiles(job, earlier);
    for (std::size_t i = 0; i < files.size(); ++i) repeatWhole(files[i].path, there[i].path);
}

bool comparesTechniques(const Job& job) {
    const std::vector<std::string>& overlays = job.diagnostics.overlays;
    return std::find(overlays.begin(), overlays.end(), "techniques") != overlays.end();
}

AovMetadata idMetadata(const Scene& scene, const Moment& moment) {
    nlohmann::ordered_json objects = nlohmann::ordered_json::object(), materials = objects;
    for (std::size_t i = 0; i < moment.instances.size(); ++i) {
        objects[std::to_string(i + 1)] = scene.nodes[std::size_t(moment.instances[i].node)].path;
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        materials[std::to_string(i + 1)] = scene.materials[i].name;
    }
    materials[std::to_string(scene.materials.size() + 1)] = "(glTF's default)";
    // Names in a file may be anything; metadata is UTF-8.
    const auto text = [](const nlohmann::ordered_json& json) {
        return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    };
    return {{"ids", {{"umbrage:objects", text(objects)}, {"umbrage:materials", text(materials)}}}};
}

void writeFrameFiles(const Job& job, int frame, const FramePixels& pixels, const DisplayTransform& display,
                     const Metadata& metadata, const AovMetadata& metadataOf, const FramePixels* against) {
    Writing writing{job, frame, pixels, display, metadata, metadataOf, {}};
    const auto beauty = job.output.aovs.find("beauty");
    const bool shown =
        !job.diagnostics.overlays.empty() || (beauty != job.output.aovs.end() && beauty->second == "png");
    if (shown && !pixels.radiance.empty()) {
        writing.displayed = pixels.radiance;
        display.apply(writing.displayed);
    }
    std::vector<const AovInfo*> layers;
    forEachAov(job, [&](const AovInfo& aov, const std::string& ext) {
        if (isLayer(job, ext)) {
            layers.push_back(&aov);
        } else {
            codec().write(outputPath(job, std::string(aov.name), frame, ext),
                          ext == "exr" ? exrOf(writing, {&aov}) : pngOf(writing));
        }
    });
    if (!layers.empty()) codec().write(layersPath(job, frame), exrOf(writing, layers));
    writeOverlays(writing, against);
}

}  // namespace umbrage
