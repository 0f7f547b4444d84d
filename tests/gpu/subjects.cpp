// SPDX-License-Identifier: Apache-2.0
#include "subjects.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "judge/random_scene.h"
#include "scene/compose.h"

namespace umbrage::test {
namespace {

std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace

FrameSettings Subject::settings(const How& how) const {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.silhouette = how.technique.silhouette;
    settings.count = how.technique.count;
    settings.halveEvenComponents = how.halve;
    settings.skipOutOfReach = how.skipOutOfReach;
    settings.skipOutOfView = how.skipOutOfView;
    settings.endVolumes = how.endVolumes;
    settings.shadows = how.shadows;
    return settings;
}

Subject ours(const std::string& name, int width, int height) {
    const Job job = readJob(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs" / (name + ".yaml"));
    Composition composition = compose(job);
    Subject subject;
    subject.name = name;
    subject.width = width;
    subject.height = height;
    subject.timeSeconds = 0.5;
    subject.animations = composition.animations;
    subject.scene = std::move(composition.scene);
    subject.camera = placeCamera(subject.scene, subject.moment(), composition.cameraNode);
    return subject;
}

Subject solid(Subject subject) {
    for (Material& material : subject.scene.materials) {
        material.doubleSided = true;
        material.alphaMode = AlphaMode::Opaque;
    }
    return subject;
}

const std::vector<Subject>& subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> made;
        const std::uint64_t first = fromEnvironment("UMBRAGE_RANDOM_SEED", 1);
        const std::uint64_t count = fromEnvironment("UMBRAGE_RANDOM_SCENES", 32);
        std::printf("random scenes of seeds %llu to %llu\n", static_cast<unsigned long long>(first),
                    static_cast<unsigned long long>(first + count - 1));
        for (std::uint64_t seed = first; seed < first + count; ++seed) {
            RandomScene random = randomScene(seed);
            Subject subject;
            subject.name = "seed " + std::to_string(seed) + ": " + random.description;
            subject.scene = std::move(random.scene);
            subject.camera = random.camera;
            subject.width = random.width;
            subject.height = random.height;
            subject.tied = random.description.find("snapped") != std::string::npos;
            subject.seed = seed;
            made.push_back(std::move(subject));
        }
        made.push_back(ours("knight", 96, 72));
        made.push_back(ours("courtyard", 96, 72));
        return made;
    }();
    return all;
}

FramePixels picture(const Subject& subject, const Moment& moment, const How& how) {
    FrameOutputs outputs;
    outputs.samples = true;
    outputs.counts = how.counts;
    Statistics statistics;
    return FrameRenderer(subject.scene, moment, subject.settings(how), context())
        .render(moment, subject.camera, outputs, 1, statistics);
}

std::size_t shadowed(const Subject& subject, const FramePixels& pixels) {
    How how;
    how.shadows = false;
    return maskDifferences(pixels, picture(subject, how));
}

std::size_t maskDifferences(const FramePixels& a, const FramePixels& b) {
    EXPECT_EQ(a.lights.size(), b.lights.size());
    std::size_t differences = 0;
    for (const LightPlanes& one : a.lights) {
        const auto other = std::ranges::find(b.lights, one.id, &LightPlanes::id);
        if (other == b.lights.end() || one.reaches.size() != other->reaches.size()) {
            ADD_FAILURE() << "no such light: " << one.id;
            continue;
        }
        for (std::size_t i = 0; i < one.reaches.size(); ++i) differences += one.reaches[i] != other->reaches[i];
    }
    return differences;
}

std::uint64_t hardErrors(const Subject& subject, const Moment& moment, FramePixels& pixels) {
    FrameOutputs outputs;
    outputs.samples = true;
    Statistics statistics;
    FrameRenderer renderer(subject.scene, moment, subject.settings(), context());
    pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
    Judge judge(subject.scene, subject.width, subject.height, toleranceOf(context().subPixelBits()), 2);
    judge.setFrame(moment, subject.camera, renderer, pixels);
    VerdictPlanes planes;
    return judge.judge(pixels, "", planes).hard();
}

std::vector<Corners> castersOf(const Subject& subject, const Moment& moment) {
    std::vector<Corners> casters;
    for (const Instance& instance : moment.instances) {
        const Mesh& mesh = subject.scene.meshes[std::size_t(instance.mesh)];
        if (instance.skinned() || !mesh.morphTargets.empty() || instance.displacement != kNone) continue;
        for (const Primitive& primitive : mesh.primitives) {
            const bool opaque = primitive.material == kNone ||
                                subject.scene.materials[std::size_t(primitive.material)].alphaMode == AlphaMode::Opaque;
            if (primitive.topology != Topology::Triangles || !opaque) continue;
            for (std::uint32_t i = primitive.firstIndex; i < primitive.firstIndex + primitive.indexCount; i += 3) {
                Corners& t = casters.emplace_back();
                for (std::uint32_t k = 0; k < 3; ++k) {
                    t[k] = glm::dvec3(instance.worldFromModel *
                                      glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
                }
            }
        }
    }
    return casters;
}

}  // namespace umbrage::test
