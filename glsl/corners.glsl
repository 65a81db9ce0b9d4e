// SPDX-License-Identifier: MIT
// Texture coordinates and colours of triangles' corners, in the layout of DeviceCorners. Include after
// texture.glsl.

// CORNERS: binding.
layout(std430, binding = CORNERS) readonly buffer Corners { float corners[]; };  // [triangle][corner_numbers]

uniform int corner_numbers;
uniform bool colored;  // whether triangles have colours; they come last

// Returns the texture point with these barycentric weights, without footprint.
TexturePoint texture_point(int triangle, vec3 weight) {
    int first = corner_numbers * triangle;
    TexturePoint point = TexturePoint(vec2(0.0), vec2(0.0), vec2(0.0), colored ? vec3(0.0) : vec3(1.0));
    for (int k = 0; k < 3; ++k) {
        int at = first + 2 * k;
        point.uv += weight[k] * vec2(corners[at], corners[at + 1]);
        int color = first + corner_numbers - 9 + 3 * k;
        if (colored) point.color += weight[k] * vec3(corners[color], corners[color + 1], corners[color + 2]);
    }
    return point;
}

// Returns the derivative of a point's position by u.
vec3 moved_by_u(int triangle) {
    int at = corner_numbers * triangle + 6;
    return vec3(corners[at], corners[at + 1], corners[at + 2]);
}

// Returns the derivative of a point's position by v.
vec3 moved_by_v(int triangle) {
    int at = corner_numbers * triangle + 9;
    return vec3(corners[at], corners[at + 1], corners[at + 2]);
}
