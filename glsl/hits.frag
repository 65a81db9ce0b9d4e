// SPDX-License-Identifier: MIT
// Visibility buffer: 1 + the number of the triangle at a pixel; the topmost bit is set if its front is
// visible.
#version 450 core

// ALPHA_MASK: the surface has an alpha mask.
#ifdef ALPHA_MASK
#include "alpha_mask.glsl"
layout(location = 0) in vec3 surface_position;
#endif

layout(location = 0) out uint hit;

uniform uint first;  // first triangle of the draw call

void main() {
#ifdef ALPHA_MASK
    if (!present(first + uint(gl_PrimitiveID), surface_position)) discard;
#endif
    hit = first + uint(gl_PrimitiveID) + 1u | (gl_FrontFacing ? 0x80000000u : 0u);
}
