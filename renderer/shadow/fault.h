// SPDX-License-Identifier: Apache-2.0
// Mistakes that can be planted into the shadow path: those that textbooks and engines make, and some of our own, to
// show that the judge catches them. `umbrage verify --fault NAME`; never set otherwise.
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

enum class Fault {
    None,
    NoEyeConstant,    // z-pass as first published: wrong with the eye in a volume
    FacingTwice,      // each edge decides anew which way its triangles face, in its own vertex order
    WorldFloats,      // positions in the world and in float, however far from its origin
    WrongFacing,      // one triangle in 64 faces the wrong way
    MissingEdge,      // one silhouette edge in 64 is lost
    ShiftedLight,     // the light casts from 1/1000 of its distance aside
    OriginExtrusion,  // Surdulescu 2003: far corners in a direction that depends on where the origin is
};

struct NamedFault {
    Fault fault;
    std::string_view name, doc;
};

inline constexpr std::array kFaults = {
    NamedFault{Fault::NoEyeConstant, "no-eye-constant",
               "textbook z-pass: nothing is added where the eye is in a volume"},
    NamedFault{Fault::FacingTwice, "facing-twice", "every edge decides anew which way its triangles face"},
    NamedFault{Fault::WorldFloats, "world-floats", "positions in the world, in float, not relative to the eye"},
    NamedFault{Fault::WrongFacing, "wrong-facing", "one triangle in 64 faces the wrong way"},
    NamedFault{Fault::MissingEdge, "missing-edge", "one silhouette edge in 64 is lost"},
    NamedFault{Fault::ShiftedLight, "shifted-light", "shadows are cast from 1/1000 of the light's distance aside"},
    NamedFault{Fault::OriginExtrusion, "origin-extrusion",
               "degenerate-quad as first published: sides run in a direction that depends on where the origin is"},
};

}  // namespace umbrage
