// SPDX-License-Identifier: MIT
// Passes shaded vertices on.
#version 450 core

// CHANNELS: colour channels drawn at once. HIGH_ORDERS: pixels look up high orders; SHADOWED: times the visible
// fractions at the vertices.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 stokes[CHANNELS];

layout(location = 0) out vec4 vertex_stokes[CHANNELS];

uniform mat4 world_to_clip;

#ifdef HIGH_ORDERS
layout(location = 5) in vec3 normal;
layout(location = 4) out vec3 vertex_position;
layout(location = 5) out vec3 vertex_normal;
#ifdef SHADOWED
layout(location = 6) in vec2 visible;
layout(location = 6) out vec2 vertex_visible;
#endif
#endif

void main() {
    vertex_stokes = stokes;
#ifdef HIGH_ORDERS
    vertex_position = position;
    vertex_normal = normal;
#ifdef SHADOWED
    vertex_visible = visible;
#endif
#endif
    gl_Position = world_to_clip * vec4(position, 1.0);
}
