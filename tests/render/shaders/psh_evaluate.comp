#version 450 core
layout(local_size_x = 32) in;
layout(std430, binding = 2) writeonly buffer Result { vec4 result[]; };  // [direction][channel]
#include "psh_field.glsl"

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= directions.length()) return;
    vec4 stokes[CHANNELS];
    psh_evaluate(order, directions[i].xyz, stokes);
    for (int c = 0; c < CHANNELS; ++c) result[i * CHANNELS + c] = stokes[c];
}
