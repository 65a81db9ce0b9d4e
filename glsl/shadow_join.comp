// SPDX-License-Identifier: MIT
// relight: back from light that is split by the mirror to packed light. One invocation a shadowed vertex and number.
#version 450 core

#include "sparse.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
layout(std430, binding = 1) readonly buffer Product { float product[]; };  // [row][shadowed vertex]
layout(std430, binding = 2) writeonly buffer Light { float light[]; };     // [number][vertex]
layout(std430, binding = 3) readonly buffer Join { SparseRow join[]; };

uniform int first;         // shadowed vertex
uniform int count;         // of them
uniform int first_vertex;  // of the bound light
uniform int stride;        // of vertices in the light
uniform int product_stride;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    SparseRow from = join[gl_GlobalInvocationID.y];
    float x = from.first_factor * product[from.first * product_stride + i] +
              from.second_factor * product[from.second * product_stride + i];
    light[int(gl_GlobalInvocationID.y) * stride + int(vertices[first + i]) - first_vertex] = x;
}
