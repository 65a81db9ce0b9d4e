// SPDX-License-Identifier: MIT
// Textures, evaluated as in src/material, from words and texels in the layout of DeviceVariation.
#include "footprint.glsl"

// TABLE, TEXELS: bindings. TEXTURES: number of textures, at least 2, for evaluate_textures().
layout(std430, binding = TABLE) readonly buffer Table { uint table[]; };
layout(std430, binding = TEXELS) readonly buffer Texels { float texels[]; };

// Words of a texture: kind, channels, filter, wrap, levels, word of the first level, to_uv by columns, two
// colours or (for a product) the numbers of two earlier textures. Words of a level: first texel, width,
// height.
const uint TEXTURE_WORDS = 24u;
const uint LEVEL_WORDS = 3u;
const uint KIND_CONSTANT = 0u;
const uint KIND_IMAGE = 1u;
const uint KIND_CHECKERBOARD = 2u;
const uint KIND_PRODUCT = 4u;
const uint FILTER_NEAREST = 0u;
const uint FILTER_MIPMAP = 2u;
const uint WRAP_REPEAT = 0u;
const uint WRAP_MIRROR = 1u;

// Point at which textures are evaluated; see TexturePoint.
struct TexturePoint {
    vec2 uv;
    vec2 du;
    vec2 dv;
    vec3 color;
};

float number_at(uint word) { return uintBitsToFloat(table[word]); }

vec4 color_at(uint word) {
    return vec4(number_at(word), number_at(word + 1u), number_at(word + 2u), number_at(word + 3u));
}

mat2 linear_of(uint texture) {
    return mat2(number_at(texture + 6u), number_at(texture + 7u), number_at(texture + 8u), number_at(texture + 9u));
}

vec2 transformed(uint texture, vec2 uv) {
    return linear_of(texture) * uv + vec2(number_at(texture + 10u), number_at(texture + 11u));
}

// Limits x to a range that int can represent. A NaN becomes the lower limit.
float within_int(float x) {
    const float most = 1073741824.0;
    return x > -most ? min(x, most) : -most;
}

vec2 within_int(vec2 v) { return vec2(within_int(v.x), within_int(v.y)); }

float wrapped(uint wrap, float t) {
    if (wrap != WRAP_REPEAT && wrap != WRAP_MIRROR) return t > 0.0 ? min(t, 1.0) : 0.0;
    float within = within_int(t);
    if (wrap == WRAP_REPEAT) return within - floor(within);
    float of_two = within - 2.0 * floor(0.5 * within);
    return min(of_two, 2.0 - of_two);
}

ivec2 neighbours(uint wrap, int i, int size) {
    if (wrap == WRAP_REPEAT) return ivec2(i < 0 ? size - 1 : i, i + 1 == size ? 0 : i + 1);
    return ivec2(max(i, 0), min(i + 1, size - 1));
}

vec4 texel_at(uint first, uint channels, int index) {
    uint at = first + channels * uint(index);
    if (channels == 1u) return vec4(vec3(texels[at]), 1.0);
    return vec4(texels[at], texels[at + 1u], texels[at + 2u], channels == 4u ? texels[at + 3u] : 1.0);
}

// The four texels around a point and the position between them; centres are at (i + 0.5) / size.
struct Cell {
    vec2 size;
    vec2 at;
    vec4 a, b, c, d;
};

Cell cell_of(uint texture, uint level, vec2 uv) {
    uint entry = table[texture + 5u] + LEVEL_WORDS * level;
    uint first = table[entry];
    uint channels = table[texture + 1u];
    ivec2 size = ivec2(table[entry + 1u], table[entry + 2u]);
    vec2 texel = uv * vec2(size) - 0.5;
    vec2 low = floor(texel);
    ivec2 x = neighbours(table[texture + 3u], int(low.x), size.x);
    ivec2 y = neighbours(table[texture + 3u], int(low.y), size.y);
    return Cell(vec2(size), texel - low, texel_at(first, channels, y.x * size.x + x.x),
                texel_at(first, channels, y.x * size.x + x.y), texel_at(first, channels, y.y * size.x + x.x),
                texel_at(first, channels, y.y * size.x + x.y));
}

vec4 value_of(Cell cell) { return mix(mix(cell.a, cell.b, cell.at.x), mix(cell.c, cell.d, cell.at.x), cell.at.y); }

// Returns the gradient of the first channel by u and v.
vec2 gradient_of(Cell cell) {
    return cell.size * vec2(mix(cell.b.x - cell.a.x, cell.d.x - cell.c.x, cell.at.y),
                            mix(cell.c.x - cell.a.x, cell.d.x - cell.b.x, cell.at.x));
}

FootprintTaps taps_of(uint texture, TexturePoint point) {
    uint entry = table[texture + 5u];
    mat2 linear = linear_of(texture);
    return footprint_taps(transformed(texture, point.uv), linear * point.du, linear * point.dv,
                          vec2(table[entry + 1u], table[entry + 2u]), table[texture + 4u] - 1u);
}

vec2 within_image(uint texture, vec2 uv) {
    return vec2(wrapped(table[texture + 3u], uv.x), wrapped(table[texture + 3u], uv.y));
}

vec4 image_at(uint texture, TexturePoint point) {
    vec2 uv = within_image(texture, transformed(texture, point.uv));
    uint filtering = table[texture + 2u];
    if (filtering == FILTER_NEAREST) {
        uint entry = table[texture + 5u];
        ivec2 size = ivec2(table[entry + 1u], table[entry + 2u]);
        ivec2 at = min(ivec2(uv * vec2(size)), size - 1);
        return texel_at(table[entry], table[texture + 1u], at.y * size.x + at.x);
    }
    if (filtering != FILTER_MIPMAP) return value_of(cell_of(texture, 0u, uv));
    FootprintTaps taps = taps_of(texture, point);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < taps.rows; ++j)
        for (int k = 0; k < taps.count; ++k) {
            uv = within_image(texture, taps.first + float(j) * taps.side + float(k) * taps.step);
            vec4 value = value_of(cell_of(texture, taps.level, uv));
            if (taps.fraction > 0.0) value = mix(value, value_of(cell_of(texture, taps.level + 1u, uv)), taps.fraction);
            sum += value;
        }
    return sum / float(taps.rows * taps.count);
}

// Returns the gradient of the first channel by u and v, after the transform.
vec2 slope_of(uint texture, uint level, vec2 at) {
    vec2 slope = gradient_of(cell_of(texture, level, within_image(texture, at)));
    if (table[texture + 3u] != WRAP_MIRROR) return slope;
    vec2 even = floor(vec2(within_int(at.x), within_int(at.y)));
    return slope * (1.0 - 2.0 * (even - 2.0 * floor(0.5 * even)));
}

// Returns the gradient of the first channel by u and v for an image; 0 for other textures.
vec2 texture_gradient(uint texture, TexturePoint point) {
    if (table[texture] != KIND_IMAGE) return vec2(0.0);
    mat2 linear = linear_of(texture);
    if (table[texture + 2u] != FILTER_MIPMAP) return slope_of(texture, 0u, transformed(texture, point.uv)) * linear;
    FootprintTaps taps = taps_of(texture, point);
    vec2 sum = vec2(0.0);
    for (int j = 0; j < taps.rows; ++j)
        for (int k = 0; k < taps.count; ++k) {
            vec2 at = taps.first + float(j) * taps.side + float(k) * taps.step;
            vec2 slope = slope_of(texture, taps.level, at);
            if (taps.fraction > 0.0) slope = mix(slope, slope_of(texture, taps.level + 1u, at), taps.fraction);
            sum += slope;
        }
    return sum / float(taps.rows * taps.count) * linear;
}

// Returns the mean, over an interval, of a wave that is 1 from 0 to 1 and -1 from 1 to 2, and so on.
float mean_of_wave(float middle, float width) {
    float within = middle - 2.0 * floor(0.5 * middle);
    if (!(width >= 1e-4)) return within < 1.0 ? 1.0 : -1.0;
    vec2 ends = within + vec2(0.5, -0.5) * width;
    ends -= 2.0 * floor(0.5 * ends);
    ends = mix(ends, 2.0 - ends, step(1.0, ends));  // integral from 0
    return (ends.x - ends.y) / width;
}

// Returns the mean over a point's footprint; see Checkerboard.
vec4 checkerboard_at(uint texture, TexturePoint point) {
    const int parts = 4;
    mat2 linear = linear_of(texture);
    vec2 at = within_int(2.0 * transformed(texture, point.uv));
    vec2 right = within_int(2.0 / float(parts) * (linear * point.du));
    vec2 down = within_int(2.0 / float(parts) * (linear * point.dv));
    vec2 size = abs(right) + abs(down);
    float sum = 0.0;
    for (int i = 0; i < parts; ++i)
        for (int k = 0; k < parts; ++k) {
            vec2 middle = at + (float(i) - 0.5 * float(parts - 1)) * right + (float(k) - 0.5 * float(parts - 1)) * down;
            sum += mean_of_wave(middle.x, size.x) * mean_of_wave(middle.y, size.y);
        }
    return mix(color_at(texture + 12u), color_at(texture + 16u), 0.5 - 0.5 * sum / float(parts * parts));
}

// Returns the value of a texture that is no product. texture: its first word.
vec4 texture_at(uint texture, TexturePoint point) {
    uint kind = table[texture];
    if (kind == KIND_CONSTANT) return color_at(texture + 12u);
    if (kind == KIND_IMAGE) return image_at(texture, point);
    if (kind == KIND_CHECKERBOARD) return checkerboard_at(texture, point);
    return vec4(point.color, 1.0);
}

#ifdef TEXTURES
// Computes values[t] of the textures whose words begin at `first`.
void evaluate_textures(uint first, TexturePoint point, out vec4 values[TEXTURES]) {
    for (int t = 0; t < TEXTURES; ++t) {
        uint texture = first + TEXTURE_WORDS * uint(t);
        if (table[texture] == KIND_PRODUCT) {
            values[t] = values[table[texture + 12u]] * values[table[texture + 13u]];
        } else {
            values[t] = texture_at(texture, point);
        }
    }
}
#endif
