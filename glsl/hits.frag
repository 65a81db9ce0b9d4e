// SPDX-License-Identifier: MIT
// Which triangle is at a pixel: 1 + its number, and in the topmost bit whether its front is seen.
#version 450 core

// ALPHA_MASK: the surface is not there everywhere.
#ifdef ALPHA_MASK
#include "alpha_mask.glsl"
layout(location = 0) in vec3 surface_position;
#endif

layout(location = 0) out uint hit;

uniform uint first;  // of the triangles that are drawn

void main() {
#ifdef ALPHA_MASK
    if (!present(first + uint(gl_PrimitiveID), surface_position)) discard;
#endif
    hit = first + uint(gl_PrimitiveID) + 1u | (gl_FrontFacing ? 0x80000000u : 0u);
}
