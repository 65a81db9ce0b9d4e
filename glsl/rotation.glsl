// SPDX-License-Identifier: MIT
// Rotation of light into the frames of points by Ry(-theta) Rz(-phi), and back. d(theta) = i^m D exp(-i k
// theta) D^T i^-n with D = d(-pi/2), so that the coefficients of a complex field become
//     f'_m = b^m sum_k D_mk z^k sum_n D_nk a^n f_n,    a = i exp(i phi), z = exp(-i theta), b = -i.
// The reverse has equal sums with a = i, z = exp(i theta), b = -i exp(-i phi), because D is orthogonal.
// Stokes vectors are two complex fields, s0 + i s3 and s1 + i s2, which are rotated in the same way.

#include "complex.glsl"

layout(local_size_x = 64) in;

// D: [l][m + l][k + l]
layout(std430, binding = 0) readonly buffer QuarterRotation { float quarter_rotation[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
// Pairs: field, l, m; then the numbers of LightLayout that belong to m and -m, or -1. Field 0 is s0 + i s3
// with cosine and sine of s0 and of s3. Field 1 is s1 + i s2 with cosine and sine of the parts e and o.
layout(std430, binding = 2) readonly buffer Entries { ivec4 entries[]; };

uniform int first;   // first point, in the bound normals
uniform int stride;  // number of points in the output
// Steps from a channel to the next, in the light and in the fields between both passes.
uniform int light_step;
uniform int fields_step;
uniform int order;
uniform bool back;

float quarter(int l, int m, int k) {
    return quarter_rotation[l * (4 * l * l - 1) / 3 + (m + l) * (2 * l + 1) + k + l];
}

struct Rotation {
    vec2 a;
    vec2 z;
    vec2 b;
};

Rotation rotation_of(int v) {
    int i = 3 * (first + v);
    vec3 normal = vec3(normals[i], normals[i + 1], normals[i + 2]);
    float rho = length(normal.xy);
    vec2 azimuth = rho > 0.0 ? vec2(-normal.y, normal.x) / rho : vec2(0.0, 1.0);
    vec2 zenith = vec2(normal.z, -rho) / length(vec2(normal.z, rho));
    if (back) return Rotation(vec2(0.0, 1.0), complex_conjugate(zenith), complex_conjugate(azimuth));
    return Rotation(azimuth, zenith, vec2(0.0, -1.0));
}

// Returns the coefficient at -m of a real field: (-1)^m times the conjugate at m. This relation separates s0
// and i s3.
vec2 image_of(int m, vec2 coefficient) {
    return (m & 1) == 0 ? complex_conjugate(coefficient) : -complex_conjugate(coefficient);
}

// Returns the numbers of a field's coefficients at m and -m.
vec4 numbers_of(int field, int l, int m, vec2 plus, vec2 minus) {
    float scale = m == 0 ? 0.5 : sqrt(0.5);
    plus *= scale;
    minus *= scale;
    if (field == 0) {
        vec2 image = image_of(m, minus);
        vec2 s0 = plus + image;
        vec2 s3 = plus - image;
        return vec4(s0.x, -s0.y, s3.y, s3.x);
    }
    if ((l & 1) != 0) minus = -minus;
    return vec4(plus.x + minus.x, minus.y - plus.y, plus.y + minus.y, plus.x - minus.x);
}

// Computes the coefficients of a field at m and -m from its numbers: the inverse of numbers_of().
void coefficients_of(int field, int l, int m, vec4 numbers, out vec2 plus, out vec2 minus) {
    numbers *= m == 0 ? 1.0 : sqrt(0.5);
    if (field == 0) {
        vec2 s0 = vec2(numbers.x, -numbers.y);
        vec2 s3 = numbers.wz;
        plus = s0 + s3;
        minus = image_of(m, s0 - s3);
    } else {
        plus = vec2(numbers.x + numbers.w, numbers.z - numbers.y);
        minus = vec2(numbers.x - numbers.w, numbers.z + numbers.y);
        if ((l & 1) != 0) minus = -minus;
    }
}
