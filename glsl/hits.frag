// SPDX-License-Identifier: MIT
// Which triangle is at a pixel: 1 + its number, and in the topmost bit whether its front is seen.
#version 450 core

// CUT_OUT: the surface is not there everywhere.
#ifdef CUT_OUT
#include "cut_out.glsl"
layout(location = 0) in vec3 surface_position;
#endif

layout(location = 0) out uint hit;

uniform uint first;  // of the triangles that are drawn

void main() {
#ifdef CUT_OUT
    if (!present(first + uint(gl_PrimitiveID), surface_position)) discard;
#endif
    hit = first + uint(gl_PrimitiveID) + 1u | (gl_FrontFacing ? 0x80000000u : 0u);
}
