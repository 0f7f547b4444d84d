// SPDX-License-Identifier: Apache-2.0
// Where vertices and edges lie in the textures of Brabec & Seidel 2003.
ivec2 texelOf(uint index) { return ivec2(index % TEXEL_ROW, index / TEXEL_ROW); }
