// SPDX-License-Identifier: Apache-2.0
#include "frame/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error.h"
#include "frame/volume_diagnostics.h"
#include "job/names.h"

namespace umbrage {
namespace {

glm::vec3 vec3Of(const std::array<double, 3>& v) {
    return {float(v[0]), float(v[1]), float(v[2])};
}

}  // namespace

std::vector<Technique> allTechniques() {
    std::vector<Technique> all;
    for (const std::string& name : techniqueNames()) all.push_back(Technique::named(name));
    return all;
}

Job chosenFor(Job job, const gpu::DeviceInfo& device, const FrameOutputs& outputs) {
    std::string &silhouette = job.shadow.silhouette, &count = job.shadow.count;
    // On a device that is a processor itself, host code without shaders between is several times faster.
    if (silhouette == "auto") silhouette = device.software ? "cpu" : "compute";
    if (count == "auto") {
        const bool tiles = device.software && canPair(silhouette, "tiles") && !VolumeDiagnostics::wanted(outputs);
        count = tiles ? "tiles" : "z-pass";
    }
    return job;
}

Technique techniqueOf(const Job& job) {
    const auto chosen = [](const std::string& name, const char* otherwise) {
        return name == "auto" ? otherwise : name;
    };
    return {chosen(job.shadow.silhouette, "compute"), chosen(job.shadow.count, "z-pass")};
}

Technique techniqueAgainst(const Job& job) {
    const std::string& name = job.diagnostics.against;
    if (name != "auto") return Technique::named(name);
    const Technique own = techniqueOf(job);
    return {own.silhouette, own.count == "z-fail" ? "z-pass" : "z-fail"};
}

void choose(const Technique& technique, FrameSettings& settings) {
    if (!canPair(technique.silhouette, technique.count)) {
        std::string others;
        for (const NameAndMeaning& silhouette : kSilhouettes) {
            if (!canPair(silhouette.name, technique.count)) continue;
            others += fmt::format("{}{}", others.empty() ? "" : ", ", silhouette.name);
        }
        throw Error(
            ErrorKind::Input, "shadow.count",
            fmt::format("{} cannot draw the sides that silhouette {} finds", technique.count, technique.silhouette),
            "those of " + others);
    }
    settings.silhouette = technique.silhouette;
    settings.count = technique.count;
}

FrameSettings settingsOf(const Job& job, const Composition& composition) {
    FrameSettings settings;
    settings.width = job.image.width;
    settings.height = job.image.height;
    settings.samples = job.image.samples;
    settings.accumulation = job.image.accumulation;
    settings.shadows = job.shadow.enabled;
    choose(techniqueOf(job), settings);
    const auto when = std::ranges::find(kWhenInexact, job.shadow.whenInexact, &NameAndMeaning::name);
    settings.whenInexact = WhenInexact(when - kWhenInexact.begin());
    settings.extrusionMetres = job.shadow.extrusionMetres;
    settings.eyeConstant = job.shadow.eyeConstant;
    settings.parts = job.shadow.parts;
    settings.halveEvenComponents = job.shadow.isSkipOn("halve");
    settings.skipOutOfReach = job.shadow.isSkipOn("range");
    settings.skipOutOfView = job.shadow.isSkipOn("view");
    settings.endVolumes = job.shadow.isSkipOn("extent");
    settings.background = vec3Of(job.image.background);
    settings.ambientSky = composition.ambientSky;
    settings.ambientGround = composition.ambientGround;
    settings.profile = job.diagnostics.profile;
    return settings;
}

FrameRange framesOf(const Job& job, const Composition& composition) {
    if (!job.time.wholeAnimation) return job.time.frames;
    double seconds = 0.0;
    for (const Index i : composition.animations) {
        seconds = std::max(seconds, composition.scene.animations[std::size_t(i)].durationSeconds());
    }
    // Key times are floats: 49/24 s may come out as a little more than 49 frames.
    const double last = std::ceil(seconds * job.time.framesPerSecond - 1e-3);
    return FrameRange::parse(fmt::format("1-{:.0f}", std::max(1.0, last)), "--frames all");
}

double frameSeconds(const Job& job, int frame) {
    return double(frame) / job.time.framesPerSecond;
}

PlacedMoment placedMoment(const Job& job, const Composition& composition, int frame) {
    Moment moment = evaluate(composition.scene, composition.animations, frameSeconds(job, frame));
    const PlacedCamera camera = placeCamera(composition.scene, moment, composition.cameraNode);
    return {std::move(moment), camera};
}

}  // namespace umbrage
