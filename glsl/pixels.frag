// SPDX-License-Identifier: MIT
// Pixels that were shaded elsewhere, before nothing.
#version 450 core

layout(location = 0) out vec4 pixel[CHANNELS];

layout(binding = 4) uniform sampler2D shaded[CHANNELS];

void main() {
    for (int c = 0; c < CHANNELS; ++c) pixel[c] = texelFetch(shaded[c], ivec2(gl_FragCoord.xy), 0);
}
