// SPDX-License-Identifier: MIT
// The shade step at pixels: adds the Stokes vectors of a layer, times its weights, to those of the material.
// One invocation per point.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Layer { vec4 layer[]; };
layout(std430, binding = 1) readonly buffer Weights { vec4 weights[]; };
layout(std430, binding = 2) buffer Result { vec4 result[]; };

uniform int count;
uniform int first_weight;
uniform int channel;  // channel of the weights
uniform bool add;     // whether to add to the existing values

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    float weight = weights[first_weight + i][channel];
    // The values of a layer without weight may be anything, infinities included.
    vec4 part = weight == 0.0 ? vec4(0.0) : weight * layer[i];
    result[i] = add ? result[i] + part : part;
}
