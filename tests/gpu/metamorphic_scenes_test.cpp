// SPDX-License-Identifier: Apache-2.0
// Metamorphic tests that change the scene in a way that must not change the masks. M2: order; M3: finer triangles; M4:
// casters where it is dark already; M5: mirrored.
#include <random>

#include "subjects.h"

namespace umbrage::test {
namespace {

using Random = std::mt19937_64;

/// std::shuffle differs between standard libraries.
template <class T>
void shuffle(std::vector<T>& items, Random& random) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
}

bool ofTriangles(const Primitive& primitive) {
    return primitive.topology == Topology::Triangles;
}

/// A mesh's indices in another order: triangles within their primitive, and primitives.
void shuffle(Mesh& mesh, Random& random) {
    if (!std::ranges::all_of(mesh.primitives, ofTriangles)) return;
    shuffle(mesh.primitives, random);
    std::vector<std::uint32_t> indices;
    for (Primitive& primitive : mesh.primitives) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::uint32_t i = primitive.firstIndex; i < primitive.firstIndex + primitive.indexCount; i += 3) {
            triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
        }
        shuffle(triangles, random);
        primitive.firstIndex = std::uint32_t(indices.size());
        for (const auto& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
    }
    mesh.indices = std::move(indices);
}

/// The second and later of triangles with the same corners, which would tie in depth, are left out.
void removeTwins(Mesh& mesh) {
    std::vector<std::array<std::array<float, 3>, 3>> known;
    std::vector<std::uint32_t> indices;
    for (Primitive& primitive : mesh.primitives) {
        const auto first = std::uint32_t(indices.size());
        for (std::uint32_t i = primitive.firstIndex; i < primitive.firstIndex + primitive.indexCount; i += 3) {
            std::array<std::array<float, 3>, 3> corners;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const glm::vec3& p = mesh.positions[mesh.indices[i + k]];
                corners[k] = {p.x, p.y, p.z};
            }
            std::ranges::sort(corners);
            if (std::ranges::find(known, corners) != known.end()) continue;
            known.push_back(corners);
            for (std::uint32_t k = 0; k < 3; ++k) indices.push_back(mesh.indices[i + k]);
        }
        primitive.firstIndex = first;
        primitive.indexCount = std::uint32_t(indices.size()) - first;
    }
    mesh.indices = std::move(indices);
}

TEST(MetamorphicScenes, M2TheOrderOfTrianglesPrimitivesAndNodesChangesNoBit) {
    std::size_t shadow = 0, moved = 0;
    for (const Subject& original : subjects()) {
        if (original.tied) continue;
        SCOPED_TRACE(original.name);
        Subject subject = original;
        if (subject.seed != 0) std::ranges::for_each(subject.scene.meshes, removeTwins);
        const FramePixels before = picture(subject);
        shadow += shadowed(subject, before);
        Random random(subject.seed);
        for (Mesh& mesh : subject.scene.meshes) shuffle(mesh, random);
        // Nodes of ours have parents and channels that name them.
        if (subject.seed != 0) shuffle(subject.scene.nodes, random);
        const FramePixels after = picture(subject);
        EXPECT_EQ(maskDifferences(before, after), 0u);
        for (std::size_t i = 0; i < before.seen.triangles.size(); ++i) {
            moved += before.seen.triangles[i] != after.seen.triangles[i];
        }
    }
    EXPECT_GT(shadow, 1000u) << "there must be shadows";
    EXPECT_GT(moved, 10000u) << "triangles must have other numbers";
}

/// Every triangle by itself, its corners on a grid; split: in four, at midpoints that are exact there.
Mesh onGrid(const Mesh& mesh, bool split) {
    const auto snapped = [](const glm::vec3& p) { return glm::round(p * 1024.0f) / 1024.0f + 0.0f; };
    Mesh made;
    for (Primitive primitive : mesh.primitives) {
        if (!ofTriangles(primitive)) continue;
        const auto first = std::uint32_t(made.positions.size());
        for (std::uint32_t i = primitive.firstIndex; i < primitive.firstIndex + primitive.indexCount; i += 3) {
            std::array<glm::vec3, 3> v, middle;
            for (std::size_t k = 0; k < 3; ++k) v[k] = snapped(mesh.positions[mesh.indices[i + k]]);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 exact = 0.5 * (glm::dvec3(v[k]) + glm::dvec3(v[(k + 1) % 3]));
                middle[k] = glm::vec3(exact);
                EXPECT_EQ(glm::dvec3(middle[k]), exact) << "not representable";
            }
            if (split) {
                for (std::size_t k = 0; k < 3; ++k) {
                    made.positions.insert(made.positions.end(), {v[k], middle[k], middle[(k + 2) % 3]});
                }
                made.positions.insert(made.positions.end(), middle.begin(), middle.end());
            } else {
                made.positions.insert(made.positions.end(), v.begin(), v.end());
            }
        }
        primitive.firstIndex = primitive.firstVertex = first;
        primitive.indexCount = primitive.vertexCount = std::uint32_t(made.positions.size()) - first;
        primitive.hasNormals = primitive.hasTangents = primitive.hasColors = false;
        made.primitives.push_back(primitive);
    }
    for (std::uint32_t i = 0; i < made.positions.size(); ++i) made.indices.push_back(i);
    return made;
}

TEST(MetamorphicScenes, M3SplitTrianglesChangeMasksOnlyOnBoundaries) {
    std::size_t shadow = 0, samples = 0, differences = 0;
    for (const Subject& original : subjects()) {
        SCOPED_TRACE(original.name);
        FramePixels pictures[2];
        for (const bool split : {false, true}) {
            SCOPED_TRACE(split ? "split" : "whole");
            Subject subject = original;
            for (Mesh& mesh : subject.scene.meshes) {
                if (mesh.joints.empty() && mesh.morphTargets.empty()) mesh = onGrid(mesh, split);
            }
            for (Material& material : subject.scene.materials) {
                material.baseColorTexture = material.metallicRoughnessTexture = material.normalTexture =
                    material.occlusionTexture = material.emissiveTexture = {};
            }
            // That no error is hard holds the difference to the band.
            EXPECT_EQ(hardErrors(subject, subject.moment(), pictures[split]), 0u);
            shadow += shadowed(subject, pictures[split]);
        }
        if (original.tied) continue;  // there, all of a surface may be on a boundary
        differences += maskDifferences(pictures[0], pictures[1]);
        for (const LightPlanes& light : pictures[0].lights) samples += light.reaches.size();
    }
    EXPECT_GT(shadow, 2000u) << "there must be shadows";
    EXPECT_LE(double(differences), 1e-4 * double(samples));
    RecordProperty("differences", int(differences));
}

/// A smaller copy of a triangle, moved away from the light within its shadow.
std::array<glm::vec3, 3> within(const Corners& t, const PlacedLight& light, double howFar) {
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    std::array<glm::vec3, 3> made;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 inner = middle + 0.5 * (t[k] - middle);
        const glm::dvec3 away = light.light.type == LightType::Directional ? light.direction : inner - light.position;
        made[k] = glm::vec3(inner + howFar * away);
    }
    return made;
}

/// Whether a triangle is large and turned enough to have such a place behind it.
bool hasRoomBehind(const Corners& t, const PlacedLight& light) {
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const glm::dvec3 way = light.light.type == LightType::Directional ? light.direction : t[0] - light.position;
    return glm::length(n) > 0.01 && std::abs(glm::dot(n, way)) > 0.05 * glm::length(n) * glm::length(way);
}

TEST(MetamorphicScenes, M4CastersInsideAShadowChangeNoMask) {
    std::size_t compared = 0, counted = 0, added = 0;
    for (const Subject& original : subjects()) {
        SCOPED_TRACE(original.name);
        const Moment moment = original.moment();
        const std::vector<Corners> casters = castersOf(original, moment);
        How how, unmoved;
        how.counts = true;
        unmoved.endVolumes = false;  // what is added may widen what the light shines on, and move the ends of sides
        const FramePixels before = picture(original, unmoved), countsBefore = picture(original, how);
        for (std::size_t l = 0; l < moment.lights.size(); ++l) {
            SCOPED_TRACE(moment.lights[l].id);
            Random random(original.seed + l);
            Triangles hidden;
            for (int tries = 0; tries < 100 && hidden.size() < 8 && !casters.empty(); ++tries) {
                const Corners& t = casters[random() % casters.size()];
                const double howFar = 0.1 + 0.1 * double(random() % 20);
                if (hasRoomBehind(t, moment.lights[l])) hidden.push_back(within(t, moment.lights[l], howFar));
            }
            if (hidden.empty()) continue;
            added += hidden.size();
            Subject subject = original;
            TestScene maker;
            maker.add(hidden);
            maker.scene.meshes[0].primitives[0].material = kNone;
            maker.scene.nodes[0].mesh = Index(subject.scene.meshes.size());
            subject.scene.meshes.push_back(maker.scene.meshes[0]);
            subject.scene.nodes.push_back(maker.scene.nodes[0]);
            const FramePixels after = picture(subject, unmoved), countsAfter = picture(subject, how);
            std::size_t differences = 0;
            for (std::size_t i = 0; i < before.seen.triangles.size(); ++i) {
                if (before.seen.triangles[i] != after.seen.triangles[i]) continue;
                ++compared;
                differences += before.lights[l].reaches[i] != after.lights[l].reaches[i];
                counted += countsBefore.lights[l].counts[i] < countsAfter.lights[l].counts[i];
            }
            EXPECT_EQ(differences, 0u);
        }
    }
    EXPECT_GT(added, 100u);
    EXPECT_GT(compared, 100000u);
    EXPECT_GT(counted, 1000u) << "the casters must add layers before what is seen";
}

/// Everything with x and -x exchanged.
Moment mirrored(Moment moment) {
    const glm::dmat4 mirror(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                            glm::dvec4(0, 0, 0, 1));
    for (glm::dmat4& m : moment.worldFromNode) m = mirror * m;
    for (Instance& instance : moment.instances) {
        instance.worldFromModel = mirror * instance.worldFromModel;
        for (glm::dmat4& m : instance.worldFromBindPose) m = mirror * m;
    }
    for (PlacedLight& light : moment.lights) {
        light.position.x = -light.position.x;
        light.direction.x = -light.direction.x;
    }
    return moment;
}

TEST(MetamorphicScenes, M5AMirroredSceneHasMirroredMasksButOnBoundaries) {
    std::size_t shadow = 0, samples = 0, differences = 0;
    for (const Subject& subject : subjects()) {
        SCOPED_TRACE(subject.name);
        FramePixels pixels, reflection;
        EXPECT_EQ(hardErrors(subject, subject.moment(), pixels), 0u);
        shadow += shadowed(subject, pixels);
        Subject other = subject;
        glm::dmat4& m = other.camera.worldFromCamera;
        for (int column = 0; column < 4; ++column) m[column].x = -m[column].x;
        m[0] = -m[0];
        EXPECT_EQ(hardErrors(other, mirrored(subject.moment()), reflection), 0u);
        if (subject.tied) continue;  // there, all of a surface may be on a boundary
        const auto width = std::size_t(subject.width);
        for (LightPlanes& light : reflection.lights) {
            for (auto row = light.reaches.begin(); row != light.reaches.end(); row += std::ptrdiff_t(width)) {
                std::reverse(row, row + std::ptrdiff_t(width));
            }
            samples += light.reaches.size();
        }
        differences += maskDifferences(pixels, reflection);
    }
    EXPECT_GT(shadow, 1000u) << "there must be shadows";
    EXPECT_LE(double(differences), 1e-3 * double(samples));
    RecordProperty("differences", int(differences));
}

}  // namespace
}  // namespace umbrage::test
