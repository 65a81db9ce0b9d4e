// SPDX-License-Identifier: MIT
// The relight step: the inverse of shadow_gather.comp.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
layout(std430, binding = 1) readonly buffer Gathered { float gathered[]; };  // [channel][number][shadowed vertex]
layout(std430, binding = 2) writeonly buffer Light { float light[]; };       // [channel][number][vertex]

uniform int first;  // first shadowed vertex
uniform int count;  // number of shadowed vertices
uniform int gathered_stride;
// Steps from a channel to the next.
uniform int gathered_step;
uniform int light_step;
uniform int first_vertex;  // first vertex of the bound light
uniform int stride;        // number of vertices in the light

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int number = int(gl_GlobalInvocationID.y);
    int channel = int(gl_GlobalInvocationID.z);
    int at = channel * light_step + number * stride + int(vertices[first + i]) - first_vertex;
    int at_gathered = channel * gathered_step + number * gathered_stride + i;
    light[at] = gathered[at_gathered];
}
