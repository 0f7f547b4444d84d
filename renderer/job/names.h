// SPDX-License-Identifier: Apache-2.0
// Names that the sequence file, the frame and the image writer share; those of AOVs are in aovs.h. A new overlay is one
// line here.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace umbrage {

struct NameAndMeaning {
    std::string_view name, meaning;
};

/// A way of counting, and when it claims to be exact: always, where it does not say otherwise itself (then
/// shadow.whenInexact decides), or never.
enum class Exact { Always, UnlessItSaysSo, Never };
struct CountName {
    std::string_view name, meaning;
    Exact exact;
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"stencil-zero", "shadow counts in green where they are zero and in red where not (Kilgard 2001)"},
    NameAndMeaning{"overdraw", "shadow-volume fragments as a heat map"},
    NameAndMeaning{"updates", "how often counts change at each pixel"},
    NameAndMeaning{"silhouettes", "silhouette edges of each light"},
    NameAndMeaning{"volumes", "the shadow volumes themselves, translucent, with their edges"},
    NameAndMeaning{"split-plane", "where split-plane splits the shadow volumes, as far as they reach"},
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
    CountName{"z-pass", "from the eye, with a constant for the volumes that hold it", Exact::Always},
    CountName{"z-fail", "from infinity, with caps", Exact::Always},
    CountName{"near-cap", "from a plane just before the near plane, with caps there", Exact::Always},
    CountName{"z-pass-plus", "from the near plane, where the light's view of it counts what it cuts", Exact::Never},
    CountName{"split-plane", "of each part of the casters from the eye before a plane, from infinity behind it",
              Exact::Always},
    CountName{"tiles", "from the eye, tile by tile on the processor", Exact::Always},
    CountName{"invert", "from the eye, only whether counts are odd", Exact::UnlessItSaysSo},
    CountName{"z-fail-finite", "from infinity, with volumes that end", Exact::UnlessItSaysSo},
};

/// Whether a count can draw the sides that a silhouette technique finds: one that cuts volumes or
/// counts on the processor needs lists of them, and
/// one that counts by parts of the casters needs sides that know theirs.
constexpr bool canPair(std::string_view silhouette, std::string_view count) {
    if (count == "split-plane") return silhouette == "compute" || silhouette == "cpu";
    const bool lists = silhouette == "compute" || silhouette == "cpu" || silhouette == "vertex-reject-readback";
    return lists || (count != "near-cap" && count != "tiles");
}

/// All pairs, as silhouette:count, the default first.
inline std::vector<std::string> techniqueNames() {
    std::vector<std::string> names;
    for (const NameAndMeaning& silhouette : kSilhouettes) {
        for (const CountName& count : kCounts) {
            if (!canPair(silhouette.name, count.name)) continue;
            names.push_back(std::string(silhouette.name) + ":" + std::string(count.name));
        }
    }
    return names;
}

inline constexpr std::array kWhenInexact = {
    NameAndMeaning{"fall-back", "such lights are counted by z-pass, and a note says so"},
    NameAndMeaning{"refuse", "an error"},
    NameAndMeaning{"allow", "what comes out comes out"},
};

inline constexpr std::array kSkips = {
    NameAndMeaning{"halve", "one quad for two where every count is even"},
    NameAndMeaning{"range", "casters out of a light's range or cone, and what it cannot light"},
    NameAndMeaning{"view", "casters whose volumes no view ray meets, and instances out of view"},
    NameAndMeaning{"extent", "volumes end behind all that the light can shine on"},
    NameAndMeaning{"channels", "animation channels that move nothing that is seen, casts, shines or sees"},
    NameAndMeaning{"frames",
                   "a frame of the run in which nothing changed is not rendered: its files are links to the "
                   "earlier one's, or copies; not where times are measured"},
};

}  // namespace umbrage
