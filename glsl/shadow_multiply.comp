// SPDX-License-Identifier: MIT
// relight: the light of shadowed vertices, split by the mirror in their surface, times their shadow matrices. One
// invocation a shadowed vertex and row.
#version 450 core

#include "sparse.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
layout(std430, binding = 1) readonly buffer Numbers { uint numbers[]; };  // [block][number][16 vertices], 16 bits each
layout(std430, binding = 2) readonly buffer Light { float light[]; };     // [number][vertex]
layout(std430, binding = 3) readonly buffer Split { SparseRow split[]; };
layout(std430, binding = 4) readonly buffer Rows { ivec4 rows[]; };      // first number, step, columns, first column
layout(std430, binding = 5) writeonly buffer Product { float product[]; };  // [row][shadowed vertex]

uniform int first;             // shadowed vertex
uniform int count;             // of them
uniform int first_block;       // of the bound numbers
uniform int numbers_of_block;  // of one vertex
uniform int first_vertex;      // of the bound light
uniform int stride;            // of vertices in light and product
uniform float scale;

float matrix_element(int number, int lane) {
    int place = number * 16 + lane;
    return float(bitfieldExtract(int(numbers[place >> 1]), 16 * (place & 1), 16));
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int s = first + i;
    int v = int(vertices[s]) - first_vertex;
    ivec4 row = rows[gl_GlobalInvocationID.y];
    int number = (s / 16 - first_block) * numbers_of_block + row.x;
    float sum = 0.0;
    for (int c = 0; c < row.z; ++c) {
        SparseRow from = split[row.w + c];
        float x = from.first_factor * light[from.first * stride + v];
        if (from.second_factor != 0.0) x += from.second_factor * light[from.second * stride + v];
        sum += matrix_element(number + c * row.y, s % 16) * x;
    }
    product[int(gl_GlobalInvocationID.y) * stride + i] = scale * sum;
}
