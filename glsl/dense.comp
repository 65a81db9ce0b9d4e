// SPDX-License-Identifier: MIT
// The relight step of the dense method: one matrix per vertex times the world's light. One invocation per
// vertex and row.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Matrices { float matrices[]; };  // [vertex][channel][column][row]
layout(std430, binding = 1) readonly buffer World { float world[]; };        // [column]
layout(std430, binding = 2) writeonly buffer Light { float light[]; };       // [row][vertex]

uniform int count;           // number of vertices
uniform int stride;          // number of vertices in the light
uniform int rows;            // numbers per column, with padding
uniform int used_rows;
uniform int columns;
uniform int channel;         // channel of the matrices
uniform int channels;        // number of channels of the matrices

void main() {
    // Neighbouring invocations take neighbouring rows, which is the memory order of the matrices.
    int i = int(gl_GlobalInvocationID.x);
    int v = i / rows;
    int row = i - v * rows;
    if (v >= count || row >= used_rows) return;
    int at = (v * channels + channel) * columns * rows + row;
    float sum = 0.0;
    for (int c = 0; c < columns; ++c) sum += matrices[at + c * rows] * world[c];
    light[row * stride + v] = sum;
}
