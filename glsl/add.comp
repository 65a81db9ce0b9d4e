// SPDX-License-Identifier: MIT
// Adds Stokes vectors to others. One invocation per vector.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer More { vec4 more[]; };
layout(std430, binding = 1) buffer StokesVectors { vec4 stokes[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    stokes[i] += more[i];
}
