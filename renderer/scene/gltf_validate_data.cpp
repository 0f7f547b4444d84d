// SPDX-License-Identifier: Apache-2.0
// Buffers, buffer views and accessors: nothing may reach beyond bytes that really exist.
#include <fmt/format.h>

#include <algorithm>

#include "scene/gltf_validate_parts.h"

namespace umbrage {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1}
                                     << 53;  // beyond it JSON numbers lose integers; sums stay in 64 bits
constexpr std::uint64_t kMostElements = 0xFFFFFFFF;
constexpr std::uint64_t kMostSparse = 0x7FFFFFFF;  // tinygltf keeps these numbers as int

struct ViewFacts {
    std::uint64_t offset, bytes, stride;
    bool hasData;
};

ViewFacts viewFacts(const Validation& validation, std::size_t view) {
    const JsonView& json = validation.bufferViews[view];
    return {json.integer("byteOffset", 0, kMostBytes), json.at("byteLength").integer(1, kMostBytes),
            json.integer("byteStride", 0, 252),
            validation.facts.buffers[json.at("buffer").value().get<std::size_t>()].has_value()};
}

// `count` elements from `offset` on must lie in the view, and every component at a multiple of its size.
void requireRange(const Validation& validation, const JsonView& place, std::size_t view, std::uint64_t offset,
                  std::uint64_t count, std::uint64_t bytes, std::uint64_t stride, std::uint64_t alignment) {
    const ViewFacts facts = viewFacts(validation, view);
    if (!facts.hasData) {
        place.fail(fmt::format("reads buffer view {}, whose buffer has no data", view),
                   "data that only an unsupported compression extension can restore needs a fallback");
    }
    if ((facts.offset + offset) % alignment != 0 || offset % alignment != 0) {
        place.fail(
            fmt::format("starts at byte {} of its buffer view and {} of its buffer, which is not a multiple of {}",
                        offset, facts.offset + offset, alignment));
    }
    if (offset > facts.bytes || bytes > facts.bytes - offset || count - 1 > (facts.bytes - offset - bytes) / stride) {
        place.fail(
            fmt::format("{} elements of {} bytes, {} bytes apart, from byte {} on do not fit into the {} bytes of "
                        "buffer view {}",
                        count, bytes, stride, offset, facts.bytes, view));
    }
}

ComponentType componentType(const JsonView& json) {
    const JsonView type = json.at("componentType");
    requireEnum(type, {5120, 5121, 5122, 5123, 5125, 5126});
    return static_cast<ComponentType>(type.value().get<int>());
}

void validateSparse(const Validation& validation, const JsonView& sparse, const AccessorFacts& facts) {
    const std::uint64_t count = sparse.at("count").integer(1, std::min(facts.count, kMostSparse));
    const std::size_t viewCount = validation.bufferViews.size();

    const JsonView indices = sparse.at("indices");
    const ComponentType indexType = componentType(indices);
    if (indexType != ComponentType::U8 && indexType != ComponentType::U16 && indexType != ComponentType::U32) {
        indices.at("componentType").fail("sparse indices must be unsigned integers");
    }
    const std::uint64_t indexBytes = componentBytes(indexType);
    requireRange(validation, indices, indices.at("bufferView").index(viewCount, "buffer view"),
                 indices.integer("byteOffset", 0, kMostSparse), count, indexBytes, indexBytes, indexBytes);

    const JsonView values = sparse.at("values");
    const std::uint64_t valueBytes = elementBytes(*facts.type, facts.component);
    requireRange(validation, values, values.at("bufferView").index(viewCount, "buffer view"),
                 values.integer("byteOffset", 0, kMostSparse), count, valueBytes, valueBytes,
                 componentBytes(facts.component));
}

AccessorFacts validateAccessor(const Validation& validation, const JsonView& accessor) {
    AccessorFacts facts;
    const JsonView type = accessor.at("type");
    facts.type = findElementType(type.text());
    if (facts.type == nullptr) {
        type.fail(fmt::format("{} is none of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4", inQuotes(type.text())));
    }
    facts.component = componentType(accessor);
    if (const auto normalized = accessor.find("normalized")) {
        facts.normalized = normalized->flag();
        if (facts.normalized && componentBytes(facts.component) == 4) {
            normalized->fail("only 8-bit and 16-bit integers can be normalised");
        }
    }
    facts.count = accessor.at("count").integer(1, kMostElements);

    const std::uint64_t offset = accessor.integer("byteOffset", 0, kMostBytes);
    const auto view = accessor.index("bufferView", validation.bufferViews.size(), "buffer view");
    const auto sparse = accessor.find("sparse");
    facts.hasData = view.has_value() || sparse.has_value();
    if (view) {
        const std::uint64_t bytes = elementBytes(*facts.type, facts.component);
        const std::uint64_t declaredStride = viewFacts(validation, *view).stride;
        const std::uint64_t stride = declaredStride == 0 ? bytes : declaredStride;
        const std::uint64_t alignment = componentBytes(facts.component);
        if (stride < bytes || stride % alignment != 0) {
            accessor.fail(fmt::format(
                "buffer view {} has a byteStride of {}, but {} needs {} bytes an element, at multiples of {}", *view,
                stride, formatName(*facts.type, facts.component, facts.normalized), bytes, alignment));
        }
        requireRange(validation, accessor, *view, offset, facts.count, bytes, stride, alignment);
    }
    if (sparse) {
        validateSparse(validation, *sparse, facts);
    }
    return facts;
}

// "VEC3 of FLOAT" or "VEC3 of FLOAT, normalised BYTE"
std::string allowedNames(std::string_view type, ComponentFormats formats) {
    std::string names;
    for (const ComponentType component : {ComponentType::Float, ComponentType::I8, ComponentType::U8,
                                          ComponentType::I16, ComponentType::U16, ComponentType::U32}) {
        for (const bool normalized : {false, true}) {
            const bool exists = !normalized || componentBytes(component) < 4;
            if (exists && (formats & formatOf(component, normalized)) != 0) {
                names +=
                    (names.empty() ? "allowed: " : "; ") + formatName(*findElementType(type), component, normalized);
            }
        }
    }
    return names;
}

}  // namespace

std::string formatName(const ElementType& type, ComponentType component, bool normalized) {
    const char* name = "FLOAT";
    switch (component) {
        case ComponentType::I8:
            name = "BYTE";
            break;
        case ComponentType::U8:
            name = "UNSIGNED_BYTE";
            break;
        case ComponentType::I16:
            name = "SHORT";
            break;
        case ComponentType::U16:
            name = "UNSIGNED_SHORT";
            break;
        case ComponentType::U32:
            name = "UNSIGNED_INT";
            break;
        case ComponentType::Float:
            break;
    }
    return fmt::format("{} of {}{}", type.name, normalized ? "normalised " : "", name);
}

void validateBuffers(Validation& validation) {
    const auto buffers = validation.root.objects("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const JsonView& buffer = buffers[i];
        const JsonView length = buffer.at("byteLength");
        const std::uint64_t declared = length.integer(1, kMostBytes);
        std::optional<GltfSource> source;
        if (const auto uri = buffer.find("uri")) {
            source = validation.files.resolve(*uri);
        } else if (i == 0 && validation.document.binary) {
            source.emplace();
            source->origin = *validation.document.binary;
            source->sizeBytes = validation.document.binary->size();
        }
        if (source && source->sizeBytes < declared) {
            length.fail(fmt::format("declares {} bytes, but only {} are there", declared, source->sizeBytes));
        }
        validation.facts.buffers.push_back(std::move(source));
        validation.facts.bufferBytes.push_back(declared);
    }
}

void validateBufferViews(Validation& validation) {
    for (const JsonView& view : validation.bufferViews) {
        const std::size_t buffer = view.at("buffer").index(validation.facts.buffers.size(), "buffer");
        const std::uint64_t offset = view.integer("byteOffset", 0, kMostBytes);
        const std::uint64_t length = view.at("byteLength").integer(1, kMostBytes);
        const std::uint64_t bufferBytes = validation.facts.bufferBytes[buffer];
        if (offset > bufferBytes || length > bufferBytes - offset) {
            view.fail(fmt::format("{} bytes from byte {} on do not fit into the {} bytes of buffer {}", length, offset,
                                  bufferBytes, buffer));
        }
        if (const auto stride = view.find("byteStride")) {
            if (stride->integer(4, 252) % 4 != 0) {
                stride->fail(fmt::format("{} is not a multiple of 4", stride->value().dump()));
            }
        }
        if (const auto target = view.find("target")) {
            requireEnum(*target, {34962, 34963});
        }
    }
}

void validateAccessors(Validation& validation) {
    for (const JsonView& accessor : validation.root.objects("accessors")) {
        validation.accessors.push_back(validateAccessor(validation, accessor));
    }
}

const AccessorFacts& requireAccessor(const Validation& validation, const JsonView& reference, std::string_view type,
                                     ComponentFormats formats) {
    const AccessorFacts& facts = validation.accessors[reference.index(validation.accessors.size(), "accessor")];
    if (facts.type->name != type || (formats & formatOf(facts.component, facts.normalized)) == 0) {
        reference.fail(fmt::format("accessor {} is {}, which is not allowed here", reference.value().dump(),
                                   formatName(*facts.type, facts.component, facts.normalized)),
                       allowedNames(type, formats));
    }
    return facts;
}

}  // namespace umbrage
