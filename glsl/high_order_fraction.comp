// SPDX-License-Identifier: MIT
// shade: the visible fractions of what vertices reflect of light of high orders. One invocation a vertex.
#version 450 core

#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 2) readonly buffer Visibility { float visibility[]; };  // [l l + l + m][vertex]
layout(std430, binding = 4) writeonly buffer Fractions { vec2 fractions[]; };    // of the lobe, of the base

uniform int first;  // vertex, in the bound part of the scene
uniform int count;
uniform int visibility_first;
uniform int stride;

int vertex;
#define VISIBILITY(l, m) visibility[((l) * (l) + (l) + (m)) * stride + vertex]
#include "high_order_visibility.glsl"

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int v = first + i;
    vertex = visibility_first + i;
    vec3 normal = vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    vec3 view = towards_camera(vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]));
    vec3 d = reflect(facing_view(normal, view, camera_x(view)), normal);
    fractions[v] = high_order_visible(d * theta_phi_frame(normal));
}
