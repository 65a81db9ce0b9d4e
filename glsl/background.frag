// SPDX-License-Identifier: MIT
// Environment behind the surfaces.
#version 450 core

layout(location = 0) in vec2 uv;  // (0, 0) is the upper left corner
layout(location = 0) out vec4 pixel[CHANNELS];

// SHADED: the image already has surfaces, times the fraction of the pixel that they cover, which is
// `coverage`.
#ifdef SHADED
layout(binding = 0) uniform sampler2D shaded[CHANNELS];
layout(binding = CHANNELS) uniform sampler2D coverage;
#define ENVIRONMENT CHANNELS + 1
#else
#define ENVIRONMENT 0
#endif

// POLARIZED: one Stokes texture per channel; otherwise a single texture whose components are the channels'
// s0.
#ifdef POLARIZED
layout(binding = ENVIRONMENT) uniform sampler2D environment[CHANNELS];
#else
layout(binding = ENVIRONMENT) uniform sampler2D environment;
#endif

uniform mat3 camera;        // columns: right, up, forward in the world
uniform vec2 half_size;     // half size of the image at unit distance
uniform vec2 shift;         // shift of the image on that plane, in half sizes
uniform bool orthographic;  // all pixels share the direction `forward`
uniform mat3 to_light;      // world directions to the environment's axes, y up
uniform float scale;

const float PI = 3.14159265358979;

void main() {
#ifdef SHADED
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float uncovered = 1.0 - texelFetch(coverage, texel, 0).x;
    if (uncovered == 0.0) discard;
#define SHOW(i, stokes) pixel[i] = texelFetch(shaded[i], texel, 0) + uncovered * (stokes)
#else
#define SHOW(i, stokes) pixel[i] = stokes
#endif
    vec2 at = orthographic ? vec2(0.0) : (vec2(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y) + shift) * half_size;
    vec3 ray = normalize(camera * vec3(at, 1.0));
    vec3 d = to_light * ray;

    // Columns are pixel-centred, rows vertex-centred (row 0 is the pole).
#ifdef POLARIZED
    float rows = float(textureSize(environment[0], 0).y);
#else
    float rows = float(textureSize(environment, 0).y);
#endif
    float across = length(d.xz);
    float u = across > 0.0 ? atan(d.x, -d.z) / (2.0 * PI) : 0.0;
    vec2 texcoord = vec2(u, (atan(across, d.y) / PI * (rows - 1.0) + 0.5) / rows);

#ifdef POLARIZED
    // Rotates from the image's frame, x along growing u, to the camera's, x = ray x up; both frames have z =
    // -ray.
    vec3 from = across > 0.0 ? vec3(-d.z, 0.0, d.x) / across : vec3(1.0, 0.0, 0.0);
    vec3 to = normalize(to_light * cross(ray, camera[1]));
    float c = dot(to, from);
    float s = dot(to, cross(-d, from));
    float cos2 = c * c - s * s;
    float sin2 = 2.0 * c * s;
    for (int i = 0; i < CHANNELS; ++i) {
        vec4 stokes = scale * textureLod(environment[i], texcoord, 0.0);
        SHOW(i, vec4(stokes.x, cos2 * stokes.y + sin2 * stokes.z, cos2 * stokes.z - sin2 * stokes.y, stokes.w));
    }
#else
    vec4 radiance = scale * textureLod(environment, texcoord, 0.0);
    for (int i = 0; i < CHANNELS; ++i) SHOW(i, vec4(radiance[i], 0.0, 0.0, 0.0));
#endif
}
