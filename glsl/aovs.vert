// SPDX-License-Identifier: MIT
// Transforms vertices for the AOVs.
#version 450 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 surface_position;  // in the axes of the vertices
layout(location = 1) out vec3 vertex_normal;

uniform mat4 to_clip;   // from the axes of the vertices
uniform mat4 to_world;  // from the axes of the vertices; a rotation and a translation

void main() {
    surface_position = position;
    vertex_normal = mat3(to_world) * normal;
    gl_Position = to_clip * vec4(position, 1.0);
}
