// SPDX-License-Identifier: MIT
// A plane of a framebuffer, pixel by pixel.
#version 450 core

#ifdef IDS
layout(location = 0) out uint pixel;
#else
layout(location = 0) out vec4 pixel;
#endif

#include "linear.glsl"
#ifdef HOST_DEPTH
#include "host_depth.glsl"
#endif

layout(binding = 0) uniform sampler2D stored[2];  // consecutive attachments; the plane begins in the first one

uniform int kind;        // 0 stored numbers, 1 DoLP of a Stokes vector, 2 AoLP
uniform int first;       // component where the plane begins, 0 to 3
uniform int count;       // number of components, 1 to 4
uniform bool bottom_up;  // whether the image's last row goes into row 0

float number(ivec2 at, int i) {
    return texelFetch(stored[i / 4], at, 0)[i % 4];
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (bottom_up) at.y = textureSize(stored[0], 0).y - 1 - at.y;
#ifdef HOST_DEPTH
    gl_FragDepth = host_depth(at);
#endif
#ifdef IDS
    pixel = uint(number(at, first)) | uint(number(at, first + 1)) << 16;
#else
    pixel = vec4(0.0, 0.0, 0.0, 1.0);
    if (kind == 0) {
        for (int i = 0; i < count; ++i) pixel[i] = number(at, first + i);
    } else {
        vec4 s = finite_or_zero(texelFetch(stored[0], at, 0));
        pixel.x = kind == 1 ? dolp(s) : aolp(s);
    }
#endif
}
