// SPDX-License-Identifier: MIT
// Second pass of a rotation: computes b^m D of each field, as numbers of LightLayout. One invocation per
// point, field, l and m >= 0, and channel.
#version 450 core

#include "rotation.glsl"

layout(std430, binding = 3) readonly buffer Fields { vec2 fields[]; };  // [channel][field][l l + l + k][point]
layout(std430, binding = 4) writeonly buffer Light { float light[]; };  // [channel][number][point]

uniform int count;

vec2 rotated(int field, int l, int m, int v, vec2 b) {
    int channel = int(gl_GlobalInvocationID.z);
    int middle = field * (order + 1) * (order + 1) + l * l + l;
    vec2 sum = vec2(0.0);
    for (int k = -l; k <= l; ++k) sum += quarter(l, m, k) * fields[channel * fields_step + (middle + k) * stride + v];
    return complex_multiply(sum, complex_power(b, m));
}

void main() {
    int v = int(gl_GlobalInvocationID.x);
    if (v >= count) return;
    ivec4 entry = entries[2 * gl_GlobalInvocationID.y];
    ivec4 to = entries[2 * gl_GlobalInvocationID.y + 1];
    int field = entry.x;
    int l = entry.y;
    int m = entry.z;
    vec2 b = rotation_of(v).b;
    vec4 numbers = numbers_of(field, l, m, rotated(field, l, m, v, b), rotated(field, l, -m, v, b));
    int channel = int(gl_GlobalInvocationID.z);
    for (int i = 0; i < 4; ++i) {
        if (to[i] >= 0) light[channel * light_step + to[i] * stride + v] = numbers[i];
    }
}
