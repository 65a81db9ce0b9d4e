// SPDX-License-Identifier: MIT
// First pass of a rotation: computes z^k sum_n D_nk a^n f_n of each field. One invocation per point, l and k,
// and channel.
#version 450 core

#include "rotation.glsl"

layout(std430, binding = 3) readonly buffer Light { float light[]; };  // [channel]
layout(std430, binding = 4) writeonly buffer Result { vec2 result[]; };  // [channel][field][l l + l + k][point]

uniform ivec2 points;     // first point, and the end of the points
uniform int number_step;  // step from a number of the light to the next
uniform int point_step;   // step from a point to the next; 0: all points have one light

void main() {
    int v = points[0] + int(gl_GlobalInvocationID.x);
    if (v >= points[1]) return;
    int channel = int(gl_GlobalInvocationID.z);
    int size = (order + 1) * (order + 1);
    int field = int(gl_GlobalInvocationID.y) / size;
    int index = int(gl_GlobalInvocationID.y) - field * size;
    int l = int(sqrt(float(index) + 0.5));
    int k = index - l * l - l;
    if (l < 2 * field) return;  // spin 2 begins at l = 2

    Rotation rotation = rotation_of(v);
    int entry = l * (l + 1) / 2 + (field == 0 ? 0 : (order + 1) * (order + 2) / 2 - 3);
    vec2 sum = vec2(0.0);
    vec2 phase = vec2(1.0, 0.0);
    for (int m = 0; m <= l; ++m) {
        ivec4 from = entries[2 * (entry + m) + 1];
        vec4 numbers;
        for (int i = 0; i < 4; ++i)
            numbers[i] = from[i] < 0 ? 0.0 : light[channel * light_step + from[i] * number_step + v * point_step];
        vec2 plus, minus;
        coefficients_of(field, l, m, numbers, plus, minus);
        sum += quarter(l, m, k) * complex_multiply(plus, phase);
        if (m > 0) sum += quarter(l, -m, k) * complex_multiply(minus, complex_conjugate(phase));
        phase = complex_multiply(phase, rotation.a);
    }
    result[channel * fields_step + (field * size + index) * stride + v] = complex_multiply(sum, complex_power(rotation.z, k));
}
