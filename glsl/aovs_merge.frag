// SPDX-License-Identifier: MIT
// Adds the AOVs of one sample of every pixel to the AOVs of the samples before, which are also the target.
// The result is the sum of the normals, normalised after the last sample; the mean of the coverage; and all
// other AOVs of the nearest surface.
#version 450 core

// ATTACHMENTS, NORMALS, DEPTH, ALPHA: as in aovs.frag.
layout(location = 0) out vec4 pixel[ATTACHMENTS];

layout(binding = 0) uniform sampler2D drawn[ATTACHMENTS];
layout(binding = 4) uniform sampler2D before[ATTACHMENTS];

#ifdef NORMALS
uniform bool last;
#endif
#ifdef ALPHA
uniform float weight;  // 1 / number of samples
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float sampled[4 * ATTACHMENTS];
    float value[4 * ATTACHMENTS];
    for (int a = 0; a < ATTACHMENTS; ++a) {
        vec4 d = texelFetch(drawn[a], at, 0);
        vec4 b = texelFetch(before[a], at, 0);
        for (int i = 0; i < 4; ++i) {
            sampled[4 * a + i] = d[i];
            value[4 * a + i] = b[i];
        }
    }
#ifdef NORMALS
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) sum[i] = value[NORMALS + i] + sampled[NORMALS + i];
    if (last) sum = dot(sum, sum) > 1e-12 ? normalize(sum) : vec3(0.0);
#endif
#ifdef ALPHA
    float alpha = value[ALPHA] + weight * sampled[ALPHA];
#endif
#ifdef DEPTH
    if (sampled[DEPTH] < value[DEPTH]) value = sampled;
#endif
#ifdef NORMALS
    for (int i = 0; i < 3; ++i) value[NORMALS + i] = sum[i];
#endif
#ifdef ALPHA
    value[ALPHA] = alpha;
#endif
    for (int a = 0; a < ATTACHMENTS; ++a)
        pixel[a] = vec4(value[4 * a], value[4 * a + 1], value[4 * a + 2], value[4 * a + 3]);
}
