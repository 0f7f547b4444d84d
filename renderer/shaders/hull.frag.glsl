// SPDX-License-Identifier: Apache-2.0
// A shadow volume's faces or borders in one colour, to be added up for pictures.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"

layout(location = HULL_COLOR) uniform vec4 color;
layout(location = 0) out vec4 outColor;

void main() { outColor = color; }
