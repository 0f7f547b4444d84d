// SPDX-License-Identifier: Apache-2.0
// The one table of AOVs: what a sequence may ask for, what files hold, what docs/aovs.md says (umbrage schema --aovs).
//
// A new AOV that follows from the G-buffer is one entry here and its formula in shaders/data.frag.glsl, under
// AOV_ and its name in capitals.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbrage {

/// What EXR files hold.
enum class AovFormat : std::uint8_t {
    Colour,  // half, or float where output.exrHalf is off
    Half,
    Float,
    UInt,
};

enum class AovSampling : std::uint8_t {
    Mean,   // of all samples of a pixel
    First,  // of one sample: an average of data is no data
};

/// Who makes it.
enum class AovSource : std::uint8_t {
    GBuffer,  // data.frag.glsl, for each light where it has channels for each
    Own,      // a pass of its own
};

struct AovInfo {
    std::string_view name;
    std::string_view channels;  // separated by spaces; * is a light's id: there are as many for each light
    AovFormat format;
    AovSampling sampling;
    AovSource source;
    std::string_view meaning, background;
    bool isPicture = false;  // may be a PNG; data would be cut to [0, 1] there

    constexpr bool perLight() const { return channels.find('*') != std::string_view::npos; }
    /// Of each light, where it has channels for each.
    constexpr int channelCount() const { return 1 + int(std::count(channels.begin(), channels.end(), ' ')); }
};

// clang-format off
inline constexpr std::array kAovs = {
    AovInfo{"beauty", "R G B", AovFormat::Colour, AovSampling::Mean, AovSource::Own,
            "the picture", "image.background", true},
    AovInfo{"depth", "Z", AovFormat::Float, AovSampling::First, AovSource::Own,
            "distance along the viewing direction, metres", "infinite"},
    AovInfo{"normal", "N.X N.Y N.Z", AovFormat::Colour, AovSampling::First, AovSource::Own,
            "shading normal, world", "0"},
    AovInfo{"geometricNormal", "Ng.X Ng.Y Ng.Z", AovFormat::Colour, AovSampling::First, AovSource::GBuffer,
            "normal of the seen triangle, turned to the viewer, world; of lines and points the shading normal", "0"},
    AovInfo{"position", "P.X P.Y P.Z", AovFormat::Float, AovSampling::First, AovSource::GBuffer,
            "place of the surface point, world, metres", "0"},
    AovInfo{"albedo", "albedo.R albedo.G albedo.B", AovFormat::Colour, AovSampling::First, AovSource::GBuffer,
            "base colour, linear Rec.709; of unlit surfaces the colour they show", "0"},
    AovInfo{"surface", "surface.roughness surface.metallic", AovFormat::Half, AovSampling::First, AovSource::GBuffer,
            "roughness and metallic; 0 on unlit surfaces", "0"},
    AovInfo{"light", "light.*.R light.*.G light.*.B", AovFormat::Colour, AovSampling::Mean, AovSource::GBuffer,
            "radiance by one light alone; all of them, ambient and emissive add up to beauty without what is blended", "0"},
    AovInfo{"ambient", "ambient.R ambient.G ambient.B", AovFormat::Colour, AovSampling::Mean, AovSource::GBuffer,
            "radiance by ambient light", "0"},
    AovInfo{"emissive", "emissive.R emissive.G emissive.B", AovFormat::Colour, AovSampling::Mean, AovSource::GBuffer,
            "radiance that surfaces emit, unlit ones their colour", "image.background"},
    AovInfo{"ids", "objectId materialId primitiveId", AovFormat::UInt, AovSampling::First, AovSource::Own,
            "numbers from 1 on of the object and its material (metadata umbrage:objects and umbrage:materials name them), "
            "and of the triangle in its mesh, or the line or point in its primitive", "0"},
    AovInfo{"motion", "motion.X motion.Y", AovFormat::Float, AovSampling::First, AovSource::Own,
            "way of the surface point over the picture since the frame before by the clock, rendered or not: pixels to "
            "the right and down; 0 where it was behind the eye", "0"},
    AovInfo{"shadow", "shadow.*", AovFormat::Half, AovSampling::Mean, AovSource::Own,
            "1 where the light reaches the surface", "0"},
    AovInfo{"stencil", "stencil.*", AovFormat::UInt, AovSampling::First, AovSource::Own,
            "the shadow count: volumes of the light's that hold the surface point", "counted at infinity"},
    AovInfo{"silhouette", "silhouette.*", AovFormat::Half, AovSampling::First, AovSource::Own,
            "1 where a silhouette edge of the light's is seen, as a line of one pixel", "as elsewhere"},
    AovInfo{"contour", "contour", AovFormat::Half, AovSampling::First, AovSource::Own,
            "1 where a contour of what casts is seen, as a line of one pixel: an edge whose triangles the viewer sees from "
            "different sides, or that has only one", "as elsewhere"},
    AovInfo{"cost", "cost.*", AovFormat::Float, AovSampling::Mean, AovSource::Own,
            "fragments of the light's shadow volumes, before the depth test", "as elsewhere"},
    AovInfo{"overdraw", "overdraw.fragments overdraw.updates", AovFormat::Float, AovSampling::Mean, AovSource::Own,
            "fragments of all shadow volumes, before the depth test, and those that change a count", "as elsewhere"},
    AovInfo{"scene", "scene.fragments scene.shaded", AovFormat::Float, AovSampling::Mean, AovSource::Own,
            "fragments of opaque surfaces, before the depth test, and those that pass it in the order they are drawn", "0"},
};
// clang-format on

/// The channels of a file, in its order.
std::vector<std::string> channelNames(const AovInfo& aov, const std::vector<std::string>& lightIds);

/// The reference page of the AOVs (Markdown).
std::string aovReference();

}  // namespace umbrage
