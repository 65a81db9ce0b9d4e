// SPDX-License-Identifier: MIT
// One triangle over the whole image, at the far plane, from gl_VertexID alone.
#version 450 core

layout(location = 0) out vec2 uv;  // (0, 0) at the image's upper left corner, (1, 1) at its lower right one

void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv.x * 2.0 - 1.0, 1.0 - uv.y * 2.0, 0.0, 1.0);
}
