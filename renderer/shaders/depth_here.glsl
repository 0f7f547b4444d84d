// SPDX-License-Identifier: Apache-2.0
// The depth of what is seen at a fragment's sample.
#include "depth_texture.glsl"

#if SAMPLES > 1
float depthHere() { return texelFetch(depthTexture, ivec2(gl_FragCoord.xy), gl_SampleID).r; }
#else
float depthHere() { return texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r; }
#endif
