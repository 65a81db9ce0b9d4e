// SPDX-License-Identifier: MIT
// Interpolates the vertices' Stokes vectors, all in the camera's frame field, which is smooth over the image.
#version 450 core

layout(location = 0) in vec4 vertex_stokes[CHANNELS];
layout(location = 0) out vec4 pixel[CHANNELS];

void main() {
    // Back faces are black and opaque.
    for (int c = 0; c < CHANNELS; ++c) pixel[c] = gl_FrontFacing ? vertex_stokes[c] : vec4(0.0);
}
