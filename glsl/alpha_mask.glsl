// SPDX-License-Identifier: MIT
// Alpha mask of a surface.

// TEXTURES: see texture.glsl.
#define TABLE 3
#define TEXELS 4
#define CORNERS 0
#include "texture.glsl"
#include "corners.glsl"

layout(std430, binding = 1) readonly buffer OpacityIndices { uint opacity_indices[]; };
layout(std430, binding = 2) readonly buffer OpacityPositions { float opacity_positions[]; };

// Whether opacities between 0 and 1 are the fraction of samples that the surface is present for.
uniform bool translucent;
uniform uint sample_number;  // number of this sample, below `samples`
uniform uint samples;

const uint OPACITY = 7u;  // word of the opacity's number
const uint FIRST_OPACITY_TEXTURE = 8u;

vec3 opacity_position(uint index) {
    uint at = 3u * opacity_indices[index];
    return vec3(opacity_positions[at], opacity_positions[at + 1u], opacity_positions[at + 2u]);
}

// Returns a number of 0 to 1 that depends on the pixel as if by chance. Must equal chance_at() of alpha_masks.hpp.
float chance() {
    uint hash = uint(gl_FragCoord.x) * 0x9E3779B9u ^ uint(gl_FragCoord.y) * 0x85EBCA6Bu;
    hash = (hash ^ hash >> 16) * 0x7FEB352Du;
    hash = (hash ^ hash >> 15) * 0x846CA68Bu;
    return float((hash ^ hash >> 16) >> 8) * (1.0 / 16777216.0);
}

// Returns whether the surface is present at a position on a triangle, in the axes of the vertices.
bool present(uint triangle, vec3 position) {
    vec3 first = opacity_position(3u * triangle);
    vec3 second = opacity_position(3u * triangle + 1u) - first;
    vec3 third = opacity_position(3u * triangle + 2u) - first;
    vec3 normal = cross(second, third);
    float squared = max(dot(normal, normal), 1e-37);
    vec3 away = position - first;
    float b = dot(cross(away, third), normal) / squared;
    float c = dot(cross(second, away), normal) / squared;
    vec3 weight = vec3(1.0 - b - c, b, c);
    TexturePoint point = texture_point(int(triangle), weight);
    vec4 values[TEXTURES];
    evaluate_textures(FIRST_OPACITY_TEXTURE, point, values);
    vec4 opacity = values[table[OPACITY]];
    uint channels = table[FIRST_OPACITY_TEXTURE + TEXTURE_WORDS * table[OPACITY] + 1u];
    float covered = channels == 4u ? opacity.w : opacity.x;
    if (!translucent) return covered >= 0.5;
    return covered > (float(sample_number) + chance()) / float(samples);
}
