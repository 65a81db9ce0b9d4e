// SPDX-License-Identifier: MIT
// Interpolates the vertices' Stokes vectors. They are all in the camera's frame field, which is smooth over the image.
#version 450 core

layout(location = 0) in vec4 vertex_stokes[CHANNELS];
layout(location = 0) out vec4 pixel[CHANNELS];

#ifdef HIGH_ORDERS
#define HIGH_ORDER_FILTERED
#include "vertex_view.glsl"
#include "high_order.glsl"
#include "physical.glsl"

layout(location = 4) in vec3 vertex_position;
layout(location = 5) in vec3 vertex_normal;
// The visible fractions of lobes are scalars and can be interpolated, unlike the coefficients of visibility, which are in
// the vertices' own frames.
#ifdef SHADOWED
layout(location = 6) in vec2 vertex_visible;
#endif

layout(binding = 0) uniform sampler2D factors;
layout(binding = 1) uniform sampler2D central;
layout(binding = 2) uniform sampler2D outer;
layout(binding = 3) uniform sampler2D base;

uniform mat3 to_light;
uniform float spread;
uniform bool has_base;
uniform bool physical;
#endif

void main() {
    // Back faces are black and opaque.
    if (!gl_FrontFacing) {
        for (int c = 0; c < CHANNELS; ++c) pixel[c] = vec4(0.0);
        return;
    }
#ifdef HIGH_ORDERS
    vec3 view = towards_camera(vertex_position);
    // Interpolated normals may cancel.
    vec3 normal = dot(vertex_normal, vertex_normal) > 1e-12 ? normalize(vertex_normal) : view;
#ifdef SHADOWED
    vec2 visible = clamp(vertex_visible, 0.0, 1.0);
#else
    vec2 visible = vec2(1.0);
#endif
    if (!has_base) visible.y = 0.0;
    vec4 high[CHANNELS];
    high_order(normal, view, camera_x(view), to_light, spread, visible, factors, central, outer, base, high);
    for (int c = 0; c < CHANNELS; ++c) {
        pixel[c] = vertex_stokes[c] + high[c];
        if (physical) pixel[c] = made_physical(pixel[c]);
    }
#else
    for (int c = 0; c < CHANNELS; ++c) pixel[c] = vertex_stokes[c];
#endif
}
