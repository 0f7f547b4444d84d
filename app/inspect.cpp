// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "exit_codes.h"
#include "scene/load_gltf.h"
#include "scene/t_junctions.h"
#include "scene/topology.h"

namespace umbrage {
namespace {

const char* typeName(LightType type) {
    switch (type) {
        case LightType::Point:
            return "point";
        case LightType::Spot:
            return "spot";
        default:
            return "directional";
    }
}

void printNodes(const Scene& scene) {
    fmt::print("nodes: {}\n", scene.nodes.size());
    for (const Node& node : scene.nodes) {
        std::string what;
        if (node.mesh != kNone) what += fmt::format("  mesh {}", scene.meshes[std::size_t(node.mesh)].name);
        if (node.skin != kNone)
            what += fmt::format("  skin of {} joints", scene.skins[std::size_t(node.skin)].joints.size());
        if (node.camera != kNone) {
            what +=
                scene.cameras[std::size_t(node.camera)].perspective ? "  perspective camera" : "  orthographic camera";
        }
        if (node.light != kNone) {
            const Light& light = scene.lights[std::size_t(node.light)];
            what += fmt::format("  {} light {:g} {}", typeName(light.type), light.intensity,
                                light.type == LightType::Directional ? "lx" : "cd");
            if (light.rangeMetres > 0.0f) what += fmt::format(", range {:g} m", light.rangeMetres);
        }
        fmt::print("  {}{}\n", node.path, what);
    }
}

/// @param topologies  one a mesh
void printMeshes(const Scene& scene, const std::vector<MeshTopology>& topologies) {
    fmt::print("meshes: {}\n", scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        const MeshTopology& topology = topologies[m];
        const MeshTopology::Figures& f = topology.figures;
        fmt::print("  {}: {} triangles, {} vertices ({} welded), {} edges; {} of {} components closed", mesh.name,
                   mesh.triangleCount(), mesh.positions.size(), f.weldedVertices, f.edges, f.closedComponents,
                   f.components);
        if (f.openEdges) fmt::print(", {} open edges", f.openEdges);
        if (const std::size_t junctions = countTJunctions(mesh, topology)) fmt::print(", {} T-junctions", junctions);
        if (f.nonManifoldEdges) fmt::print(", {} edges of more than two triangles", f.nonManifoldEdges);
        if (f.inconsistentEdges) fmt::print(", {} edges of inconsistent winding", f.inconsistentEdges);
        if (f.degenerateTriangles) fmt::print(", {} triangles without area", f.degenerateTriangles);
        if (!mesh.morphTargets.empty()) fmt::print(", {} morph targets", mesh.morphTargets.size());
        fmt::print("\n");
    }
}

/// What makes frames of this scene dear, most of it per placed triangle.
/// @param topologies  one a mesh
void printCosts(const Scene& scene, const std::vector<MeshTopology>& topologies) {
    std::size_t casting = 0, whole = 0, holed = 0, blended = 0, deforming = 0, culled = 0;
    for (const Node& node : scene.nodes) {
        if (node.mesh == kNone) continue;
        const Mesh& mesh = scene.meshes[std::size_t(node.mesh)];
        const MeshTopology& topology = topologies[std::size_t(node.mesh)];
        for (std::size_t t = 0; t < topology.casts.size(); ++t) {
            casting += topology.casts[t];
            whole += topology.casts[t] && !topology.even[t];
        }
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.material == kNone) continue;
            const Material& material = scene.materials[std::size_t(primitive.material)];
            const std::size_t triangles = primitive.indexCount / 3;
            holed += material.alphaMode == AlphaMode::Mask ? triangles : 0;
            blended += material.alphaMode == AlphaMode::Blend ? triangles : 0;
            culled += material.alphaMode == AlphaMode::Opaque && !material.doubleSided ? triangles : 0;
        }
        if (node.skin != kNone || !mesh.morphTargets.empty()) deforming += mesh.positions.size();
    }
    fmt::print("what will cost, for each light:\n  {} triangles are faced and their edges searched\n", casting);
    const auto print = [](std::size_t count, const char* what) {
        if (count) fmt::print("  {} {}\n", count, what);
    };
    print(whole, "of them are in components with edges of odd valence: twice the fill of closed ones");
    print(culled, "are single-sided: light caps are drawn while the viewer sees them from behind");
    print(holed, "are alpha-masked: light caps are always drawn, and they cast as if opaque");
    print(blended, "are blended: sorted and drawn once more; they cast no shadow and are lit without any");
    print(deforming, "vertices are skinned or morphed every frame");
}

}  // namespace

int runInspect(const InspectOptions& options) {
    GltfOptions gltf;
    gltf.allowExternalFiles = options.allowExternalFiles;
    const Scene scene = loadGltf(options.scene, gltf);
    std::size_t placed = 0, lights = 0, cameras = 0;
    for (const Node& node : scene.nodes) {
        if (node.mesh != kNone) placed += scene.meshes[std::size_t(node.mesh)].triangleCount();
        lights += node.light != kNone;
        cameras += node.camera != kNone;
    }
    fmt::print("{}: {} triangles placed, {} lights, {} cameras, {} animations, {} materials, {} images\n",
               options.scene, placed, lights, cameras, scene.animations.size(), scene.materials.size(),
               scene.images.size());
    printNodes(scene);
    std::vector<MeshTopology> topologies;
    for (const Mesh& mesh : scene.meshes) topologies.push_back(buildTopology(mesh, scene.materials));
    printMeshes(scene, topologies);
    printCosts(scene, topologies);
    fmt::print("animations: {}\n", scene.animations.size());
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        const Animation& animation = scene.animations[i];
        fmt::print("  {} {}: {:g} s, {} channels\n", i, animation.name, animation.durationSeconds(),
                   animation.channels.size());
    }
    fmt::print("extensions used: {}\n", fmt::join(scene.extensionsUsed, " "));
    if (!scene.extensionsIgnored.empty())
        fmt::print("extensions ignored: {}\n", fmt::join(scene.extensionsIgnored, " "));
    for (const std::string& note : scene.notes) fmt::print("note: {}\n", note);
    return kOk;
}

}  // namespace umbrage
