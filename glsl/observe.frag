// SPDX-License-Identifier: MIT
// An observer's image of a Stokes image, pixel by pixel.
#version 450 core

#include "linear.glsl"
#ifdef HOST_DEPTH
#include "host_depth.glsl"
#endif

layout(location = 0) out vec4 pixel;

layout(binding = 0) uniform sampler2D stokes[CHANNELS];

uniform int kind;        // 0 radiance, 1 signed component, 2 DoLP, 3 AoLP
uniform vec4 analyzer;   // radiance and signed component: the value is dot(analyzer, s)
uniform bool encode;     // all but signed components: sRGB-encoded
uniform bool bottom_up;  // whether the image's last row goes into row 0

vec4 mean(ivec2 at) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < CHANNELS; ++i) sum += finite_or_zero(texelFetch(stokes[i], at, 0));
    return sum / float(CHANNELS);
}

vec3 srgb(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}

vec3 linear(vec3 v) {
    return mix(pow((v + 0.055) / 1.055, vec3(2.4)), v / 12.92, lessThanEqual(v, vec3(0.04045)));
}

vec3 hue(float angle) {
    return clamp(abs(mod(6.0 * angle + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (bottom_up) at.y = textureSize(stokes[0], 0).y - 1 - at.y;
#ifdef HOST_DEPTH
    gl_FragDepth = host_depth(at);
#endif
    vec3 colour = vec3(0.0);
    if (kind == 0) {
        for (int i = 0; i < 3; ++i)
            colour[i] = dot(analyzer, finite_or_zero(texelFetch(stokes[min(i, CHANNELS - 1)], at, 0)));
    } else {
        vec4 s = mean(at);
        float value = dot(analyzer, s);
        if (kind == 1) colour = value < 0.0 ? vec3(-value, 0.0, 0.0) : vec3(0.0, value, 0.0);
        if (kind == 2) colour = vec3(dolp(s));
        // The hue is one of encoded colours.
        if (kind == 3) colour = linear(srgb(vec3(dolp(s))) * hue(aolp(s) / PI));
    }
    if (encode && kind != 1) colour = srgb(colour);
    pixel = vec4(colour, 1.0);
}
