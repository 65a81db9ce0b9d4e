// SPDX-License-Identifier: MIT
// Stokes vectors moved into the physical range (Eq. 70). One invocation a vector.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer StokesVectors { vec4 stokes[]; };
layout(std430, binding = 1) buffer Moved { uint moved; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    vec4 s = stokes[i];
    float polarized2 = dot(s.yzw, s.yzw);
    if (s.x >= 0.0 && polarized2 <= s.x * s.x) return;
    atomicAdd(moved, 1u);
    s.x = max(s.x, 0.0);
    s.yzw *= polarized2 > 0.0 ? min(s.x / sqrt(polarized2), 1.0) : 1.0;
    stokes[i] = s;
}
