// SPDX-License-Identifier: MIT
// The relight step: multiplies the light of shadowed vertices by their symmetric shadow matrices. One
// invocation per shadowed vertex and row, and channel.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Vertices { uint vertices[]; };
// [block][pair of elements][16 vertices], 16 bits each: the elements of shadow_elements().
layout(std430, binding = 1) readonly buffer Numbers { uint numbers[]; };
layout(std430, binding = 2) readonly buffer Light { float light[]; };       // [channel][number][vertex]
// First element, row, size, first column
layout(std430, binding = 3) readonly buffer Rows { ivec4 rows[]; };
layout(std430, binding = 4) writeonly buffer Product { float product[]; };  // [channel][row][shadowed vertex]

uniform int first;             // first shadowed vertex
uniform int count;             // number of shadowed vertices
uniform int first_block;       // first block of the bound numbers
uniform int numbers_of_block;  // numbers of one vertex
uniform int first_vertex;      // first vertex of the bound light
uniform int stride;            // number of vertices in light and product
uniform int light_step;        // from a channel to the next, in light and product
uniform float scale;

// Returns the place of an element, row <= column: by tiles of four rows, within a tile by columns, then rows.
int element(int row, int column, int size) {
    int tile = row >> 2;
    int before = tile * (4 * size + 2 - 8 * tile);
    int c = column - 4 * tile;
    return before + (c < 4 ? c * (c + 1) / 2 : 4 * c - 6) + row - 4 * tile;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int s = first + i;
    int v = int(vertices[s]) - first_vertex;
    ivec4 row = rows[gl_GlobalInvocationID.y];
    int block = (s / 16 - first_block) * numbers_of_block + row.x;
    int channel = int(gl_GlobalInvocationID.z) * light_step;
    float sum = 0.0;
    for (int c = 0; c < row.z; ++c) {
        int number = block + element(min(row.y, c), max(row.y, c), row.z);
        int pair = int(numbers[(number >> 1) * 16 + s % 16]);
        sum += float(bitfieldExtract(pair, 16 * (number & 1), 16)) *
               light[channel + (row.w + c) * stride + v];
    }
    product[channel + int(gl_GlobalInvocationID.y) * stride + i] = scale * sum;
}
