// SPDX-License-Identifier: Apache-2.0
// The depth of what is seen, as a texture: no depth buffer is attached then, or it is a copy.
#ifndef SAMPLES
#define SAMPLES 1
#endif
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS depthTexture;
#else
layout(binding = 0) uniform sampler2D depthTexture;
#endif
