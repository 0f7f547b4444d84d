// SPDX-License-Identifier: Apache-2.0
// Animations: each sampler that moves a kept node becomes a track.
#include <fmt/format.h>

#include <algorithm>

#include "scene/gltf_convert.h"

namespace umbrage {
namespace {

Target targetOf(const std::string& path) {
    return path == "translation" ? Target::Translation
           : path == "rotation"  ? Target::Rotation
           : path == "scale"     ? Target::Scale
                                 : Target::Weights;
}

std::vector<float> readTimes(const GltfConversion& conversion, int accessor, const std::string& pointer) {
    auto times = conversion.reader.floats(accessor, pointer);
    if (times.front() < 0.0f) {
        failAt(conversion.file, pointer,
               fmt::format("key 0 is at {} s, but times must not be negative", times.front()));
    }
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i] > times[i - 1])) {
            failAt(conversion.file, pointer,
                   fmt::format("key {} is at {} s and key {} at {} s, but times must increase", i - 1, times[i - 1], i,
                               times[i]));
        }
    }
    return times;
}

void requireRotations(const GltfConversion& conversion, const Track& track, const std::string& pointer) {
    const bool isCubic = track.interpolation == Interpolation::CubicSpline;
    for (std::size_t key = 0; key < track.timesSeconds.size(); ++key) {
        const auto* q = &track.values[isCubic ? key * 12 + 4 : key * 4];
        if (std::all_of(q, q + 4, [](float component) { return component == 0.0f; })) {
            failAt(conversion.file, pointer, fmt::format("key {} is the zero quaternion, which is no rotation", key));
        }
    }
}

Track convertSampler(const GltfConversion& conversion, const tinygltf::AnimationSampler& sampler,
                     const std::string& pointer) {
    Track track;
    track.interpolation = sampler.interpolation == "STEP"          ? Interpolation::Step
                          : sampler.interpolation == "CUBICSPLINE" ? Interpolation::CubicSpline
                                                                   : Interpolation::Linear;
    track.timesSeconds = readTimes(conversion, sampler.input, pointer + "/input");
    track.values = conversion.reader.floats(sampler.output, pointer + "/output");
    const std::size_t valuesPerKey = track.interpolation == Interpolation::CubicSpline ? 3 : 1;
    track.width = static_cast<int>(track.values.size() / track.timesSeconds.size() / valuesPerKey);
    return track;
}

Animation convertAnimation(const GltfConversion& conversion, std::size_t index) {
    const tinygltf::Animation& source = conversion.model.animations[index];
    Animation animation;
    animation.name = source.name;
    std::vector<Index> tracks(source.samplers.size(), kNone);
    for (const tinygltf::AnimationChannel& channel : source.channels) {
        const Index node = conversion.sceneNodes[static_cast<std::size_t>(channel.target_node)];
        if (node == kNone) {
            continue;
        }
        const auto sampler = static_cast<std::size_t>(channel.sampler);
        const std::string pointer = fmt::format("/animations/{}/samplers/{}", index, sampler);
        if (tracks[sampler] == kNone) {
            tracks[sampler] = static_cast<Index>(animation.tracks.size());
            animation.tracks.push_back(convertSampler(conversion, source.samplers[sampler], pointer));
        }
        const Target target = targetOf(channel.target_path);
        if (target == Target::Rotation) {
            requireRotations(conversion, animation.tracks[static_cast<std::size_t>(tracks[sampler])],
                             pointer + "/output");
        }
        animation.channels.push_back({node, target, tracks[sampler]});
    }
    return animation;
}

}  // namespace

void convertAnimations(GltfConversion& conversion) {
    for (std::size_t i = 0; i < conversion.model.animations.size(); ++i) {
        conversion.scene.animations.push_back(convertAnimation(conversion, i));
    }
}

}  // namespace umbrage
