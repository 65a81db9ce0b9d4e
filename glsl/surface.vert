// SPDX-License-Identifier: MIT
// Passes shaded vertices on.
#version 450 core

// CHANNELS: number of colour channels drawn at once.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 stokes[CHANNELS];

layout(location = 0) out vec4 vertex_stokes[CHANNELS];

uniform mat4 world_to_clip;

void main() {
    vertex_stokes = stokes;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
