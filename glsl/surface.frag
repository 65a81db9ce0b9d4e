// SPDX-License-Identifier: MIT
// Stokes vectors between vertices. All are in the camera's frame field, which is smooth over the picture, so plain
// interpolation is right.
#version 450 core

layout(location = 0) in vec4 vertex_stokes[CHANNELS];
layout(location = 0) out vec4 pixel[CHANNELS];

void main() {
    // Materials have no back: seen from behind they are black, yet hide what lies behind them.
    float front = gl_FrontFacing ? 1.0 : 0.0;
    for (int c = 0; c < CHANNELS; ++c) pixel[c] = front * vertex_stokes[c];
}
