// SPDX-License-Identifier: MIT
// Sums of products of a vertex's numbers and fixed factors. One invocation per vertex, sum and
// channel.
#version 450 core

layout(local_size_x = 64) in;

struct Sum {
    int first;   // first number
    int second;  // first number of a second run of equal length, or -1
    int terms;
    int factor;  // first factor; factors of the second run follow
};

layout(std430, binding = 0) readonly buffer Sums { Sum sums[]; };
layout(std430, binding = 1) readonly buffer Factors { float factors[]; };
layout(std430, binding = 2) readonly buffer Numbers { float numbers[]; };   // [channel][number][vertex]
layout(std430, binding = 3) writeonly buffer Results { float results[]; };  // [channel][sum][vertex]

uniform int count;   // number of vertices
uniform int stride;  // number of vertices in the buffers
// Steps from a channel to the next.
uniform int from_step;
uniform int to_step;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    Sum sum = sums[gl_GlobalInvocationID.y];
    int channel = int(gl_GlobalInvocationID.z);
    int from = channel * from_step + i;
    float x = 0.0;
    for (int j = 0; j < sum.terms; ++j) x += factors[sum.factor + j] * numbers[from + (sum.first + j) * stride];
    if (sum.second >= 0) {
        int factor = sum.factor + sum.terms;
        for (int j = 0; j < sum.terms; ++j) x += factors[factor + j] * numbers[from + (sum.second + j) * stride];
    }
    results[channel * to_step + int(gl_GlobalInvocationID.y) * stride + i] = x;
}
