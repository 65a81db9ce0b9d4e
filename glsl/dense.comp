// SPDX-License-Identifier: MIT
// The relight step of the dense method: one matrix per vertex times the world's light. One invocation per
// vertex and row, and channel.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Matrices { float matrices[]; };  // [vertex][channel][column][row]
layout(std430, binding = 1) readonly buffer World { float world[]; };        // [channel][column]
layout(std430, binding = 2) writeonly buffer Light { float light[]; };       // [channel][row][vertex]

uniform int count;           // number of vertices
uniform int stride;          // number of vertices in the light
uniform int rows;            // numbers per column, with padding
uniform int used_rows;
uniform int columns;
uniform int first_channel;
uniform int channels;        // number of channels of the matrices
uniform bool one_matrix;     // whether all channels share their matrices
// Steps from a channel to the next; 0: one for all channels.
uniform int world_step;
uniform int light_step;

void main() {
    // Neighbouring invocations take neighbouring rows, which is the memory order of the matrices.
    int i = int(gl_GlobalInvocationID.x);
    int v = i / rows;
    int row = i - v * rows;
    if (v >= count || row >= used_rows) return;
    int of_group = int(gl_GlobalInvocationID.z);
    int at = (v * channels + (one_matrix ? 0 : first_channel + of_group)) * columns * rows + row;
    float sum = 0.0;
    for (int c = 0; c < columns; ++c) sum += matrices[at + c * rows] * world[of_group * world_step + c];
    light[of_group * light_step + row * stride + v] = sum;
}
