#version 450 core
layout(location = 0) out vec4 pixel[CHANNELS];
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };  // normal, view, visible fractions
layout(binding = 0) uniform sampler2D factors;
layout(binding = 1) uniform sampler2D central;
layout(binding = 2) uniform sampler2D outer;
layout(binding = 3) uniform sampler2D base;
uniform mat3 to_light;
uniform vec3 up;
uniform float spread;
#include "high_order.glsl"

void main() {
    int i = int(gl_FragCoord.x);
    vec3 view = points[3 * i + 1].xyz;
    vec4 stokes[CHANNELS];
    high_order(points[3 * i].xyz, view, normalize(cross(up, view)), to_light, spread, points[3 * i + 2].xy, factors,
               central, outer, base, stokes);
    pixel = stokes;
}
