// SPDX-License-Identifier: MIT
// Surfaces to their planes.
#version 450 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 vertex_position;
layout(location = 1) out vec3 vertex_normal;

uniform mat4 world_to_clip;

void main() {
    vertex_position = position;
    vertex_normal = normal;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
