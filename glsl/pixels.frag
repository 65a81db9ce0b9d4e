// SPDX-License-Identifier: MIT
// Pixels that were shaded elsewhere, in front of the background.
#version 450 core

layout(location = 0) out vec4 pixel[CHANNELS];

layout(binding = 0) uniform sampler2D hits;
layout(binding = 1) uniform sampler2D stokes[CHANNELS];

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (texelFetch(hits, at, 0).y == 0.0) discard;
    for (int c = 0; c < CHANNELS; ++c) pixel[c] = texelFetch(stokes[c], at, 0);
    gl_FragDepth = 0.0;
}
