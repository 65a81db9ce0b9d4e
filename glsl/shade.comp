// SPDX-License-Identifier: MIT
// The shade step: dot product of the light of vertices and the rows of a table at the view direction. One
// invocation per vertex and channel.
#version 450 core

#include "complex.glsl"
#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(std430, binding = 2) readonly buffer Light { float light[]; };  // [channel][number][vertex]
// [channel][angle][s0, s1, s2, s3][pairing][pair]
layout(std430, binding = 3) readonly buffer Table { float table[]; };
layout(std430, binding = 4) writeonly buffer Result { vec4 result[]; };  // [channel][vertex]
// Runs (LightLayout::Run) by |m|: first even and odd number of the light, count, sign * m.
layout(std430, binding = 5) readonly buffer Runs { ivec4 runs[]; };

// First point in the bound part of the scene, first point in the bound light, number of points.
uniform ivec3 points;
uniform int stride;       // number of vertices in the light
// Steps from a channel to the next; 0: one for all channels.
uniform int light_step;
uniform int table_step;
uniform int result_step;
uniform int row_size;     // numbers of all pairings
uniform int pairs;        // numbers of one pairing
uniform int runs_of_row;
uniform int angles;       // angles of the table, from 0 to pi/2
uniform bool makes_linear;
uniform bool makes_circular;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= points.z) return;
    int channel = int(gl_GlobalInvocationID.z);
    int v = points.x + i;
    VertexView view = view_from_camera(vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]),
                                       vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]));
    TablePosition at = position_in(view, angles);
    int vertex = channel * light_step + points.y + i;
    int low = channel * table_step + 4 * row_size * at.angle;
    int high = low + 4 * row_size;

    vec4 stokes = vec4(0.0);
    vec2 phase = vec2(1.0, 0.0);  // exp(i m phi)
    int m = 0;
    for (int r = 0; r < runs_of_row; ++r) {
        ivec4 run = runs[r];
        for (; m < abs(run.w); ++m) phase = complex_multiply(phase, view.azimuth);
        vec2 rotation = run.w < 0 ? complex_conjugate(phase) : phase;
        for (int k = 0; k < run.z; ++k, ++low, ++high) {
            vec2 z = vec2(light[(run.x + k) * stride + vertex], light[(run.y + k) * stride + vertex]);
            // (even, odd) relative to the viewer's azimuth.
            z = vec2(rotation.x * z.x + rotation.y * z.y, rotation.x * z.y - rotation.y * z.x);
            // Even and odd change places in the second pairing.
            for (int at_row = 0; at_row < row_size; at_row += pairs, z = z.yx) {
                int a = low + at_row;
                int b = high + at_row;
                stokes.x += mix(table[a], table[b], at.part) * z.x;
                if (makes_linear) {
                    stokes.y += mix(table[a + row_size], table[b + row_size], at.part) * z.x;
                    stokes.z += mix(table[a + 2 * row_size], table[b + 2 * row_size], at.part) * z.y;
                }
                if (makes_circular) stokes.w += mix(table[a + 3 * row_size], table[b + 3 * row_size], at.part) * z.y;
            }
        }
    }
    result[channel * result_step + v] = in_camera_frame(view, stokes);
}
