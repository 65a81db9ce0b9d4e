// SPDX-License-Identifier: MIT
// The shade step: adds the reflection of high orders of light at vertices. One invocation per vertex.
#version 450 core

// CHANNELS: number of colour channels at once. SHADOWED: surfaces cast shadows.
#include "vertex_view.glsl"
#include "high_order.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 4) buffer StokesVectors { vec4 values[]; } stokes[CHANNELS];
layout(binding = 0) uniform sampler2D factors;
layout(binding = 1) uniform sampler2D central;
layout(binding = 2) uniform sampler2D outer;
layout(binding = 3) uniform sampler2D base;

uniform int first;  // first vertex, in the bound part of the scene
uniform int count;
uniform mat3 to_light;
uniform float spread;
uniform bool has_base;

#ifdef SHADOWED
layout(std430, binding = 2) readonly buffer Fractions { vec2 fractions[]; };
#endif

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int v = first + i;
    vec3 normal = vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    vec3 view = towards_camera(vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]));
    vec2 visible = vec2(1.0);
#ifdef SHADOWED
    visible = fractions[v];
#endif
    if (!has_base) visible.y = 0.0;
    vec4 added[CHANNELS];
    high_order(normal, view, camera_x(view), to_light, spread, visible, factors, central, outer, base, added);
    for (int c = 0; c < CHANNELS; ++c) stokes[c].values[v] += added[c];
}
