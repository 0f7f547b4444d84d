// SPDX-License-Identifier: Apache-2.0
// Stress cases: small scenes that break shadow algorithms, each from its exact construction, with the right answer.
// `generate_scenes --stress ROOT` writes ROOT/scenes/stress/<id>.glb and ROOT/configs/stress/<id>.yaml of each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "document.h"

namespace generator::stress {

struct Case {
    std::string id;       // "A1", or "A3-2": a variant
    std::string what;     // the construction, in a sentence
    std::string answer;   // what is right
    std::string catches;  // the mistakes it finds
    std::function<void(Document&)> fill;
    std::string sequence;  // the sequence file below its scene: camera, lights, time, image, as YAML
};

// One file a family. Degenerate steps of swept cases (frames 1-1001) are frame 501, which every 25th step meets.
std::vector<Case> lightCases();       // A: where the light is
std::vector<Case> eyeCases();         // B1-B6: where the eye is
std::vector<Case> projectionCases();  // B7-B12: how it sees
std::vector<Case> topologyCases();    // C1-C5: which triangles meet
std::vector<Case> storageCases();     // C6-C13: how they are stored
std::vector<Case> magnitudeCases();   // D: how large, how far
std::vector<Case> countCases();       // E: how many
std::vector<Case> lightShapeCases();  // F: ranges, cones, materials
std::vector<Case> rasterCases();      // G: thin things, sample positions, tiles

/// All of them in that order.
std::vector<Case> cases();

}  // namespace generator::stress
