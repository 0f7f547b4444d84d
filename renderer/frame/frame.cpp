// SPDX-License-Identifier: Apache-2.0
#include "frame/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "error.h"
#include "frame/caster_limits.h"
#include "frame/light_counts.h"
#include "frame/read_aovs.h"
#include "frame/read_host.h"
#include "frame/record.h"
#include "frame/tile_masks.h"
#include "frame/volume_diagnostics.h"
#include "gpu/profiler.h"
#include "shading/gbuffer.h"
#include "shading/host_resolve.h"
#include "shading/lights.h"
#include "shading/materials.h"
#include "shading/resolve.h"
#include "shading/surfaces.h"
#include "shadow/bounds.h"
#include "shadow/caster_parts.h"
#include "shadow/counts.h"
#include "shadow/depth_samples.h"
#include "shadow/extent.h"
#include "shadow/geometry.h"
#include "shadow/layers.h"
#include "shadow/masks.h"

namespace umbrage {
namespace {

/// Where a light's planes go.
using PlanesOf = std::function<LightPlanes&(const PlacedLight*)>;

/// Lights that are on, as positions in the moment's list; the others reach nothing and are skipped.
std::vector<std::size_t> lightsThatShine(const Moment& moment) {
    std::vector<std::size_t> shining;
    for (std::size_t l = 0; l < moment.lights.size(); ++l) {
        if (isOn(moment.lights[l].light)) shining.push_back(l);
    }
    return shining;
}

/// A thousandth of the light's distance from the eye, or of its direction.
ShadowLight aside(const ShadowLight& light, const Eye& eye) {
    const double distance = light.w != 0.0 ? glm::distance(glm::dvec3(light), eye.position()) : 1.0;
    return {1e-3 * distance, 0.0, 0.0, 0.0};
}

/// Counts of groups of casters add up.
void addCounts(const std::vector<std::uint32_t>& counts, bool wide, LightPlanes& planes) {
    for (std::size_t i = 0; i < counts.size(); ++i) planes.counts[i] += counts[i];
    planes.countsAreWide = planes.countsAreWide || wide;
}

int checkedSamples(int samples, const gpu::Context& context) {
    if (samples <= context.maxSamples()) return samples;
    throw Error(ErrorKind::Input, "image.samples",
                fmt::format("{} samples a pixel, but {} has at most {}", samples, context.info().renderer,
                            context.maxSamples()));
}

}  // namespace

struct FrameRenderer::Impl {
    const Scene& scene;
    FrameSettings settings;
    gpu::Profiler profiler;
    Geometry geometry;
    Materials materials;
    Surfaces surfaces;
    GBuffer gbuffer;
    Resolve resolve;
    std::unique_ptr<SilhouetteTechnique> technique;
    LightCounts counts;
    Silhouettes silhouettes;
    std::unique_ptr<HostResolve> hostResolve;  // where that is faster
    SeenSample seen;                           // where something on the host wants it
    gpu::ViewData viewData;
    std::vector<gpu::LightData> lightsInView;
    std::unique_ptr<TileMasks> tiles;          // where counts are made by tiles
    std::unique_ptr<CasterParts> casterParts;  // these two where counts are made by parts
    std::unique_ptr<DepthSampler> depthSampler;
    std::vector<LightParts> parts;  // of all lights of the frame, where somebody wants to see them
    LayerBound layerBound{geometry};
    VolumeRenderer volumes{settings.samples, *technique};
    VolumeDiagnostics diagnostics{gbuffer, geometry, silhouettes, volumes};
    AovReader aovs{scene, geometry, materials, surfaces, gbuffer, resolve};
    CasterLimits limits;
    std::unique_ptr<Masks> masks;  // made anew when the number of groups of lights grows
    gpu::Buffer viewBuffer{"view", sizeof(gpu::ViewData)}, lightBuffer;
    Eye eye;  // of the last frame
    std::vector<ShadowLight> shadowLights;
    std::vector<std::size_t> shining;  // its lights that are on, as positions in the moment's list

    Impl(const Scene& s, const Moment& first, const FrameSettings& wanted, const gpu::Context& context)
        : scene(s),
          settings(wanted),
          profiler(wanted.profile, context.info().software),
          geometry(s, first, wanted.fault == Fault::WorldFloats),
          materials(s),
          surfaces(s, geometry),
          gbuffer(wanted.width, wanted.height, checkedSamples(wanted.samples, context)),
          resolve(gbuffer),
          technique(makeSilhouetteTechnique(wanted.silhouette, wanted.fault)),
          counts(wanted) {
        if (wanted.resolveOnHost && context.info().software && gbuffer.samples() == 1 && !surfaces.anyBlended()) {
            hostResolve = std::make_unique<HostResolve>();
        }
        if (counts.byTiles()) tiles = std::make_unique<TileMasks>();
        if (!counts.byParts()) return;
        casterParts = std::make_unique<CasterParts>(s, first, geometry, wanted.parts);
        silhouettes.parts = &casterParts->onDevice();
        depthSampler = std::make_unique<DepthSampler>(gbuffer.depthStencil);
    }

    void begin(Counter pass) { profiler.pass(int(pass.index())); }

    void uploadView(const std::vector<const PlacedLight*>& lights);
    CountSettings findCasters(bool halve, const std::vector<const PlacedLight*>& lights, int frame);
    void castShadows(const Moment& moment, const std::vector<const PlacedLight*>& lights, const FrameOutputs& outputs,
                     int frame, FrameRecorder& recorder, const PlanesOf& planesOf);
    /// What is shaded where the host does it.
    HostResolve::Input shadingInput() const {
        return {gbuffer, seen, *masks, silhouettes, viewData, lightsInView, surfaces.anyEmissive()};
    }
    std::vector<float> shade();
};

void FrameRenderer::Impl::uploadView(const std::vector<const PlacedLight*>& lights) {
    gpu::ViewData& view = viewData;
    view = viewDataOf(eye);
    view.background = {settings.background, 1.0f};
    view.ambientSky = {settings.ambientSky, 0.0f};
    view.ambientGround = {settings.ambientGround, 0.0f};
    view.lightCount = std::uint32_t(lights.size());
    view.pixelSize = {2.0f / float(settings.width), 2.0f / float(settings.height)};
    viewBuffer.write(0, sizeof view, &view);
    viewBuffer.bindUniform(BIND_VIEW);

    lightsInView.clear();
    shadowLights.clear();
    for (const PlacedLight* light : lights) {
        lightsInView.push_back(lightData(*light, eye));
        shadowLights.push_back(shadowLight(*light));
        if (settings.fault == Fault::ShiftedLight) shadowLights.back() += aside(shadowLights.back(), eye);
    }
    lightBuffer.reserve("lights", lightsInView.size() * sizeof(gpu::LightData));
    lightBuffer.write(std::span<const gpu::LightData>(lightsInView));
    lightBuffer.bindStorage(BIND_LIGHTS);
    placeLights(geometry, shadowLights, silhouettes);
    if (!masks || masks->texture().size().layers * LIGHTS_PER_GROUP < int(lights.size())) {
        masks = std::make_unique<Masks>(gbuffer.depthStencil, view.lightCount);
    }
}

/// T1: casters that are partly missing from the depth buffer need caps and are counted whole.
CountSettings FrameRenderer::Impl::findCasters(bool halve, const std::vector<const PlacedLight*>& lights, int frame) {
    silhouettes.casters.reserve("casters", geometry.instanceCount() * sizeof(gpu::CasterState));
    silhouettes.casters.clearToZero();
    silhouettes.hostCasters.assign(geometry.instanceCount(), {});
    if (settings.shadows && !tiles) {  // which looks at single triangles instead
        gbuffer.depthOnly.bind();
        surfaces.findExposed(geometry, materials, limits.unseen(), silhouettes.casters);
        silhouettes.casters.read(0, silhouettes.hostCasters.size() * sizeof(gpu::CasterState),
                                 silhouettes.hostCasters.data());
    }
    CountSettings found;
    found.eyeConstant = settings.eyeConstant && settings.fault != Fault::NoEyeConstant;
    found.halve = halve;
    found.perspective = eye.perspective;
    const std::vector<bool> nearer = nearerThanNearPlane(geometry, limits.modelBounds(), eye);
    found.holed = tiles ? std::vector<bool>(geometry.instanceCount()) : surfaces.holed();
    std::vector<std::string> ids;
    std::vector<double> rangesMetres;
    for (const PlacedLight* light : lights) {
        ids.push_back(light->id);
        rangesMetres.push_back(light->light.rangeMetres);
    }
    counts.begin({geometry, limits.modelBounds(), eye, shadowLights, rangesMetres}, frame, std::move(ids));
    std::vector<bool> whole(geometry.instanceCount());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (nearer[i] && !tiles) silhouettes.hostCasters[i].missing = 1;
        whole[i] = found.holed[i] || silhouettes.hostCasters[i].missing != 0 || counts.countsWhole(std::uint32_t(i));
    }
    geometry.setWhole(whole);
    return found;
}

void FrameRenderer::Impl::castShadows(const Moment& moment, const std::vector<const PlacedLight*>& lights,
                                      const FrameOutputs& outputs, int frame, FrameRecorder& recorder,
                                      const PlanesOf& planesOf) {
    begin("time.silhouettes");
    const bool halve = settings.halveEvenComponents && !outputs.counts;
    const CountSettings countSettings = findCasters(halve, lights, frame);
    if (tiles || technique->onHost()) silhouettes.hostTriangles.update(geometry);
    masks->clear();
    if (gbuffer.samples() == 1 && (tiles || hostResolve)) {
        resolve.readSeen(gbuffer, *masks, silhouettes, 0, glm::vec2(0.5f), seen);
    }
    parts.clear();
    std::vector<DepthSample> depthSamples;
    if (casterParts && casterParts->wantsSamples()) depthSamples = depthSampler->read();
    // Also without any light there is one sweep: it sets up the triangles' planes.
    for (std::uint32_t first = 0; first == 0 || first < lights.size(); first += LIGHTS_PER_GROUP) {
        const LightGroup group{first, std::min<std::uint32_t>(LIGHTS_PER_GROUP, std::uint32_t(lights.size()) - first)};
        begin("time.silhouettes");
        std::uint32_t byFail = counts.fromInfinity(group);
        for (std::uint32_t l = 0; l < group.count; ++l) {
            // z-fail has no constant there and would need caps of both ends; z-pass needs neither (T5).
            if (parallelToView(*lights[first + l], eye)) byFail &= ~(1u << l);
        }
        limits.limitVolumes(group, {lights, shadowLights, counts}, eye, settings, outputs.counts, silhouettes);
        if (casterParts) {
            const auto ofGroup = std::span(shadowLights).subspan(first, group.count);
            casterParts->choose(moment, geometry, limits.modelBounds(), ofGroup, first, eye, depthSamples);
            if (outputs.splitPlanes) {
                parts.insert(parts.end(), casterParts->chosen().begin(), casterParts->chosen().end());
            }
        }
        findSilhouettes(
            *technique, geometry, group, byFail,
            {settings.shadows || outputs.figures, halve, outputs.figures, tiles ? 0u : counts.withEyeConstant(group)},
            silhouettes);
        if ((tiles || hostResolve) && !technique->onHost()) silhouettes.readFaces(group);
        if (!settings.shadows || group.count == 0) continue;
        // The tile counter's own counts have no bound.
        const std::vector<std::uint32_t> layers =
            tiles ? std::vector<std::uint32_t>(group.count)
                  : layerBound.find(geometry, silhouettes, group, radiusOf(limits.boxes()));
        std::vector<std::vector<CountPlan>> plans;
        begin("time.counts");
        for (std::uint32_t l = 0; l < group.count; ++l) {
            const bool parallel = parallelToView(*lights[first + l], eye);
            plans.push_back(
                counts.plan({silhouettes, group, l, layers[l], parallel, countSettings}, *masks, volumes, geometry));
        }
        if (tiles) {
            tiles->count(plans, geometry, silhouettes, group,
                         {gbuffer, *masks, resolve, eye, std::span(lightsInView).subspan(group.first, group.count),
                          countSettings.eyeConstant, settings.skipOutOfReach, seen},
                         outputs.counts);
        }
        for (std::uint32_t l = 0; l < group.count; ++l) {
            begin("time.counts");
            LightPlanes& planes = planesOf(lights[first + l]);
            if (tiles && outputs.counts) addCounts(tiles->readCounts(l), true, planes);
            for (std::size_t p = 0; !tiles && p < plans[l].size(); ++p) {
                const CountPlan& plan = plans[l][p];
                masks->count(plan, volumes, geometry, silhouettes, group, l);
                const gpu::Uncounted uncounted;
                if (outputs.counts) addCounts(masks->readCounts(plan), plan.wide, planes);
            }
            profiler.pass(gpu::Profiler::kNoPass);
            if (VolumeDiagnostics::wanted(outputs)) {
                diagnostics.light(std::move(plans[l]), group, l, shining[first + l], halve, planes, recorder);
            }
            if (outputs.wants("silhouette")) {
                const gpu::Uncounted uncounted;
                planes.aovs["silhouette"].values = aovs.readSilhouette(silhouettes, group, l);
            }
        }
        diagnostics.endGroup(group);
    }
}

std::vector<float> FrameRenderer::Impl::shade() {
    begin("time.resolve");
    if (hostResolve) {
        return hostResolve->shade(shadingInput());
    }
    resolve.shade(gbuffer, *masks, silhouettes);
    if (surfaces.anyBlended()) {
        begin("time.blended");
        surfaces.drawBlended(geometry, materials, eye, limits.boxes());
    }
    begin("time.readback");
    return resolve.readRadiance();
}

FrameRenderer::FrameRenderer(const Scene& scene, const Moment& first, const FrameSettings& settings,
                             const gpu::Context& context)
    : impl_(std::make_unique<Impl>(scene, first, settings, context)) {
    gpu::applyDefaults();
}

FrameRenderer::~FrameRenderer() = default;

const Geometry& FrameRenderer::geometry() const {
    return impl_->geometry;
}

const FrameSettings& FrameRenderer::settings() const {
    return impl_->settings;
}

std::vector<float> FrameRenderer::shadeAgain(const std::vector<std::vector<std::uint8_t>>& reaches) {
    Impl& r = *impl_;
    for (std::uint32_t first = 0; first < r.shining.size(); first += LIGHTS_PER_GROUP) {
        std::vector<std::uint32_t> dark(reaches[r.shining[first]].size());
        for (std::size_t l = first; l < std::min<std::size_t>(first + LIGHTS_PER_GROUP, r.shining.size()); ++l) {
            const std::vector<std::uint8_t>& lit = reaches[r.shining[l]];
            for (std::size_t i = 0; i < dark.size(); ++i) dark[i] |= std::uint32_t(!lit[i]) << (l - first);
        }
        r.masks->set(first / LIGHTS_PER_GROUP, dark);
    }
    std::vector<float> radiance = r.shade();
    r.profiler.pass(gpu::Profiler::kNoPass);
    return radiance;
}

FramePixels FrameRenderer::render(const Moment& moment, const PlacedCamera& camera, const FrameOutputs& outputs,
                                  int frame, Statistics& statistics, const PlacedMoment* before) {
    Impl& r = *impl_;
    r.eye = makeEye(camera, r.settings.width, r.settings.height);
    r.eye.ledge = r.counts.ledge();
    glDepthRangef(0.0f, float(1.0 - r.eye.ledge));
    r.shining = lightsThatShine(moment);
    const Eye& eye = r.eye;
    std::vector<const PlacedLight*> lights;
    for (const std::size_t l : r.shining) lights.push_back(&moment.lights[l]);
    FramePixels pixels;
    const std::size_t pixelCount = std::size_t(r.settings.width) * std::size_t(r.settings.height);
    for (const PlacedLight& light : moment.lights) {
        LightPlanes& planes = pixels.lights.emplace_back();
        planes.id = light.id;
        if (outputs.shadows) planes.shadow.assign(pixelCount, 0.0f);
        if (outputs.counts) planes.counts.assign(pixelCount, 0);
    }
    const PlanesOf planesOf = [&](const PlacedLight* light) -> LightPlanes& {
        return pixels.lights[std::size_t(light - moment.lights.data())];
    };
    r.diagnostics.begin(outputs, pixels);
    const FrameRecorder::Picture picture{r.settings.width, r.settings.height, r.settings.samples};
    FrameRecorder recorder(r.scene, moment, r.geometry, picture, frame, statistics);

    if (outputs.wants("motion")) {
        const gpu::Uncounted uncounted;
        r.aovs.placeBefore(before ? *before : PlacedMoment{moment, camera}, eye);
    }
    r.begin("time.position");
    r.geometry.update(r.scene, moment, eye);
    r.uploadView(lights);
    r.limits.begin(r.geometry, eye, r.settings);
    r.begin("time.gbuffer");
    r.gbuffer.begin(eye.emptyDepth());
    r.surfaces.drawOpaque(r.geometry, r.materials, r.limits.unseen());
    r.castShadows(moment, lights, outputs, frame, recorder, planesOf);
    if (r.settings.maskMaker) {
        r.begin("time.counts");
        r.settings.maskMaker->make({r.geometry, r.surfaces, r.gbuffer, *r.masks, r.silhouettes, eye, lights,
                                    r.limits.boxes(), r.limits.unseen()});
    }
    pixels.notes = r.counts.takeNotes();
    if (outputs.radiance) pixels.radiance = r.shade();
    gpu::checkGl("while rendering");
    r.profiler.pass(gpu::Profiler::kNoPass);

    {
        const gpu::Uncounted uncounted;
        r.diagnostics.finish(r.scene, moment);
        r.aovs.read(outputs, *r.masks, r.silhouettes, eye, r.shining, pixels);
        if (r.hostResolve && outputs.wants("light")) shadeLights(r.shadingInput(), *r.hostResolve, r.shining, pixels);
        if (outputs.samples) readSamples(r.shadingInput(), r.resolve, eye, r.shining, pixels);
        if (outputs.splitPlanes) drawSplitPlanes(r.settings, r.parts, r.shadowLights, eye, r.shining, pixels);
    }
    if (outputs.figures && outputs.scene) recorder.scene(pixels.scene);
    if (outputs.figures) recorder.finish(moment.lights.size() - lights.size(), r.counts.fellBackCount());
    for (const auto& [pass, milliseconds] : r.profiler.collect()) pixels.milliseconds[std::size_t(pass)] = milliseconds;
    return pixels;
}

}  // namespace umbrage
