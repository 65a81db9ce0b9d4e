// SPDX-License-Identifier: MIT
// The shade step: visible fractions for the reflection of high orders of light. One invocation per vertex.
#version 450 core

#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 2) readonly buffer Visibility { float visibility[]; };  // [l l + l + m][vertex]
// HighOrderVisibility::constants()
layout(std430, binding = 3) readonly buffer Lobe { float lobe[]; };
layout(std430, binding = 4) writeonly buffer Fractions { vec2 fractions[]; };    // (lobe, base)

// First vertex in the bound part of the scene, first vertex of the bound visibility, number of vertices.
uniform ivec3 vertices;
uniform int stride;
uniform int visibility_order;

float coefficient(int l, int m, int vertex) {
    return visibility[(l * l + l + m) * stride + vertex];
}

// Returns the visible fractions of a lobe about d, a unit direction in the vertex's frame, and of the cosine
// about -z.
vec2 visible_fractions(vec3 d, int vertex) {
    int orders = visibility_order + 1;
    int factor = 2 * orders;
    float seen = 0.0;
    float base_seen = 0.0;
    float start = 0.28209479;  // Y_00
    vec2 phase = vec2(1.0, 0.0);
    for (int m = 0; m < orders; ++m) {
        float value = start;
        float before = 0.0;
        for (int l = m; l < orders; ++l) {
            if (l > m) {
                float next = lobe[factor] * d.z * value - lobe[factor + 1] * before;
                before = value;
                value = next;
                factor += 2;
            }
            if ((l + m) % 2 != 0) continue;  // 0 because visibility is mirrored at the horizon
            float scaled = lobe[l] * value;
            if (m == 0) {
                seen += scaled * coefficient(l, 0, vertex);
                base_seen += lobe[orders + l] * coefficient(l, 0, vertex);
            } else {
                seen += scaled * (phase.x * coefficient(l, m, vertex) + phase.y * coefficient(l, -m, vertex));
            }
        }
        float next = float(m + 1);
        start *= -sqrt((2.0 * next + 1.0) / (2.0 * next));
        if (m == 0) start *= sqrt(2.0);
        phase = vec2(phase.x * d.x - phase.y * d.y, phase.y * d.x + phase.x * d.y);
    }
    return clamp(vec2(seen, base_seen), 0.0, 1.0);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= vertices.z) return;
    int v = vertices.x + i;
    vec3 normal = vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    vec3 view = towards_camera(vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]));
    vec3 d = reflect(facing_view(normal, view, camera_x(view)), normal);
    fractions[v] = visible_fractions(d * theta_phi_frame(normal), vertices.y + i);
}
