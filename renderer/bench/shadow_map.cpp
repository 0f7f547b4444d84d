// SPDX-License-Identifier: Apache-2.0
#include "bench/shadow_map.h"

#include <fmt/format.h>

#include "bench/shadow_map_faces.h"
#include "gpu/state.h"
#include "shading/lights.h"
#include "shadow/extent.h"

namespace umbrage {
namespace {

// Locations of uniforms: see shaders/shadow_map*.
constexpr GLint kFaces = 2, kWorldFromView = 3, kMapFromView = 6;

class ShadowMaps : public MaskMaker {
public:
    explicit ShadowMaps(const ShadowMapSettings& settings) : settings_(settings) {}

    void make(const MaskTask& task) override {
        for (std::size_t l = 0; l < task.lights.size(); ++l) {
            const std::vector<Eye> faces = shadowMapFaces(*task.lights[l], task.boxes, task.unseen, task.eye);
            if (faces.empty()) continue;
            std::vector<glm::mat4> mapFromView;
            for (const Eye& face : faces) {
                mapFromView.emplace_back(face.clipFromView * face.viewFromWorld * task.eye.worldFromView);
            }
            // One map after the other in the same memory: thirty lights with 8192 texels would not fit.
            const std::vector<gpu::Framebuffer>& targets = targetsFor(faces.size());
            for (std::size_t f = 0; f < faces.size(); ++f) {
                drawFace(task, *task.lights[l], faces[f], mapFromView[f], targets[f]);
            }
            compare(task, GLuint(l), mapFromView);
        }
    }

private:
    const std::vector<gpu::Framebuffer>& targetsFor(std::size_t faces) {
        if (targets_.size() < faces) {
            map_ = gpu::Texture("shadow map", GL_DEPTH_COMPONENT32F, {settings_.size, settings_.size, int(faces)});
            targets_.clear();
            for (int layer = 0; layer < int(faces); ++layer) targets_.emplace_back("shadow map", map_, layer);
        }
        return targets_;
    }

    void drawFace(const MaskTask& task, const PlacedLight& light, const Eye& face, const glm::mat4& mapFromView,
                  const gpu::Framebuffer& target) {
        const std::array<HalfSpace, 4> sides = sidesOfView(face);
        const LightReach reach = lightReach(light, shadowLight(light));
        std::vector<bool> leftOut;
        for (const Geometry::Bounds& box : task.boxes) {
            leftOut.push_back(outOfView(cornersOf(box), sides) || outOfReach(box, reach));
        }
        target.bind();
        gpu::RasterState state;
        state.depth = gpu::Depth::Nearer;
        state.depthWrite = true;
        state.depthClamp = true;
        gpu::apply(state);
        glClearBufferfv(GL_DEPTH, 0, &kInfinitelyFar);
        if (settings_.biased) {
            glEnable(GL_POLYGON_OFFSET_FILL);
            glPolygonOffset(-3.0f, -16.0f);
        }
        glProgramUniformMatrix4fv(draw_.name(), 0, 1, GL_FALSE, &mapFromView[0][0]);
        draw_.use();
        task.surfaces.drawCasters(task.geometry, leftOut);
    }

    void compare(const MaskTask& task, GLuint light, const std::vector<glm::mat4>& mapFromView) {
        const gpu::Texture& masks = task.masks.texture();
        if (masks.name() != maskName_) {
            maskName_ = masks.name();
            masks_.clear();
            for (int layer = 0; layer < masks.size().layers; ++layer) {
                const gpu::Framebuffer::Attachment color{&masks, layer};
                masks_.emplace_back("shadow map's mask", std::span(&color, 1), nullptr);
            }
            compare_ = gpu::Program("fullscreen.vert", "shadow_map_test.frag",
                                    {fmt::format("SAMPLES {}", masks.size().samples)});
        }
        masks_[light / LIGHTS_PER_GROUP].bind();
        gpu::RasterState state;
        state.color = gpu::ColorOp::OrBits;
        gpu::apply(state);
        task.gbuffer.bindTextures();
        task.silhouettes.bind();
        map_.bind(UNIT_SHADOW_MAP);
        const glm::mat3 worldFromView(task.eye.worldFromView);
        compare_.uniform(0, light);
        compare_.uniform(1, task.silhouettes.facingStride);
        compare_.uniform(kFaces, GLuint(mapFromView.size()));
        glProgramUniformMatrix3fv(compare_.name(), kWorldFromView, 1, GL_FALSE, &worldFromView[0][0]);
        glProgramUniformMatrix4fv(compare_.name(), kMapFromView, GLsizei(mapFromView.size()), GL_FALSE,
                                  &mapFromView[0][0][0]);
        compare_.use();
        noVertices_.bind();
        ++gpu::activity().draws;
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    static constexpr float kInfinitelyFar = 0.0f;
    ShadowMapSettings settings_;
    gpu::Texture map_;
    std::vector<gpu::Framebuffer> targets_, masks_;  // one a face; one a group of lights
    GLuint maskName_ = 0;
    gpu::Program draw_{"shadow_map.vert"}, compare_;
    gpu::VertexArray noVertices_{"full screen"};
};

}  // namespace

std::shared_ptr<MaskMaker> makeShadowMaps(const ShadowMapSettings& settings) {
    return std::make_shared<ShadowMaps>(settings);
}

}  // namespace umbrage
