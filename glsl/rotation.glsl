// SPDX-License-Identifier: MIT
// Rotating light into vertices' frames by Ry(-theta) Rz(-phi): d(theta) = i^m D exp(-i k theta) D^T i^-n, D =
// d(-pi/2). Stokes vectors are two complex fields, s0 + i s3 and s1 + i s2, which rotate alike.

#include "complex.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer QuarterRotation { float quarter_rotation[]; };  // D: [l][m + l][k + l]

uniform int count;   // vertices
uniform int stride;  // of vertices in what is written
uniform int order;

float quarter(int l, int m, int k) {
    return quarter_rotation[l * (4 * l * l - 1) / 3 + (m + l) * (2 * l + 1) + k + l];
}
