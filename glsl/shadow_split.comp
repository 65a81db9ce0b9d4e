// SPDX-License-Identifier: MIT
// relight: packed light to light that is split by the mirror. One invocation a shadowed vertex and number.
#version 450 core

#include "sparse.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
layout(std430, binding = 1) writeonly buffer Product { float product[]; };  // [row][shadowed vertex]
layout(std430, binding = 2) readonly buffer Light { float light[]; };       // [number][vertex]
layout(std430, binding = 3) readonly buffer Split { SparseRow split[]; };

uniform int first;         // shadowed vertex
uniform int count;         // of them
uniform int first_vertex;  // of the bound light
uniform int stride;        // of vertices in the light
uniform int product_stride;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int v = int(vertices[first + i]) - first_vertex;
    SparseRow from = split[gl_GlobalInvocationID.y];
    float x = from.first_factor * light[from.first * stride + v] + from.second_factor * light[from.second * stride + v];
    product[int(gl_GlobalInvocationID.y) * product_stride + i] = x;
}
