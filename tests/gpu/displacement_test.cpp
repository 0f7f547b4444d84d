// SPDX-License-Identifier: Apache-2.0
// Procedures that move vertices: against their formulas, and whether shadows follow.
#include "subjects.h"

namespace umbrage::test {
namespace {

/// A scene of ours with one procedure on every mesh.
Subject displaced(const char* name, Displacement::Kind kind, Track amplitude, const glm::vec3& axis) {
    Subject subject = ours(name, 128, 96);
    subject.scene.displacements.clear();
    for (std::size_t node = 0; node < subject.scene.nodes.size(); ++node) {
        if (subject.scene.nodes[node].mesh == kNone) continue;
        subject.scene.displacements.push_back({Index(node), kind, amplitude, glm::normalize(axis), 1.5f, 0.25f});
    }
    return subject;
}

Track constant(float value) {
    Track track;
    track.values = {value};
    return track;
}

/// Positions at rest and as the device moves them, both in model space.
struct Positions {
    std::vector<glm::dvec3> rest, moved;

    explicit Positions(const Subject& subject) {
        FrameRenderer renderer(subject.scene, subject.moment(), subject.settings(), context());
        FrameOutputs outputs;
        Statistics unused;
        renderer.render(subject.moment(), subject.camera, outputs, 1, unused);
        const Geometry& geometry = renderer.geometry();
        const std::vector<float> all = geometry.readPositions();
        for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
            if (!geometry.hasOwnVertices(i)) continue;
            const Mesh& mesh = subject.scene.meshes[geometry.meshOf(i)];
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                const float* p = &all[3 * (geometry.instances()[i].vertexBase + v)];
                rest.push_back(glm::dvec3(mesh.positions[v]) - geometry.originOf(i));
                moved.push_back({p[0], p[1], p[2]});
            }
        }
    }
};

TEST(Displacement, TwistTurnsAboutItsAxis) {
    const Subject subject = displaced("pole", Displacement::Kind::Twist, constant(0.8f), {0, 1, 0});
    const Positions positions(subject);
    ASSERT_GT(positions.rest.size(), 8u);
    double farthest = 0;
    for (std::size_t i = 0; i < positions.rest.size(); ++i) {
        const glm::dvec3 p = positions.rest[i];
        const double angle = 0.8 * p.y * std::cos(glm::two_pi<double>() * 0.25 * subject.timeSeconds);
        const glm::dvec3 turned(std::cos(angle) * p.x + std::sin(angle) * p.z, p.y,
                                std::cos(angle) * p.z - std::sin(angle) * p.x);
        EXPECT_LT(glm::distance(turned, positions.moved[i]), 1e-5 * (1.0 + glm::length(p)));
        farthest = std::max(farthest, glm::distance(p, turned));
    }
    EXPECT_GT(farthest, 0.01);
}

TEST(Displacement, WaveRunsAlongItsAxis) {
    const Subject subject = displaced("teapot-like", Displacement::Kind::Wave, constant(0.05f), {1, 0, 0});
    const Positions positions(subject);
    ASSERT_GT(positions.rest.size(), 100u);
    for (std::size_t i = 0; i < positions.rest.size(); ++i) {
        const double turns = 1.5 * positions.rest[i].x - 0.25 * subject.timeSeconds;
        const double height = 0.05 * std::abs(std::sin(glm::two_pi<double>() * turns));
        EXPECT_NEAR(glm::distance(positions.rest[i], positions.moved[i]), height, 1e-5);
    }
}

TEST(Displacement, AmplitudeFollowsItsTimeSamples) {
    Track growing;
    growing.timesSeconds = {0.0f, 1.0f};
    growing.values = {0.0f, 0.1f};
    const Positions half(displaced("pole", Displacement::Kind::Wave, growing, {0, 1, 0}));
    const Positions constantly(displaced("pole", Displacement::Kind::Wave, constant(0.05f), {0, 1, 0}));
    EXPECT_EQ(half.moved, constantly.moved);  // half a second in
    EXPECT_NE(half.moved, half.rest);
}

class DisplacementOf : public testing::TestWithParam<Displacement::Kind> {};
INSTANTIATE_TEST_SUITE_P(Procedures, DisplacementOf,
                         testing::Values(Displacement::Kind::Noise, Displacement::Kind::Wave,
                                         Displacement::Kind::Twist));

TEST_P(DisplacementOf, IsFollowedByShadows) {
    for (const char* name : {"knight", "teapot-like"}) {
        const Subject subject = displaced(name, GetParam(), constant(0.3f), {0.2f, 1, 0.1f});
        FramePixels pixels;
        EXPECT_EQ(hardErrors(subject, subject.moment(), pixels), 0u) << name;
        EXPECT_GT(shadowed(subject, pixels), 100u) << name;
    }
}

}  // namespace
}  // namespace umbrage::test
