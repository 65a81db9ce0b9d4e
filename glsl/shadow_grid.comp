// SPDX-License-Identifier: MIT
// The relight step: multiplies the light of shadowed vertices by their visibility, at a row and column and
// its three images. One invocation per shadowed vertex, Stokes component and point, and channel.
#version 450 core

layout(local_size_x = 64) in;

// [block][point][phi, -phi, pi - phi, pi + phi][16 vertices], 16 bits each
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
// [channel][Stokes component][even, odd part][cosines of even, odd m, sines of even, odd m][point][shadowed vertex]
layout(std430, binding = 1) buffer Light { float light[]; };

uniform int first;              // first shadowed vertex
uniform int count;              // number of shadowed vertices
uniform int first_block;        // first block of the bound samples
uniform int samples_of_vertex;
uniform int points;
uniform int stride;             // number of vertices in the light
uniform int light_step;         // from a channel to the next
uniform float scale;

float visibility(int number, int lane) {
    int place = number * 16 + lane;
    return scale * float(bitfieldExtract(int(samples[place >> 1]), 16 * (place & 1), 16));
}

vec4 visibility_of_images(int number, int lane) {
    return vec4(visibility(number, lane), visibility(number + 1, lane), visibility(number + 2, lane),
                visibility(number + 3, lane));
}

vec4 images(int at, int step) {
    float even = light[at] + light[at + step];
    float odd = light[at] - light[at + step];
    float right = light[at + 3 * step] + light[at + 2 * step];
    float left = light[at + 3 * step] - light[at + 2 * step];
    return vec4(even + right, even - right, odd + left, odd - left);
}

void fold(int at, int step, vec4 f) {
    light[at] = f.x + f.y + (f.z + f.w);
    light[at + step] = f.x + f.y - (f.z + f.w);
    light[at + 2 * step] = f.x - f.y - (f.z - f.w);
    light[at + 3 * step] = f.x - f.y + (f.z - f.w);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int component = int(gl_GlobalInvocationID.y) / points;
    int point = int(gl_GlobalInvocationID.y) - component * points;
    int step = points * stride;
    int channel = int(gl_GlobalInvocationID.z);
    int even = channel * light_step + 8 * component * step + point * stride + i;
    int odd = even + 4 * step;

    int s = first + i;
    int number = (s / 16 - first_block) * samples_of_vertex + 4 * point;
    vec4 v = visibility_of_images(number, s % 16);
    fold(even, step, v * images(even, step));
    fold(odd, step, v * images(odd, step));
}
