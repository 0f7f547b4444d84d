// SPDX-License-Identifier: Apache-2.0
// The smallest scene: a triangle without camera and light; if wanted, with an animation of 0.5 s and one of 3 s.
#pragma once

#include <string>

namespace umbrage::cli {

inline std::string triangleGltf(bool animated) {
    // Three positions; the times 0 and 0.5; 0 and 3; two translations.
    const std::string bytes =
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAD8A"
        "AAAAAABAQAAAAAAAAAAAAAAAAAAAAAAAAAAAAACAPw==";
    const std::string animations = R"(,
  "animations": [
    {"name": "short", "samplers": [{"input": 1, "output": 3}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]},
    {"name": "long", "samplers": [{"input": 2, "output": 3}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}])";
    return R"({
  "asset": {"version": "2.0"},
  "scene": 0,
  "scenes": [{"nodes": [0]}],
  "nodes": [{"name": "Triangle", "mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "buffers": [{"byteLength": 76, "uri": "data:application/octet-stream;base64,)" +
           bytes + R"("}],
  "bufferViews": [{"buffer": 0, "byteLength": 76}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [0.5]},
    {"bufferView": 0, "byteOffset": 44, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [3]},
    {"bufferView": 0, "byteOffset": 52, "componentType": 5126, "count": 2, "type": "VEC3"}])" +
           (animated ? animations : "") + "\n}\n";
}

}  // namespace umbrage::cli
