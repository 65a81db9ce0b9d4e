// SPDX-License-Identifier: MIT
// shade: packed light of vertices dotted with the rows of a table at the view direction. One invocation a vertex.
#version 450 core

#include "complex.glsl"
#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 2) readonly buffer Light { float light[]; };        // [real, imaginary][entry][vertex]
layout(std430, binding = 3) readonly buffer Table { float table[]; };        // [angle][s0, s1, s2, s3][entry]
layout(std430, binding = 4) writeonly buffer Result { vec4 result[]; };

uniform int first;        // vertex, in the bound part of the scene
uniform int light_first;  // in the bound light
uniform int count;
uniform int stride;       // of the light's vertices
uniform int order;
uniform int entries;
uniform int angles;       // of the table, from 0 to pi/2
uniform bool polarized;   // the light has s1 and s2
uniform bool circular;    // it has s3
uniform bool makes_linear;
uniform bool makes_circular;

// Adds entries begin .. end - 1, which share the factor exp(i k phi).
void add(inout vec4 stokes, int begin, int end, vec2 phase, int vertex, int row, float part) {
    for (int j = begin; j < end; ++j) {
        vec2 z = complex_multiply(vec2(light[j * stride + vertex], light[(entries + j) * stride + vertex]), phase);
        int low = row + j;
        int high = low + 4 * entries;
        stokes.x += mix(table[low], table[high], part) * z.x;
        if (makes_linear) {
            stokes.y += mix(table[low + entries], table[high + entries], part) * z.x;
            stokes.z += mix(table[low + 2 * entries], table[high + 2 * entries], part) * z.y;
        }
        if (makes_circular) stokes.w += mix(table[low + 3 * entries], table[high + 3 * entries], part) * z.y;
    }
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int v = first + i;
    VertexView view = view_from_camera(vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]),
                                       vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]));
    TablePosition at = position_in(view, angles);
    int row = 4 * entries * at.angle;

    // Entries are ordered by Stokes part, then degree m, then order; linear polarization has negative degrees, too.
    int scalars = (order + 1) * (order + 2) / 2;
    int spins = polarized && order >= 2 ? (order + 1) * (order + 1) - 4 : 0;
    int s0 = 0;
    int spin = scalars + (spins - max(order - 1, 0)) / 2;  // of m = 0
    int minus = spin;
    int s3 = scalars + spins;
    vec4 stokes = vec4(0.0);
    vec2 phase = vec2(1.0, 0.0);
    for (int m = 0; m <= order; ++m) {
        int here = order + 1 - m;
        add(stokes, s0, s0 + here, complex_conjugate(phase), light_first + i, row, at.part);
        s0 += here;
        if (spins > 0) {
            int some = order + 1 - max(m, 2);
            add(stokes, spin, spin + some, phase, light_first + i, row, at.part);
            spin += some;
            if (m > 0) {
                minus -= some;
                add(stokes, minus, minus + some, complex_conjugate(phase), light_first + i, row, at.part);
            }
        }
        if (circular) {
            add(stokes, s3, s3 + here, phase, light_first + i, row, at.part);
            s3 += here;
        }
        phase = complex_multiply(phase, view.azimuth);
    }
    result[v] = in_camera_frame(view, stokes);
}
