// SPDX-License-Identifier: MIT
// The shade step at pixels: evaluates textures at points. Results are the weights of the material's layers
// and the perturbed normals. One invocation per point.
#version 450 core

// TEXTURES: see texture.glsl.
#define TABLE 5
#define TEXELS 6
#define CORNERS 1
#include "pixel_points.glsl"
#include "texture.glsl"
#include "corners.glsl"
#include "vertex_view.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Points { PixelPoint points[]; };
layout(std430, binding = 2) readonly buffer Barycentric { vec2 barycentric[]; };  // second, third corner
layout(std430, binding = 3) readonly buffer Positions { float positions[]; };
layout(std430, binding = 4) buffer Normals { float normals[]; };
layout(std430, binding = 7) writeonly buffer Weights { vec4 weights[]; };  // [layer][point]

// Words of the table before the textures' words.
const uint LAYERS = 0u;          // number of layers
const uint FIRST_LAYER = 1u;     // word of the first layer
const uint NORMAL_KIND = 2u;     // 0: no texture perturbs normals
const uint NORMAL_TEXTURE = 3u;  // number of the texture
const uint NORMAL_SCALE = 4u;
const uint MIRRORED_Y = 5u;
const uint REVERSED_BACK = 6u;
const uint FIRST_TEXTURE = 8u;
const uint NORMAL_MAP = 1u;
// Words of a layer: three of its scale, word of the first factor, number of factors. Words of a factor: kind,
// texture, three numbers.
const uint LAYER_WORDS = 5u;
const uint FACTOR_WORDS = 5u;

uniform int count;
uniform int stride;          // step of the weights from layer to layer
uniform bool back;           // whether this is the back of a two-sided surface
uniform bool with_tangents;  // whether the corners have tangents
uniform vec2 pixel_size;     // size of a pixel at unit distance, or in the world

TexturePoint point_of(int triangle, vec3 weight, vec3 position, out vec3 by_u, out vec3 by_v) {
    by_u = moved_by_u(triangle);
    by_v = moved_by_v(triangle);
    TexturePoint point = texture_point(triangle, weight);

    // Change to the pixel's neighbours. The angle is limited in edge-on views, where a pixel covers the whole
    // surface.
    vec3 normal = cross(by_u, by_v);
    float squared = dot(normal, normal);
    vec3 ray = orthographic ? forward : (position - eye) - eye_rest;
    float distance = orthographic ? 1.0 : dot(ray, forward);
    float towards = dot(ray, normal);
    float least = 1e-4 * length(ray) * sqrt(squared);
    if (!(abs(towards) > least)) towards = towards < 0.0 ? -least : least;
    if (!(squared > 0.0) || towards == 0.0) return point;
    vec3 asides[2] = vec3[2](distance * pixel_size.x * right, -distance * pixel_size.y * up);
    vec2 moves[2];
    for (int k = 0; k < 2; ++k) {
        vec3 move = asides[k] - ray * (dot(asides[k], normal) / towards);
        moves[k] = vec2(dot(cross(move, by_v), normal), dot(cross(by_u, move), normal)) / squared;
    }
    point.du = moves[0];
    point.dv = moves[1];
    return point;
}

vec3 direction(vec3 v, vec3 otherwise) {
    float squared = dot(v, v);
    return squared > 0.0 && !isinf(squared) ? v / sqrt(squared) : otherwise;
}

vec3 mapped(vec4 value, vec3 by_u, vec3 by_v, vec3 n) {
    vec3 x = direction(by_u - dot(by_u, n) * n, vec3(0.0));
    if (x == vec3(0.0)) return n;
    vec3 y = cross(n, x);
    if (table[MIRRORED_Y] != 0u && dot(y, by_v) > 0.0) y = -y;
    vec3 local = 2.0 * value.xyz - 1.0;
    return direction(local.x * x + local.y * y + local.z * n, n);
}

// Replaces the axes by those of the corners' tangents, unless these are 0; see tangent_axes().
void follow_tangents(int triangle, vec3 weight, vec3 n, inout vec3 by_u, inout vec3 by_v) {
    vec4 tangent = vec4(0.0);
    for (int k = 0; k < 3; ++k) {
        int at = corner_numbers * triangle + 12 + 4 * k;
        tangent += weight[k] * vec4(corners[at], corners[at + 1], corners[at + 2], corners[at + 3]);
    }
    if (tangent.xyz == vec3(0.0)) return;
    by_u = tangent.xyz;
    by_v = (tangent.w < 0.0 ? 1.0 : -1.0) * cross(n, by_u);
}

vec3 bumped(uint texture, TexturePoint point, vec3 by_u, vec3 by_v, vec3 n) {
    vec2 slope = number_at(NORMAL_SCALE) * texture_gradient(texture, point);
    vec3 turned = direction(cross(by_u + (slope.x - dot(n, by_u)) * n, by_v + (slope.y - dot(n, by_v)) * n), n);
    return dot(turned, n) < 0.0 ? -turned : turned;
}

// Returns the perturbed normal; see perturbed_normal() and facing().
vec3 perturbed_normal(TexturePoint point, vec4 values[TEXTURES], vec3 by_u, vec3 by_v, vec3 position, vec3 normal) {
    if (by_u == vec3(0.0) && by_v == vec3(0.0)) return normal;
    vec3 front = back ? -normal : normal;
    uint number = table[NORMAL_TEXTURE];
    vec3 turned = table[NORMAL_KIND] == NORMAL_MAP
                      ? mapped(values[number], by_u, by_v, front)
                      : bumped(FIRST_TEXTURE + TEXTURE_WORDS * number, point, by_u, by_v, front);
    if (back) turned = table[REVERSED_BACK] != 0u ? -turned : turned - 2.0 * dot(turned, front) * front;
    vec3 towards_viewer = towards_camera(position);
    if (dot(turned, towards_viewer) <= 0.0) turned = 2.0 * dot(turned, normal) * normal - turned;
    float least = min(0.02, dot(normal, towards_viewer));
    float cosine = dot(turned, towards_viewer);
    return cosine >= least ? turned : direction(turned + (least - cosine) * towards_viewer, normal);
}

vec3 factor_value(uint factor, vec4 value) {
    switch (table[factor]) {
        case 0u: return value.xyz;
        case 1u: return vec3(clamp(value.x, 0.0, 1.0));
        case 2u: return vec3(1.0 - clamp(value.x, 0.0, 1.0));
    }
    float middle = number_at(factor + 3u);
    if (table[factor] == 4u) return (1.0 - middle) * value.xyz / (1.0 - middle * value.xyz);
    float end = number_at(factor + (value.x <= middle ? 2u : 4u));
    if (end == middle) return vec3(1.0);
    if (value.x <= 0.0) return vec3(0.0);
    return vec3(max(0.0, (1.0 / end - 1.0 / value.x) / (1.0 / end - 1.0 / middle)));
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    vec3 position = vec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    vec2 weight = barycentric[i];
    vec3 by_u, by_v;
    int triangle = int(points[i].triangle);
    vec3 weights_of_corners = vec3(1.0 - weight.x - weight.y, weight.x, weight.y);
    TexturePoint point = point_of(triangle, weights_of_corners, position, by_u, by_v);
    vec4 values[TEXTURES];
    evaluate_textures(FIRST_TEXTURE, point, values);

    if (table[NORMAL_KIND] != 0u) {
        vec3 normal = vec3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
        if (with_tangents && table[NORMAL_KIND] == NORMAL_MAP)
            follow_tangents(triangle, weights_of_corners, back ? -normal : normal, by_u, by_v);
        normal = perturbed_normal(point, values, by_u, by_v, position, normal);
        for (int k = 0; k < 3; ++k) normals[3 * i + k] = normal[k];
    }
    for (uint l = 0u; l < table[LAYERS]; ++l) {
        uint layer = table[FIRST_LAYER] + LAYER_WORDS * l;
        vec3 of_layer = vec3(number_at(layer), number_at(layer + 1u), number_at(layer + 2u));
        for (uint f = 0u; f < table[layer + 4u]; ++f) {
            uint factor = table[layer + 3u] + FACTOR_WORDS * f;
            of_layer *= factor_value(factor, values[table[factor + 1u]]);
        }
        weights[int(l) * stride + i] = vec4(of_layer, 0.0);
    }
}
