// SPDX-License-Identifier: Apache-2.0
// Meshes: which attributes there may be, how they may be stored (glTF 2.0, 3.7.2.1 and KHR_mesh_quantization), and
// that their counts agree.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "scene/gltf_validate_parts.h"

namespace umbrage {
namespace {

struct AttributeRule {
    std::string_view semantic;  // without its set number
    bool hasSets;
    std::initializer_list<std::string_view> types;
    ComponentFormats formats, quantizedFormats;
};

constexpr ComponentFormats kSmallNorm = kI8Norm | kI16Norm, kUnsignedNorm = kU8Norm | kU16Norm;
constexpr ComponentFormats kEverySmall = kI8 | kI8Norm | kU8 | kU8Norm | kI16 | kI16Norm | kU16 | kU16Norm;
constexpr ComponentFormats kSigned = kI8 | kI8Norm | kI16 | kI16Norm;

const AttributeRule kAttributes[] = {
    {"POSITION", false, {"VEC3"}, kFloat, kEverySmall},
    {"NORMAL", false, {"VEC3"}, kFloat, kSmallNorm},
    {"TANGENT", false, {"VEC4"}, kFloat, kSmallNorm},
    {"TEXCOORD", true, {"VEC2"}, kFloat | kUnsignedNorm, kEverySmall},
    {"COLOR", true, {"VEC3", "VEC4"}, kFloat | kUnsignedNorm, 0},
    {"JOINTS", true, {"VEC4"}, kU8 | kU16, 0},
    {"WEIGHTS", true, {"VEC4"}, kFloat | kUnsignedNorm, 0},
};

const AttributeRule kTargetAttributes[] = {
    {"POSITION", false, {"VEC3"}, kFloat, kSigned},
    {"NORMAL", false, {"VEC3"}, kFloat, kSmallNorm},
    {"TANGENT", false, {"VEC3"}, kFloat, kSmallNorm},
    {"TEXCOORD", true, {"VEC2"}, kFloat | kUnsignedNorm | kSmallNorm, kEverySmall},
    {"COLOR", true, {"VEC3", "VEC4"}, kFloat | kUnsignedNorm | kSmallNorm, 0},
};

const AttributeRule* findRule(std::span<const AttributeRule> rules, std::string_view name) {
    for (const AttributeRule& rule : rules) {
        if (rule.hasSets ? name.substr(0, name.rfind('_')) == rule.semantic : name == rule.semantic) {
            return &rule;
        }
    }
    return nullptr;
}

// Data that only an unsupported compression can restore looks like an accessor without data.
void requireFallback(const Validation& validation, const JsonView& primitive, const JsonView& reference) {
    if (primitive.extension("KHR_draco_mesh_compression") &&
        !validation.accessors[reference.value().get<std::size_t>()].hasData) {
        reference.fail(
            "its data are only there in compressed form, by the unsupported extension KHR_draco_mesh_compression",
            "export without Draco compression");
    }
}

void validateAttribute(const Validation& validation, std::span<const AttributeRule> rules, const std::string& name,
                       const JsonView& reference, std::uint64_t vertexCount) {
    const std::size_t accessor = reference.index(validation.accessors.size(), "accessor");
    const AttributeRule* rule = findRule(rules, name);
    if (rule == nullptr) {
        if (!name.starts_with('_')) {
            validation.notes.add(reference.pointer(),
                                 fmt::format("the attribute {} is unknown and ignored", inQuotes(name)));
        }
        return;
    }
    const std::string_view type = validation.accessors[accessor].type->name;
    const bool typeFits = std::find(rule->types.begin(), rule->types.end(), type) != rule->types.end();
    const bool quantized = validation.uses("KHR_mesh_quantization");
    const AccessorFacts& facts =
        requireAccessor(validation, reference, typeFits ? type : *rule->types.begin(),
                        static_cast<ComponentFormats>(rule->formats | (quantized ? rule->quantizedFormats : 0)));
    if (facts.count != vertexCount) {
        reference.fail(fmt::format("has {} elements, but POSITION has {}", facts.count, vertexCount));
    }
}

// JOINTS_0 ... JOINTS_n and WEIGHTS_0 ... WEIGHTS_n come in pairs.
std::size_t validateInfluences(const JsonView& attributes) {
    std::size_t sets = 0;
    for (;; ++sets) {
        const auto joints = attributes.find(fmt::format("JOINTS_{}", sets));
        const auto weights = attributes.find(fmt::format("WEIGHTS_{}", sets));
        if (joints.has_value() != weights.has_value()) {
            attributes.fail(fmt::format("has only one of JOINTS_{0} and WEIGHTS_{0}", sets));
        }
        if (!joints) {
            return sets;
        }
    }
}

std::size_t validateTargets(const Validation& validation, const JsonView& primitive, std::uint64_t vertexCount) {
    const auto targets = primitive.objects("targets");
    for (const JsonView& target : targets) {
        for (const auto& [name, reference] : target.members()) {
            validateAttribute(validation, kTargetAttributes, name, reference, vertexCount);
        }
    }
    return targets.size();
}

struct PrimitiveFacts {
    std::size_t targetCount = 0;
    bool hasJoints = false;
};

PrimitiveFacts validatePrimitive(const Validation& validation, const JsonView& primitive) {
    primitive.integer("mode", 4, 6);
    primitive.index("material", validation.materialCount, "material");
    const JsonView attributes = primitive.at("attributes");
    std::uint64_t vertexCount = 0;
    if (const auto position = attributes.find("POSITION")) {
        vertexCount = validation.accessors[position->index(validation.accessors.size(), "accessor")].count;
        for (const auto& [name, reference] : attributes.members()) {
            validateAttribute(validation, kAttributes, name, reference, vertexCount);
            requireFallback(validation, primitive, reference);
        }
    } else {
        validation.notes.add(primitive.pointer(), "has no POSITION, so it is not drawn");
        for (const auto& [name, reference] : attributes.members()) {
            reference.index(validation.accessors.size(), "accessor");
        }
    }
    if (const auto indices = primitive.find("indices")) {
        requireAccessor(validation, *indices, "SCALAR", kU8 | kU16 | kU32);
        requireFallback(validation, primitive, *indices);
    }
    PrimitiveFacts facts;
    facts.hasJoints = validateInfluences(attributes) > 0;
    facts.targetCount = validateTargets(validation, primitive, vertexCount);
    return facts;
}

}  // namespace

void validateMeshes(Validation& validation) {
    for (const JsonView& mesh : validation.root.objects("meshes")) {
        mesh.at("primitives");
        const auto primitives = mesh.objects("primitives");
        PrimitiveFacts common;
        common.hasJoints = !primitives.empty();
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const PrimitiveFacts facts = validatePrimitive(validation, primitives[i]);
            if (i > 0 && facts.targetCount != common.targetCount) {
                primitives[i].fail(fmt::format("has {} morph targets, but the mesh's first primitive has {}",
                                               facts.targetCount, common.targetCount));
            }
            common.targetCount = facts.targetCount;
            common.hasJoints = common.hasJoints && facts.hasJoints;
        }
        if (const auto weights = mesh.find("weights")) {
            weights->numbers(common.targetCount);
        }
        validation.meshTargetCounts.push_back(common.targetCount);
        validation.meshHasJoints.push_back(common.hasJoints);
    }
}

}  // namespace umbrage
