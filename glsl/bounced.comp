// SPDX-License-Identifier: MIT
// Adds bounced light to the light of vertices. One invocation per vertex, number of the bounced light, and
// channel.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Bounced { float bounced[]; };
layout(std430, binding = 1) buffer Light { float light[]; };
layout(std430, binding = 2) readonly buffer Places { uint places[]; };

uniform int count;
uniform int stride;
// Steps from a channel to the next.
uniform int from_step;
uniform int light_step;

void main() {
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= count) return;
    int number = int(gl_GlobalInvocationID.y);
    int channel = int(gl_GlobalInvocationID.z);
    light[channel * light_step + int(places[number]) * stride + vertex] +=
        bounced[channel * from_step + number * stride + vertex];
}
