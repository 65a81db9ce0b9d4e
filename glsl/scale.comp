// SPDX-License-Identifier: MIT
// Multiplies Stokes vectors by a factor. One invocation per vector.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer StokesVectors { vec4 stokes[]; };

uniform int count;
uniform float factor;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    stokes[i] *= factor;
}
