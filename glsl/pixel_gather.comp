// SPDX-License-Identifier: MIT
// shade at pixels: Stokes vectors of points, each times the fraction of the samples that it is of, into the image. One
// invocation a pixel.
#version 450 core

// SAMPLES: of a pixel. LIT: there are local lights.
layout(local_size_x = 64) in;

// [pixel][SAMPLES]: place of a point times 16, plus its samples; the first 0 ends a pixel's.
layout(std430, binding = 0) readonly buffer Shares { uint shares[]; };
layout(std430, binding = 1) readonly buffer StokesVectors { vec4 stokes[]; };
#ifdef LIT
layout(std430, binding = 2) readonly buffer LocalLights { vec4 local_lights[]; };  // by pixel, what they add
#endif
layout(binding = 0, rgba32f) writeonly uniform image2D image;

uniform int first;  // pixel
uniform int count;
uniform int width;
uniform vec4 wanted;  // 1 for each component that the image has

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    vec4 sum = vec4(0.0);
    for (int p = 0; p < SAMPLES; ++p) {
        uint share = shares[i * SAMPLES + p];
        if (share == 0u) break;
        sum += float(share & 15u) / float(SAMPLES) * stokes[share >> 4];
    }
    sum *= wanted;
#ifdef LIT
    sum += local_lights[i];
#endif
    int pixel = first + i;
    imageStore(image, ivec2(pixel % width, pixel / width), sum);
}
