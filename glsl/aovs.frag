// SPDX-License-Identifier: MIT
// AOVs: depth, normal, position, instance and coverage, of one sample of a pixel.
#version 450 core

// ATTACHMENTS: their number. NORMALS, DEPTH, POSITIONS, INSTANCES, ALPHA: the position of the AOV's first
// float, if it is requested.
layout(location = 0) in vec3 surface_position;  // in the axes of the vertices
layout(location = 1) in vec3 vertex_normal;
layout(location = 0) out vec4 pixel[ATTACHMENTS];

// ALPHA_MASK: the surface has an alpha mask.
#ifdef ALPHA_MASK
#include "alpha_mask.glsl"
uniform uint first;  // first triangle of the draw call
#endif

#ifdef POSITIONS
uniform mat4 to_world;  // from the axes of the vertices
#endif
#ifdef DEPTH
uniform vec3 eye;       // the camera's position in the axes of the vertices
uniform vec3 eye_rest;  // its rounding error in single precision
uniform vec3 forward;
#endif
#ifdef INSTANCES
uniform uint instance;
#endif

void main() {
#ifdef ALPHA_MASK
    if (!present(first + uint(gl_PrimitiveID), surface_position)) discard;
#endif
    float value[4 * ATTACHMENTS];
    for (int i = 0; i < 4 * ATTACHMENTS; ++i) value[i] = 0.0;
#ifdef NORMALS
    // Interpolated normals may cancel; the result is 0 then.
    vec3 normal = dot(vertex_normal, vertex_normal) > 1e-12 ? normalize(vertex_normal) : vec3(0.0);
    for (int i = 0; i < 3; ++i) value[NORMALS + i] = normal[i];
#endif
#ifdef DEPTH
    precise vec3 offset = (surface_position - eye) - eye_rest;
    value[DEPTH] = dot(forward, offset);
#endif
#ifdef POSITIONS
    vec3 world = (to_world * vec4(surface_position, 1.0)).xyz;
    for (int i = 0; i < 3; ++i) value[POSITIONS + i] = world[i];
#endif
#ifdef INSTANCES
    value[INSTANCES] = float(instance & 0xffffu);
    value[INSTANCES + 1] = float(instance >> 16);
#endif
#ifdef ALPHA
    value[ALPHA] = 1.0;
#endif
    for (int a = 0; a < ATTACHMENTS; ++a)
        pixel[a] = vec4(value[4 * a], value[4 * a + 1], value[4 * a + 2], value[4 * a + 3]);
}
