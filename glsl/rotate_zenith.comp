// SPDX-License-Identifier: MIT
// relight, second pass: (-i)^m D of each field, packed; one invocation a vertex and packed entry.
#version 450 core

#include "rotation.glsl"

layout(std430, binding = 1) readonly buffer Entries { ivec4 entries[]; };  // 0: s0, 1: s1 + i s2, 2: s3; l, m
layout(std430, binding = 2) readonly buffer Fields { vec2 fields[]; };     // [field][l l + l + k][vertex]
layout(std430, binding = 3) writeonly buffer Light { float light[]; };     // [real, imaginary][entry][vertex]

vec2 rotated(int field, int l, int m, int v) {
    int first = field * (order + 1) * (order + 1) + l * l + l;
    vec2 sum = vec2(0.0);
    for (int k = -l; k <= l; ++k) sum += quarter(l, m, k) * fields[(first + k) * stride + v];
    switch (m & 3) {  // (-i)^m
        case 0:
            return sum;
        case 1:
            return vec2(sum.y, -sum.x);
        case 2:
            return -sum;
        default:
            return vec2(-sum.y, sum.x);
    }
}

void main() {
    int v = int(gl_GlobalInvocationID.x);
    if (v >= count) return;
    int j = int(gl_GlobalInvocationID.y);
    ivec4 entry = entries[j];
    int l = entry.y;
    int m = entry.z;
    vec2 z;
    if (entry.x == 1) {
        z = rotated(1, l, m, v);
    } else {
        // The coefficients of a real field at -m are the conjugates at m, which tells s0 and i s3 apart.
        vec2 plus = rotated(0, l, m, v);
        vec2 minus = (m & 1) == 0 ? complex_conjugate(rotated(0, l, -m, v)) : -complex_conjugate(rotated(0, l, -m, v));
        float scale = m == 0 ? 0.5 : sqrt(0.5);
        z = entry.x == 0 ? scale * complex_conjugate(plus + minus) : scale * (plus - minus);
    }
    int size = int(gl_NumWorkGroups.y);
    light[j * stride + v] = z.x;
    light[(size + j) * stride + v] = z.y;
}
