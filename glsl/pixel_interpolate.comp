// SPDX-License-Identifier: MIT
// The shade step at pixels: interpolates numbers of vertices at points of triangles. One invocation per point,
// number and channel.
#version 450 core

#include "pixel_points.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Points { PixelPoint points[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) readonly buffer Weights { vec2 weights[]; };  // second, third corner
layout(std430, binding = 3) readonly buffer From { float from[]; };
layout(std430, binding = 4) buffer To { float to[]; };

uniform int count;
uniform int first_vertex;  // first bound vertex
uniform int last_vertex;   // end of the bound vertices; other vertices add nothing
uniform bool add;          // whether to add to the existing values
// Steps from a channel to the next, from a number to the next, and from a vertex or point to the next.
uniform int from_channel;
uniform int to_channel;
uniform int from_number;
uniform int from_vertex;
uniform int to_number;
uniform int to_point;
uniform int to_first;  // first point's place in the result

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int number = int(gl_GlobalInvocationID.y);
    uint corner = first_corner(points[i], corners.length());
    vec2 weight = weights[i];
    float of_corner[3] = float[3](1.0 - weight.x - weight.y, weight.x, weight.y);
    int channel = int(gl_GlobalInvocationID.z);
    int source = channel * from_channel + number * from_number;
    int result = channel * to_channel + number * to_number + (to_first + i) * to_point;
    float sum = add ? to[result] : 0.0;
    for (int k = 0; k < 3; ++k) {
        int v = int(corners[corner + uint(k)]);
        if (v >= first_vertex && v < last_vertex)
            sum += of_corner[k] * from[source + (v - first_vertex) * from_vertex];
    }
    to[result] = sum;
}
