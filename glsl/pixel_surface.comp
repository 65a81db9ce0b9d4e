// SPDX-License-Identifier: MIT
// The shade step at pixels: finds the points where rays meet the planes of their triangles, and the normals
// there. A point outside its triangle is moved inside. One invocation per point.
#version 450 core

#include "pixel_points.glsl"
#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Points { PixelPoint points[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) readonly buffer VertexPositions { float vertex_positions[]; };
layout(std430, binding = 3) readonly buffer VertexNormals { float vertex_normals[]; };
layout(std430, binding = 4) writeonly buffer Positions { float positions[]; };
layout(std430, binding = 5) writeonly buffer Normals { float normals[]; };
layout(std430, binding = 6) writeonly buffer Weights { vec2 weights[]; };  // second, third corner

uniform int count;
uniform int width;
uniform vec2 size;       // size of the image, in pixels
uniform vec2 half_size;  // half size of the image at unit distance, or in the world
uniform vec2 shift;      // shift of the image on that plane, in half sizes

vec3 position_of(int v) {
    return vec3(vertex_positions[3 * v], vertex_positions[3 * v + 1], vertex_positions[3 * v + 2]);
}

vec3 normal_of(int v) {
    return vec3(vertex_normals[3 * v], vertex_normals[3 * v + 1], vertex_normals[3 * v + 2]);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    PixelPoint point = points[i];
    int pixel = int(point.pixel);
    vec2 from_middle = vec2(pixel % width, pixel / width) + 0.5 - 0.5 * size + point.at;
    vec2 at = (vec2(2.0, -2.0) * from_middle / size + shift) * half_size;
    vec3 aside = at.x * right + at.y * up;

    uint first = first_corner(point, corners.length());
    ivec3 corner = ivec3(corners[first], corners[first + 1u], corners[first + 2u]);
    vec3 a = position_of(corner.x);
    precise vec3 from_eye = (a - eye) - eye_rest;
    vec3 second = position_of(corner.y) - a;
    vec3 third = position_of(corner.z) - a;

    // The ray and the plane are intersected by Cramer's rule.
    vec3 direction = orthographic ? forward : forward + aside;
    vec3 begin = orthographic ? aside - from_eye : -from_eye;
    vec3 across = cross(direction, third);
    float determinant = dot(second, across);
    float inverse = 1.0 / (determinant == 0.0 ? 1.0 : determinant);
    float u = clamp(dot(begin, across) * inverse, 0.0, 1.0);
    float v = clamp(dot(direction, cross(begin, second)) * inverse, 0.0, 1.0 - u);

    vec3 position = a + (u * second + v * third);
    vec3 normal = (1.0 - u - v) * normal_of(corner.x) + u * normal_of(corner.y) + v * normal_of(corner.z);
    normal = dot(normal, normal) > 1e-12 ? normalize(normal) : normalize(-direction);
    for (int k = 0; k < 3; ++k) {
        positions[3 * i + k] = position[k];
        normals[3 * i + k] = normal[k];
    }
    weights[i] = vec2(u, v);
}
