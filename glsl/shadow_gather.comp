// SPDX-License-Identifier: MIT
// The relight step: gathers the light of shadowed vertices. One invocation per shadowed vertex and number.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
layout(std430, binding = 1) writeonly buffer Gathered { float gathered[]; };  // [number][shadowed vertex]
layout(std430, binding = 2) readonly buffer Light { float light[]; };         // [number][vertex]

uniform int first;  // first shadowed vertex
uniform int count;  // number of shadowed vertices
uniform int gathered_stride;
uniform int first_vertex;  // first vertex of the bound light
uniform int stride;        // number of vertices in the light

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int number = int(gl_GlobalInvocationID.y);
    gathered[number * gathered_stride + i] = light[number * stride + int(vertices[first + i]) - first_vertex];
}
