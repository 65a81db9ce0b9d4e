// SPDX-License-Identifier: MIT
// relight, first pass: exp(-i k theta) D^T (i exp(i phi))^n of each field, one invocation a vertex, l and k.
#version 450 core

#include "rotation.glsl"

layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 2) readonly buffer Fields { vec2 fields[]; };  // [field][l l + l + n]
layout(std430, binding = 3) writeonly buffer Result { vec2 result[]; };  // [field][l l + l + k][vertex]

void main() {
    int v = int(gl_GlobalInvocationID.x);
    if (v >= count) return;
    int size = (order + 1) * (order + 1);
    int field = int(gl_GlobalInvocationID.y) / size;
    int index = int(gl_GlobalInvocationID.y) - field * size;
    int l = int(sqrt(float(index) + 0.5));
    int k = index - l * l - l;

    vec3 normal = vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    float rho = length(normal.xy);
    vec2 azimuth = rho > 0.0 ? vec2(-normal.y, normal.x) / rho : vec2(0.0, 1.0);
    vec2 zenith = vec2(normal.z, -rho) / length(vec2(normal.z, rho));

    vec2 sum = vec2(0.0);
    vec2 phase = complex_power(azimuth, -l);
    for (int n = -l; n <= l; ++n) {
        sum += quarter(l, n, k) * complex_multiply(fields[field * size + l * l + l + n], phase);
        phase = complex_multiply(phase, azimuth);
    }
    result[(field * size + index) * stride + v] = complex_multiply(sum, complex_power(zenith, k));
}
