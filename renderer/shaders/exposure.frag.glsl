// SPDX-License-Identifier: Apache-2.0
// Drawn with the back faces of single-sided surfaces against the finished depth buffer: a fragment that passes belongs
// to a caster that light caps must be drawn for, because the depth buffer does not hold it (T1).
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
layout(early_fragment_tests) in;

layout(std430, binding = BIND_CASTERS) buffer Casters { CasterState casters[]; };

layout(location = 5) flat in uvec3 drawn;

void main() { casters[drawn.x].missing = 1u; }
