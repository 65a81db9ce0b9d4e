#version 450 core
layout(location = 0) out vec4 pixel[CHANNELS];
#include "psh_field.glsl"

void main() {
    vec4 stokes[CHANNELS];
    psh_evaluate(order, directions[int(gl_FragCoord.x)].xyz, stokes);
    pixel = stokes;
}
