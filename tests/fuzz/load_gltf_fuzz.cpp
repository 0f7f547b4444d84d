// SPDX-License-Identifier: Apache-2.0
// libFuzzer entry of the glTF loader; not part of the default build. It needs clang and its runtime:
//
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -DGLM_ENABLE_EXPERIMENTAL -Irenderer \
//       tests/fuzz/load_gltf_fuzz.cpp renderer/scene/{gltf_*,load_gltf,moment,track,scene}.cpp \
//       -ltinygltf -lfmt -o load_gltf_fuzz && ./load_gltf_fuzz -max_len=65536 CORPUS
#include <cstdint>
#include <vector>

#include "error.h"
#include "scene/load_gltf.h"
#include "scene/moment.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const umbrage::Scene scene = umbrage::loadGltf({reinterpret_cast<const std::byte*>(data), size}, "fuzz");
        std::vector<umbrage::Index> animations;
        for (std::size_t i = 0; i < scene.animations.size(); ++i) {
            animations.push_back(static_cast<umbrage::Index>(i));
        }
        umbrage::boundsOf(scene, umbrage::evaluate(scene, animations, 0.5));
    } catch (const umbrage::Error&) {
        // What is wrong with the input is said in an Error; anything else that escapes is a finding.
    }
    return 0;
}
