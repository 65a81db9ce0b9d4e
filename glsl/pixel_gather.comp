// SPDX-License-Identifier: MIT
// The shade step at pixels: sums the Stokes vectors of points, each times its fraction of the pixel's
// samples, and writes them to the image. One invocation per pixel and channel.
#version 450 core

// SAMPLES: samples per pixel. LIT: there are local lights.
layout(local_size_x = 64) in;

// [pixel][SAMPLES]: place of a point times 16, plus its number of samples; the first 0 ends a pixel's list.
layout(std430, binding = 0) readonly buffer Shares { uint shares[]; };
layout(std430, binding = 1) readonly buffer StokesVectors { vec4 stokes[]; };
#ifdef LIT
layout(std430, binding = 2) readonly buffer LocalLights { vec4 local_lights[]; };  // light to add to pixels
#endif
layout(binding = 0, rgba32f) writeonly uniform image2DArray image;

uniform int first;  // first pixel
uniform int count;
uniform int width;
uniform int first_channel;
uniform int stokes_step;  // steps from a channel to the next
#ifdef LIT
uniform int lights_step;
#endif
uniform vec4 wanted;  // 1 for each component that the image has

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int channel = int(gl_GlobalInvocationID.z);
    vec4 sum = vec4(0.0);
    for (int p = 0; p < SAMPLES; ++p) {
        uint share = shares[i * SAMPLES + p];
        if (share == 0u) break;
        sum += float(share & 15u) / float(SAMPLES) * stokes[channel * stokes_step + int(share >> 4)];
    }
    sum *= wanted;
#ifdef LIT
    sum += local_lights[channel * lights_step + i];
#endif
    int pixel = first + i;
    imageStore(image, ivec3(pixel % width, pixel / width, first_channel + channel), sum);
}
