// SPDX-License-Identifier: MIT
#version 450 core

layout(location = 0) in vec3 position;

#ifdef ALPHA_MASK
layout(location = 0) out vec3 surface_position;
#endif

uniform mat4 to_clip;

void main() {
#ifdef ALPHA_MASK
    surface_position = position;
#endif
    gl_Position = to_clip * vec4(position, 1.0);
}
