// SPDX-License-Identifier: Apache-2.0
// Procedural surfaces that repeat: base colour, normal and roughness pictures made from a height and a tint.
#pragma once

#include "png.h"

namespace generator {

struct Surface {
    Picture color;      // sRGB
    Picture normal;     // tangent space, +Y up the picture
    Picture roughness;  // glTF's metallic-roughness: green rough, blue metal (none)
};

Surface pavingStones(int size);  // one repeat: 2 m, four courses
Surface bricks(int size);        // one repeat: 1.6 m, eight courses
Surface planks(int size);        // one repeat: 1 m, four upright boards

}  // namespace generator
