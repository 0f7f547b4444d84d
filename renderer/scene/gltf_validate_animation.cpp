// SPDX-License-Identifier: Apache-2.0
// Animations. Channels that only an unsupported extension explains are passed over here and removed before the
// conversion; channels without a target node mean nothing by themselves (glTF 2.0, 3.11) and are treated the same way.
#include <fmt/format.h>

#include <set>

#include "scene/gltf_validate_parts.h"

namespace umbrage {
namespace {

constexpr ComponentFormats kRotationFormats = kFloat | kI8Norm | kU8Norm | kI16Norm | kU16Norm;

struct SamplerFacts {
    std::uint64_t keyCount = 0;
    std::uint64_t valuesPerKey = 1;  // 3 for CUBICSPLINE: in-tangent, value, out-tangent
};

SamplerFacts validateSampler(const Validation& validation, const JsonView& sampler) {
    SamplerFacts facts;
    facts.keyCount = requireAccessor(validation, sampler.at("input"), "SCALAR", kFloat).count;
    sampler.at("output").index(validation.accessors.size(), "accessor");
    if (const auto interpolation = sampler.find("interpolation")) {
        requireEnum(*interpolation, {"STEP", "LINEAR", "CUBICSPLINE"});
        facts.valuesPerKey = interpolation->text() == "CUBICSPLINE" ? 3 : 1;
    }
    return facts;
}

// How many output elements make one value of this path.
std::uint64_t elementsPerValue(const Validation& validation, const JsonView& node, const JsonView& path) {
    if (path.text() != "weights") {
        if (const auto matrix = node.find("matrix")) {
            path.fail(fmt::format("{} has a matrix, so its {} cannot be animated", node.pointer(), path.text()));
        }
        return 1;
    }
    const auto mesh = node.index("mesh", validation.meshTargetCounts.size(), "mesh");
    const std::uint64_t targetCount = mesh ? validation.meshTargetCounts[*mesh] : 0;
    if (targetCount == 0) {
        path.fail(fmt::format("{} has no mesh with morph targets", node.pointer()));
    }
    return targetCount;
}

void validateOutput(const Validation& validation, const JsonView& output, const std::string& path,
                    std::uint64_t expectedCount) {
    const bool isWeights = path == "weights", isRotation = path == "rotation";
    const AccessorFacts& facts = requireAccessor(validation, output,
                                                 isWeights    ? "SCALAR"
                                                 : isRotation ? "VEC4"
                                                              : "VEC3",
                                                 isWeights || isRotation ? kRotationFormats : kFloat);
    if (facts.count != expectedCount) {
        output.fail(
            fmt::format("has {} elements, but the {} of this sampler needs {}", facts.count, path, expectedCount));
    }
}

void validateAnimation(const Validation& validation, const JsonView& animation, const std::vector<JsonView>& nodes) {
    animation.at("samplers");
    animation.at("channels");
    const auto samplers = animation.objects("samplers");
    std::vector<SamplerFacts> facts;
    for (const JsonView& sampler : samplers) {
        facts.push_back(validateSampler(validation, sampler));
    }
    std::set<std::pair<std::size_t, std::string>> targets;
    for (const JsonView& channel : animation.objects("channels")) {
        const std::size_t sampler = channel.at("sampler").index(samplers.size(), "sampler");
        const JsonView target = channel.at("target");
        const JsonView path = target.at("path");
        const auto node = target.index("node", nodes.size(), "node");
        if (path.text() == "pointer" && validation.uses("KHR_animation_pointer")) {
            continue;
        }
        requireEnum(path, {"translation", "rotation", "scale", "weights"});
        if (!node) {
            continue;
        }
        if (!targets.emplace(*node, path.text()).second) {
            target.fail(fmt::format("the {} of node {} is already animated by another channel", path.text(), *node));
        }
        validateOutput(
            validation, samplers[sampler].at("output"), path.text(),
            facts[sampler].keyCount * facts[sampler].valuesPerKey * elementsPerValue(validation, nodes[*node], path));
    }
}

}  // namespace

void validateAnimations(const Validation& validation) {
    const auto nodes = validation.root.objects("nodes");
    for (const JsonView& animation : validation.root.objects("animations")) {
        validateAnimation(validation, animation, nodes);
    }
}

}  // namespace umbrage
