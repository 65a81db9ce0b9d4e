// SPDX-License-Identifier: MIT
// relight, second pass: (-i)^m D of each field, as numbers of LightLayout; one invocation a vertex, field, l and m >= 0.
#version 450 core

#include "rotation.glsl"

// By twos: field, l, m; then the numbers that it makes, or -1. Field 0 is s0 + i s3 and makes cosine and sine of either,
// field 1 is s1 + i s2 and makes cosine and sine of the parts e and o.
layout(std430, binding = 1) readonly buffer Entries { ivec4 entries[]; };
layout(std430, binding = 2) readonly buffer Fields { vec2 fields[]; };  // [field][l l + l + k][vertex]
layout(std430, binding = 3) writeonly buffer Light { float light[]; };  // [number][vertex]

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
    ivec4 entry = entries[2 * gl_GlobalInvocationID.y];
    ivec4 numbers = entries[2 * gl_GlobalInvocationID.y + 1];
    int l = entry.y;
    int m = entry.z;
    float scale = m == 0 ? 0.5 : sqrt(0.5);
    vec2 plus = scale * rotated(entry.x, l, m, v);
    vec2 minus = scale * rotated(entry.x, l, -m, v);
    vec4 values;
    if (entry.x == 0) {
        // The coefficients of a real field at -m are (-1)^m times the conjugates at m, which tells s0 and i s3 apart.
        vec2 image = (m & 1) == 0 ? complex_conjugate(minus) : -complex_conjugate(minus);
        vec2 s0 = plus + image;
        vec2 s3 = plus - image;
        values = vec4(s0.x, -s0.y, s3.y, s3.x);
    } else {
        if ((l & 1) != 0) minus = -minus;
        values = vec4(plus.x + minus.x, minus.y - plus.y, plus.y + minus.y, plus.x - minus.x);
    }
    for (int i = 0; i < 4; ++i) {
        if (numbers[i] >= 0) light[numbers[i] * stride + v] = values[i];
    }
}
