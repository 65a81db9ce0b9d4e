// SPDX-License-Identifier: MIT
// Polarization elements (polarization/element.hpp) before an image, which is also the target. Each sample of
// a pixel passes the pixel's light through the elements before the surface that the sample shows; the pixel
// becomes the mean over its samples.
#version 450 core

#include "hits.glsl"
#include "vertex_view.glsl"
// TEXTURED: defined if elements have textures.
#ifdef TEXTURED
#define TABLE 3
#define TEXELS 4
#include "texture.glsl"
#endif

layout(location = 0) in vec2 uv;  // (0, 0) is the upper left corner
layout(location = 0) out vec4 pixel[CHANNELS];

layout(binding = 0) uniform sampler2D behind[CHANNELS];
layout(binding = 4) uniform usampler2D hits[SAMPLES];

// A polarization element. Places and directions are in the axes of the vertices.
struct Element {
    vec4 x;     // xyz: the element's x direction; w: x of the eye from the center; the edge is at 1
    vec4 y;
    vec4 z;     // xyz: unit normal; w: coordinate of the eye along the normal
    vec4 axis;  // unit: absorbing axis of a polarizer, fast axis of a retarder, for a textured angle that of the
                // angle 0; w: the kind
    float retardance;  // radians
    float transmittance;
    float round;  // 1: a disk, 0: a rectangle
    float angle;  // radians
    uint angle_texture;  // word of the texture that is a factor on the angle, or NO_TEXTURE
    uint retardance_texture;
    uint unused[2];
};
const uint NO_TEXTURE = 0xFFFFFFFFu;
const int POLARIZER = 0;
const int RETARDER = 1;
const int RIGHT_CIRCULAR = 2;

layout(std430, binding = 0) readonly buffer Elements { Element elements[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) readonly buffer Positions { float positions[]; };

uniform vec2 half_size;   // half size of the image at unit distance, or in the world
uniform vec2 shift;       // shift of the image on that plane, in half sizes
uniform vec2 pixel_size;  // size of a pixel in uv
uniform float near;
uniform float far;
uniform int components;  // number of Stokes components of the image; the others become 0
uniform vec2 offsets[SAMPLES];  // samples from the pixel's centre, in pixels

struct Ray {
    vec3 aside;      // origin relative to the eye
    vec3 direction;  // length 1 along the view, so that ray parameters are depths
};

Ray ray_through(vec2 at) {
    vec2 place = (vec2(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y) + shift) * half_size;
    vec3 across = place.x * right + place.y * up;
    return orthographic ? Ray(across, forward) : Ray(vec3(0.0), forward + across);
}

vec3 position_of(uint corner) {
    uint at = 3u * corners[corner];
    return vec3(positions[at], positions[at + 1u], positions[at + 2u]);
}

float distance_to(Hit hit, Ray ray) {
    vec3 a = position_of(3u * hit.triangle);
    vec3 normal = cross(position_of(3u * hit.triangle + 1u) - a, position_of(3u * hit.triangle + 2u) - a);
    precise vec3 from_eye = (a - eye) - eye_rest;
    return dot(normal, from_eye - ray.aside) / dot(normal, ray.direction);
}

// Returns x and y of the element at a distance along a ray.
vec2 place_on(Element element, Ray ray, float t) {
    vec3 way = ray.aside + t * ray.direction;
    return vec2(dot(element.x.xyz, way) + element.x.w, dot(element.y.xyz, way) + element.y.w);
}

// Returns the distance, or a negative number if the ray does not meet the element.
float distance_to(Element element, Ray ray) {
    float t = -(element.z.w + dot(element.z.xyz, ray.aside)) / dot(element.z.xyz, ray.direction);
    vec2 at = place_on(element, ray, t);
    float edge = element.round != 0.0 ? length(at) : max(abs(at.x), abs(at.y));
    return edge <= 1.0 ? t : -1.0;
}

// Axis and retardance of an element where a ray meets it.
struct Local {
    vec3 axis;
    vec3 retardance;  // at normal incidence: that of the first three channels
};

Local local_at(Element element, vec2 place) {
    Local local = Local(element.axis.xyz, vec3(element.retardance));
#ifdef TEXTURED
    TexturePoint point = TexturePoint(0.5 + 0.5 * place, vec2(0.0), vec2(0.0), vec3(1.0));
    if (element.angle_texture != NO_TEXTURE) {
        float angle = element.angle * texture_at(element.angle_texture, point).x;
        local.axis = cos(angle) * local.axis + sin(angle) * cross(element.z.xyz, local.axis);
    }
    if (element.retardance_texture != NO_TEXTURE)
        local.retardance *= texture_at(element.retardance_texture, point).xyz;
#endif
    return local;
}

// Passes light in the camera's frame field, whose x axis is `x`, through an element at a place of it.
void pass(Element element, vec2 place, vec3 propagation, vec3 x, inout vec4 light[CHANNELS]) {
    Local local = local_at(element, place);
    vec2 axis = vec2(dot(local.axis, x), dot(local.axis, cross(propagation, x)));
    float squared = dot(axis, axis);
    vec2 twice = squared > 0.0 ? double_angle(axis) / squared : vec2(1.0, 0.0);
    vec3 delta = local.retardance * abs(dot(element.z.xyz, propagation));
    vec3 cosines = cos(delta);
    vec3 sines = sin(delta);
    int kind = int(element.axis.w);
    for (int i = 0; i < CHANNELS; ++i) {
        vec4 along = in_rotated_frame(light[i], twice);
        vec4 passed;
        if (kind == POLARIZER) {
            float h = 0.5 * (along.x - along.y);
            passed = vec4(h, -h, 0.0, 0.0);
        } else if (kind == RETARDER) {
            // In scenes of more than three channels, textures have one.
            float c = cosines[min(i, 2)];
            float s = sines[min(i, 2)];
            passed = vec4(along.xy, c * along.z + s * along.w, c * along.w - s * along.z);
        } else {
            float sign = kind == RIGHT_CIRCULAR ? 1.0 : -1.0;
            float h = 0.5 * (along.x + sign * along.w);
            passed = vec4(h, 0.0, 0.0, sign * h);
        }
        light[i] = element.transmittance * in_rotated_frame(passed, vec2(twice.x, -twice.y));
    }
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 light[CHANNELS];
    vec4 sum[CHANNELS];
    for (int i = 0; i < CHANNELS; ++i) {
        light[i] = texelFetch(behind[i], texel, 0);
        sum[i] = vec4(0.0);
    }
    bool met = false;
    for (int k = 0; k < SAMPLES; ++k) {
        Ray ray = ray_through(uv + offsets[k] * pixel_size);
        vec3 propagation = -normalize(ray.direction);
        vec3 x = camera_x(propagation);
        Hit hit = hit_of(texelFetch(hits[k], texel, 0).x);
        float last = hit.exists ? min(distance_to(hit, ray), far) : far;
        int last_element = elements.length();
        vec4 passed[CHANNELS] = light;
        // Elements are applied from the farthest to the nearest; at equal distances the later one comes
        // first.
        while (true) {
            float farthest = near;
            int next = -1;
            for (int p = 0; p < elements.length(); ++p) {
                float t = distance_to(elements[p], ray);
                if (t >= farthest && (t < last || (t == last && p < last_element))) {
                    farthest = t;
                    next = p;
                }
            }
            if (next < 0) break;
            pass(elements[next], place_on(elements[next], ray, farthest), propagation, x, passed);
            last = farthest;
            last_element = next;
            met = true;
        }
        for (int i = 0; i < CHANNELS; ++i) sum[i] += passed[i];
    }
    if (!met && components == 4) discard;
    for (int i = 0; i < CHANNELS; ++i) {
        pixel[i] = sum[i] / float(SAMPLES);
        for (int p = components; p < 4; ++p) pixel[i][p] = 0.0;
    }
}
