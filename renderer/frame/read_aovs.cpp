// SPDX-License-Identifier: Apache-2.0
#include "frame/read_aovs.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/state.h"
#include "job/aovs.h"

namespace umbrage {

AovReader::AovReader(const Scene& scene, Geometry& geometry, const Materials& materials, Surfaces& surfaces,
                     const GBuffer& gbuffer, Resolve& resolve)
    : scene_(scene),
      geometry_(geometry),
      materials_(materials),
      surfaces_(surfaces),
      gbuffer_(gbuffer),
      resolve_(resolve),
      silhouetteProgram_("outline.vert", "outline.frag", {fmt::format("SAMPLES {}", gbuffer.samples())}),
      contourProgram_("outline.vert", "outline.frag", {fmt::format("SAMPLES {}", gbuffer.samples()), "CONTOUR 1"}) {}

void AovReader::placeBefore(const PlacedMoment& before, const Eye& eye) {
    const Eye eyeBefore = makeEye(before.camera, gbuffer_.width(), gbuffer_.height());
    geometry_.update(scene_, before.moment, eyeBefore, &eye);
    previous_.rayScale = eyeBefore.rayScale;
    if (geometry_.deforms()) {
        const std::size_t sizeBytes = geometry_.positions().sizeBytes();
        previous_.positions.reserve("positions before", sizeBytes);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glCopyNamedBufferSubData(geometry_.positions().name(), previous_.positions.name(), 0, 0, GLsizeiptr(sizeBytes));
    }
    std::vector<gpu::vec4> rows;
    for (const gpu::InstanceData& instance : geometry_.instances()) {
        rows.insert(rows.end(), std::begin(instance.viewFromModel), std::end(instance.viewFromModel));
    }
    previous_.viewFromModel.reserve("matrices before", rows.size() * sizeof(gpu::vec4));
    previous_.viewFromModel.write(std::span<const gpu::vec4>(rows));
}

std::vector<float> AovReader::readSilhouette(const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    silhouetteProgram_.uniform(0, silhouettes.facingBase(group));
    silhouetteProgram_.uniform(1, l);
    return readLines(silhouetteProgram_, silhouettes);
}

std::vector<float> AovReader::readLines(const gpu::Program& program, const Silhouettes& silhouettes) {
    if (!lines_) lines_ = gpu::ScreenTarget("silhouette edges", GL_R8, {gbuffer_.width(), gbuffer_.height()}, nullptr);
    lines_.clear();
    lines_.framebuffer().bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    geometry_.bind();
    silhouettes.bind();
    gbuffer_.depthStencil.bind(0);
    program.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_LINES, 0, GLsizei(2 * geometry_.placedEdgeCount()));
    return lines_.readMean(1);
}

void AovReader::read(const FrameOutputs& outputs, const Masks& masks, const Silhouettes& silhouettes, const Eye& eye,
                     std::span<const std::size_t> shining, FramePixels& pixels) {
    const glm::mat4 worldFromView(eye.worldFromView);
    const auto readData = [&](const Resolve::Data& data) {
        return resolve_.readData(data, gbuffer_, masks, silhouettes, worldFromView);
    };
    const std::size_t pixelCount = std::size_t(gbuffer_.width()) * std::size_t(gbuffer_.height());
    if (outputs.geometry) pixels.normalAndDepth = readData({"normalAndDepth"});
    for (std::uint32_t first = 0; outputs.shadows && first < shining.size(); first += 4) {
        const std::vector<float> four = readData({"shadow", 4, false, first});
        for (std::size_t l = first; l < std::min<std::size_t>(first + 4, shining.size()); ++l) {
            std::vector<float>& shadow = pixels.lights[shining[l]].shadow;
            for (std::size_t i = 0; i < shadow.size(); ++i) shadow[i] = four[4 * i + l - first];
        }
    }
    for (const AovInfo& aov : kAovs) {
        if (!outputs.wants(aov.name)) continue;
        const int components = aov.channelCount();
        for (LightPlanes& planes : pixels.lights) {
            if (!aov.perLight()) break;
            AovPlane& plane = planes.aovs[std::string(aov.name)];
            plane.components = components;
            plane.values.resize(pixelCount * std::size_t(components));
        }
        if (aov.source != AovSource::GBuffer) continue;
        Resolve::Data data{aov.name, components, aov.sampling == AovSampling::First};
        if (!aov.perLight()) {
            pixels.aovs[std::string(aov.name)] = {readData(data), {}, components};
            continue;
        }
        for (data.firstLight = 0; data.firstLight < shining.size(); ++data.firstLight) {
            pixels.lights[shining[data.firstLight]].aovs.find(aov.name)->second.values = readData(data);
        }
    }
    if (outputs.wants("contour")) pixels.aovs["contour"] = {readLines(contourProgram_, silhouettes), {}, 1};
    readAgain(outputs, eye.emptyDepth(), pixels);
    gpu::checkGl("while reading AOVs");
}

void AovReader::readAgain(const FrameOutputs& outputs, float emptyDepth, FramePixels& pixels) {
    const bool ids = outputs.wants("ids"), motion = outputs.wants("motion");
    if (!outputs.scene && !ids && !motion) return;
    if (!again_) again_ = std::make_unique<SurfacesAgain>(gbuffer_.depthStencil);
    if (outputs.scene) pixels.scene = again_->countFragments(surfaces_, geometry_, materials_, emptyDepth);
    if (ids) pixels.aovs["ids"] = {{}, again_->readIds(surfaces_, geometry_, materials_, emptyDepth), 3};
    if (motion) {
        pixels.aovs["motion"] = {again_->readMotion(surfaces_, geometry_, materials_, emptyDepth, previous_), {}, 2};
    }
}

}  // namespace umbrage
