// SPDX-License-Identifier: MIT
// Moves Stokes vectors into the physically realizable range (Eq. 70). One invocation per vector and
// channel.
#version 450 core

#include "physical.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer StokesVectors { vec4 stokes[]; };  // [channel][vector]
layout(std430, binding = 1) buffer Moved { uint moved; };

uniform int count;
uniform int channel_step;  // number of vectors from a channel to the next
uniform float noise;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    i += int(gl_GlobalInvocationID.z) * channel_step;
    if (!is_physical(stokes[i])) {
        atomicAdd(moved, 1u);
    } else if (noise == 0.0) {
        return;
    }
    stokes[i] = made_physical(stokes[i], noise);
}
