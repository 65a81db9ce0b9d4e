// SPDX-License-Identifier: MIT
// Which triangle is at a pixel: 1 + its number, and in the topmost bit whether its front is seen.
#version 450 core

layout(location = 0) out uint hit;

uniform uint first;  // of the triangles that are drawn

void main() { hit = first + uint(gl_PrimitiveID) + 1u | (gl_FrontFacing ? 0x80000000u : 0u); }
