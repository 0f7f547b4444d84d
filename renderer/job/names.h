// SPDX-License-Identifier: Apache-2.0
// Names that the sequence file, the frame and the image writer share; those of AOVs are in aovs.h. A new overlay is one
// line here.
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

struct NameAndMeaning {
    std::string_view name, meaning;
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"overdraw", "shadow-volume fragments as a heat map"},
    NameAndMeaning{"silhouettes", "silhouette edges of each light"},
    NameAndMeaning{"volumes", "the shadow volumes themselves, translucent, with their edges"},
    NameAndMeaning{"extraction", "silhouette edges of the first light in yellow, the volumes of all lights in red"},
    NameAndMeaning{"toon", "the picture in flat tones with contours drawn in ink"},
    NameAndMeaning{"casters", "whose volumes fill most at each pixel"},
    NameAndMeaning{"tiles", "tiles of 8 x 8 pixels that volumes touch, and in which counts change"},
    NameAndMeaning{"techniques", "the heat maps of two techniques side by side"},
};

inline constexpr std::array kProcedures = {
    NameAndMeaning{"noise", "gradient noise of position and time, along the normals"},
    NameAndMeaning{"wave", "a sine wave that runs along the axis, along the normals"},
    NameAndMeaning{"twist", "turns about the axis, in proportion to the place along it, to and fro in time"},
};

// Techniques, the default first.
inline constexpr std::array kSilhouettes = {
    NameAndMeaning{"compute", "on the device, listed by compute shaders"},
    NameAndMeaning{"vertex-reject", "edges flagged in a texture, all drawn and rejected in the vertex stage"},
    NameAndMeaning{"vertex-reject-readback", "the same flags read back and listed on the host"},
    NameAndMeaning{"degenerate-quad", "quads of no width that the vertex stage opens"},
    NameAndMeaning{"geometry-shader", "triangles with adjacency"},
    NameAndMeaning{"cpu", "on the host"},
};

inline constexpr std::array kCounts = {
    NameAndMeaning{"z-pass", "from the eye, with a constant for the volumes that hold it"},
    NameAndMeaning{"z-fail", "from infinity, with caps"},
};

inline constexpr std::array kSkips = {
    NameAndMeaning{"halve", "one quad for two where every count is even"},
    NameAndMeaning{"range", "casters out of a light's range"},
    NameAndMeaning{"view", "casters whose volumes no view ray meets"},
    NameAndMeaning{"extent", "sides of volumes end behind all that the light can shine on"},
};

}  // namespace umbrage
