// SPDX-License-Identifier: MIT
// The shade step at pixels: adds the Stokes vectors of a layer, times its weights, to those of the material.
// One invocation per point and channel.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Layer { vec4 layer[]; };
layout(std430, binding = 1) readonly buffer Weights { vec4 weights[]; };
layout(std430, binding = 2) buffer Result { vec4 result[]; };

uniform int count;
uniform int first_weight;
uniform int first_channel;
// Steps from a channel to the next.
uniform int from_channel;
uniform int to_channel;
uniform bool add;  // whether to add to the existing values

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int channel = int(gl_GlobalInvocationID.z);
    // A point's three weights are equal if the image does not have three channels.
    float weight = weights[first_weight + i][min(first_channel + channel, 2)];
    // The values of a layer without weight may be anything, infinities included.
    vec4 part = weight == 0.0 ? vec4(0.0) : weight * layer[channel * from_channel + i];
    int to = channel * to_channel + i;
    result[to] = add ? result[to] + part : part;
}
