// SPDX-License-Identifier: Apache-2.0
#version 450 core
#extension GL_GOOGLE_include_directive : require
layout(location = 0) out uint outCovered;

void main() { outCovered = 1u; }
