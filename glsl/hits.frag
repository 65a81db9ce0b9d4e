// SPDX-License-Identifier: MIT
// Which triangle is at a pixel: the lower 16 bits of its number, 1 + the upper ones, and 1 where its front is seen.
#version 450 core

layout(location = 0) out vec4 hit;

uniform uint first;  // of the triangles that are drawn

void main() {
    uint triangle = first + uint(gl_PrimitiveID);
    hit = vec4(float(triangle & 0xffffu), float((triangle >> 16) + 1u), gl_FrontFacing ? 1.0 : 0.0, 0.0);
}
