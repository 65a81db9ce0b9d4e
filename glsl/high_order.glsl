// SPDX-License-Identifier: MIT
// Reflection of high orders of light, from filtered maps near the mirrored view direction.

// A stage that includes this file defines CHANNELS, 1 to 4, and HIGH_ORDER_POLARIZED if the maps are of
// polarized light. Maps are textures with these channels' layers of a LobeMap, one below the other. The
// factors are a texture of HighOrderFactors::texels(). This file interpolates all textures itself, because
// samplers have few bits for it.

#ifdef HIGH_ORDER_POLARIZED
const int HIGH_ORDER_LAYERS = 2 * CHANNELS;
const int HIGH_ORDER_ELEMENTS = 42;  // elements of a pairing
#else
const int HIGH_ORDER_LAYERS = 1;
const int HIGH_ORDER_ELEMENTS = 12;
#endif

#include "angle.glsl"
#include "frames.glsl"

// The four texels of a map nearest to a direction.
struct HighOrderSpot {
    ivec2 low;
    ivec2 high;
    vec2 part;
    int rows;
};

HighOrderSpot high_order_spot(sampler2D map, vec3 direction) {
    ivec2 size = textureSize(map, 0);
    HighOrderSpot at;
    at.rows = size.y / HIGH_ORDER_LAYERS;
    float across = length(direction.xy);
    float fraction = angle_of(direction.y, direction.x) / (2.0 * PI);
    vec2 place = vec2((fraction < 0.0 ? fraction + 1.0 : fraction) * float(size.x),
                      angle_of(across, direction.z) / PI * float(at.rows - 1));
    at.low = min(ivec2(place), ivec2(size.x - 1, at.rows - 2));
    at.part = place - vec2(at.low);
    at.high = ivec2(at.low.x + 1 == size.x ? 0 : at.low.x + 1, at.low.y + 1);
    return at;
}

vec4 high_order_texel(sampler2D map, HighOrderSpot at, int layer) {
    int first = layer * at.rows;
    vec4 top = mix(texelFetch(map, ivec2(at.low.x, first + at.low.y), 0),
                   texelFetch(map, ivec2(at.high.x, first + at.low.y), 0), at.part.x);
    vec4 bottom = mix(texelFetch(map, ivec2(at.low.x, first + at.high.y), 0),
                      texelFetch(map, ivec2(at.high.x, first + at.high.y), 0), at.part.x);
    return mix(top, bottom, at.part.y);
}

// Position of an angle in the factors.
struct HighOrderAngle {
    int index;
    float part;
};

HighOrderAngle high_order_angle(sampler2D factors, float cosine) {
    int last = textureSize(factors, 0).x - 1;
    float x = clamp(cosine, 0.0, 1.0) * float(last);
    int index = min(int(x), last - 1);
    return HighOrderAngle(index, x - float(index));
}

// Returns an element of all channels.
vec4 high_order_factor(sampler2D factors, HighOrderAngle at, int element) {
    return mix(texelFetch(factors, ivec2(at.index, element), 0), texelFetch(factors, ivec2(at.index + 1, element), 0),
               at.part);
}

// Returns the directions of the outer taps: up, down, right, left.
vec3[4] high_order_outer(vec3 d, vec3 x, float spread) {
    vec3 y = cross(d, x);
    float c = cos(spread);
    float s = sin(spread);
    return vec3[4](c * d + s * y, c * d - s * y, c * d + s * x, c * d - s * x);
}

#ifdef HIGH_ORDER_POLARIZED
// Returns the Stokes vector of a channel in the frame with these x and y.
vec4 high_order_stokes(sampler2D map, HighOrderSpot at, int channel, vec3 x, vec3 y) {
    vec4 p = high_order_texel(map, at, 2 * channel);
    vec4 q = high_order_texel(map, at, 2 * channel + 1);
    mat3 tensor = mat3(p.z, q.x, q.y, q.x, p.w, q.z, q.y, q.z, -p.z - p.w);
    vec3 ty = tensor * y;
    return vec4(p.x, 0.5 * (dot(x, tensor * x) - dot(y, ty)), dot(x, ty), p.y);
}

// Computes the reflection of one pairing, whose elements begin at `first`. d, x and normal are in the light's
// axes; the result is in the frame with x along the s-axis.
void high_order_of_pairing(int first, vec3 d, vec3 x, vec3 normal, float cosine, float spread, vec2 visible,
                           sampler2D factors, sampler2D central, sampler2D outer, sampler2D base,
                           out vec4 stokes[CHANNELS]) {
    HighOrderAngle angle = high_order_angle(factors, cosine);
    vec4 difference[CHANNELS];
    for (int i = 0; i < CHANNELS; ++i) stokes[i] = difference[i] = vec4(0.0);
    vec3 taps[4] = high_order_outer(d, x, spread);
    for (int k = 0; k < (spread > 0.0 ? 5 : 1); ++k) {
        vec3 direction = k == 0 ? d : taps[max(k - 1, 0)];
        vec3 axis = k < 3 ? x : cross(cross(d, x), direction);
        vec3 across = cross(direction, axis);
        HighOrderSpot at;
        if (k == 0)
            at = high_order_spot(central, direction);
        else
            at = high_order_spot(outer, direction);
        int tap = min(k, 3);
        vec4 f[8];
        for (int e = 0; e < 2; ++e) f[e] = high_order_factor(factors, angle, first + 2 * tap + e);
        for (int e = 0; e < 6; ++e) f[2 + e] = high_order_factor(factors, angle, first + 12 + 6 * tap + e);
        for (int i = 0; i < CHANNELS; ++i) {
            vec4 s;
            if (k == 0)
                s = high_order_stokes(central, at, i, axis, across);
            else
                s = high_order_stokes(outer, at, i, axis, across);
            stokes[i] += vec4(f[0][i] * s.x + f[2][i] * s.y, f[1][i] * s.x + f[3][i] * s.y,
                              f[4][i] * s.z + f[6][i] * s.w, f[5][i] * s.z + f[7][i] * s.w);
            if (k == 3) difference[i] = s;
            if (k == 4) difference[i] -= s;
        }
    }
    if (spread > 0.0) {
        vec4 f[8];
        for (int e = 0; e < 2; ++e) f[e] = high_order_factor(factors, angle, first + 8 + e);
        for (int e = 0; e < 6; ++e) f[2 + e] = high_order_factor(factors, angle, first + 36 + e);
        for (int i = 0; i < CHANNELS; ++i) {
            vec4 s = difference[i];
            stokes[i] += vec4(f[2][i] * s.z + f[6][i] * s.w, f[3][i] * s.z + f[7][i] * s.w,
                              f[0][i] * s.x + f[4][i] * s.y, f[1][i] * s.x + f[5][i] * s.y);
        }
    }
    for (int i = 0; i < CHANNELS; ++i) stokes[i] *= visible.x;
    if (visible.y > 0.0) {
        HighOrderSpot at = high_order_spot(base, -normal);
        vec4 to_s0 = visible.y * high_order_factor(factors, angle, first + 10);
        vec4 to_s1 = visible.y * high_order_factor(factors, angle, first + 11);
        for (int i = 0; i < CHANNELS; ++i)
            stokes[i].xy += high_order_texel(base, at, 2 * i).x * vec2(to_s0[i], to_s1[i]);
    }
}
#else
// Computes the reflection of one pairing. The components of light and factors are channels.
void high_order_of_pairing(int first, vec3 d, vec3 x, vec3 normal, float cosine, float spread, vec2 visible,
                           sampler2D factors, sampler2D central, sampler2D outer, sampler2D base,
                           out vec4 stokes[CHANNELS]) {
    HighOrderAngle angle = high_order_angle(factors, cosine);
    vec4 light = high_order_texel(central, high_order_spot(central, d), 0);
    vec4 s0 = light * high_order_factor(factors, angle, first + 0);
    vec4 s1 = light * high_order_factor(factors, angle, first + 1);
    vec4 s2 = vec4(0.0);
    vec4 s3 = vec4(0.0);
    if (spread > 0.0) {
        vec3 taps[4] = high_order_outer(d, x, spread);
        vec4 s[4];
        for (int k = 0; k < 4; ++k) s[k] = high_order_texel(outer, high_order_spot(outer, taps[k]), 0);
        vec4 sum = s[2] + s[3];
        vec4 difference = s[2] - s[3];
        s0 += s[0] * high_order_factor(factors, angle, first + 2) + s[1] * high_order_factor(factors, angle, first + 4) +
              sum * high_order_factor(factors, angle, first + 6);
        s1 += s[0] * high_order_factor(factors, angle, first + 3) + s[1] * high_order_factor(factors, angle, first + 5) +
              sum * high_order_factor(factors, angle, first + 7);
        s2 = difference * high_order_factor(factors, angle, first + 8);
        s3 = difference * high_order_factor(factors, angle, first + 9);
    }
    for (int i = 0; i < CHANNELS; ++i) stokes[i] = visible.x * vec4(s0[i], s1[i], s2[i], s3[i]);
    if (visible.y > 0.0) {
        light = visible.y * high_order_texel(base, high_order_spot(base, -normal), 0);
        s0 = light * high_order_factor(factors, angle, first + 10);
        s1 = light * high_order_factor(factors, angle, first + 11);
        for (int i = 0; i < CHANNELS; ++i) stokes[i].xy += vec2(s0[i], s1[i]);
    }
}
#endif

// Computes the reflection of all pairings; (s0, s1) and (s2, s3) of the second pairing change places.
void high_order_in_s_frame(vec3 d, vec3 x, vec3 normal, float cosine, float spread, vec2 visible, sampler2D factors,
                           sampler2D central, sampler2D outer, sampler2D base, out vec4 stokes[CHANNELS]) {
    high_order_of_pairing(0, d, x, normal, cosine, spread, visible, factors, central, outer, base, stokes);
    if (textureSize(factors, 0).y == HIGH_ORDER_ELEMENTS) return;
    vec4 second[CHANNELS];
    high_order_of_pairing(HIGH_ORDER_ELEMENTS, d, x, normal, cosine, spread, visible, factors, central, outer, base,
                          second);
    for (int i = 0; i < CHANNELS; ++i) stokes[i] += second[i].zwxy;
}

// Computes a surface's reflection of the light's high orders, in the frame with x along `camera_x`, a unit
// vector orthogonal to `view`. normal and view (the propagation direction of the reflected light) are unit
// vectors in the world. to_light rotates the world's axes into the maps'. spread: HighOrderFactors::spread();
// `outer` is not used if it is 0. visible: visible fractions of the lobe about the mirror direction, and of
// the hemisphere about the normal; `base` is not used if the latter is 0.
void high_order(vec3 normal, vec3 view, vec3 camera_x, mat3 to_light, float spread, vec2 visible, sampler2D factors,
                sampler2D central, sampler2D outer, sampler2D base, out vec4 stokes[CHANNELS]) {
    // A normal that faces away is treated as viewed at 90 degrees. The plane of incidence is arbitrary if the
    // view is along the normal.
    vec3 facing = facing_view(normal, view, camera_x);
    vec3 x = cross(normal, facing);
    x = dot(x, x) > 1e-10 ? normalize(x) : camera_x;
    high_order_in_s_frame(to_light * reflect(facing, normal), to_light * x, to_light * normal, dot(normal, view), spread,
                          visible, factors, central, outer, base, stokes);
    vec2 rotation = double_angle(vec2(dot(camera_x, x), dot(camera_x, cross(view, x))));
    for (int i = 0; i < CHANNELS; ++i) stokes[i] = in_rotated_frame(stokes[i], rotation);
}
