// SPDX-License-Identifier: MIT
// Adds one drawing of an image, times its weight, to the sum of the drawings before, which is also the
// target.
#version 450 core

layout(location = 0) out vec4 pixel[CHANNELS];

layout(binding = 0) uniform sampler2D drawn[CHANNELS];
layout(binding = 4) uniform sampler2D sum[CHANNELS];

uniform float weight;
uniform bool first;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    for (int c = 0; c < CHANNELS; ++c) {
        pixel[c] = weight * texelFetch(drawn[c], at, 0);
        if (!first) pixel[c] += texelFetch(sum[c], at, 0);
    }
}
