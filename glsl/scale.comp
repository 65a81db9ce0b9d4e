// SPDX-License-Identifier: MIT
// Multiplies Stokes vectors by a factor of their channel. One invocation per vector and channel.
#version 450 core

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer StokesVectors { vec4 stokes[]; };  // [channel][vector]

uniform int count;
uniform int channel_step;  // number of vectors from a channel to the next
uniform int first_channel;
uniform float factors[16];  // ChannelFactors

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int channel = int(gl_GlobalInvocationID.z);
    stokes[channel * channel_step + i] *= factors[first_channel + channel];
}
