// SPDX-License-Identifier: MIT
// Mipmap taps that cover the footprint of a pixel; see src/texture/footprint.hpp.

// Taps in one or two rows of `count` places each: first, first + step, ..., and again from first + side.
struct FootprintTaps {
    vec2 first;
    vec2 step;
    vec2 side;
    int count;
    int rows;
    uint level;
    float fraction;  // weight of the next level
};

// Limits a vector in texels, so that squares of squares are finite. A NaN becomes the lower limit.
vec2 limited(vec2 texels) {
    const vec2 most = vec2(1e9);
    return mix(-most, min(texels, most), greaterThan(texels, -most));
}

// Returns the taps. across, down: change of uv to the next pixel. size: size of the finest level, texels.
FootprintTaps footprint_taps(vec2 uv, vec2 across, vec2 down, vec2 size, uint last_level) {
    across = limited(size * across);
    down = limited(size * down);

    // Squared axes of the ellipse: middle + radius and middle - radius.
    vec2 squares = across * across + down * down;
    float xy = across.x * across.y + down.x * down.y;
    float middle = 0.5 * (squares.x + squares.y);
    float half_difference = 0.5 * (squares.x - squares.y);
    float radius = sqrt(half_difference * half_difference + xy * xy);
    float longer = middle + radius;
    float area = across.x * down.y - across.y * down.x;
    const float most = 16.0;
    float shorter = max(longer > 0.0 ? area * area / longer : 0.0, longer / (most * most));

    FootprintTaps taps;
    const float most_of_two = most / 2.0;
    taps.rows = longer > most_of_two * most_of_two * shorter || shorter < 0.125 ? 1 : 2;
    float part = taps.rows == 1 ? 1.0 : 0.25;
    float width = part * shorter;
    taps.count = max(int(sqrt(longer / max(width, 0.25)) + 0.5), taps.rows);
    taps.first = uv;
    taps.step = vec2(0.0);
    taps.side = vec2(0.0);
    if (taps.count > 1) {
        // Both (radius + half, xy) and (xy, radius - half) are along the longer axis. One of them may vanish;
        // if both vanish, any direction is valid.
        float count = float(taps.count);
        float sum = radius + abs(half_difference);
        vec2 along = half_difference > 0.0 ? vec2(sum, xy) : vec2(xy, sum);
        along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
        taps.step = along * sqrt(max(longer - width, 0.0) / (count * count - 1.0)) / size;
        if (taps.rows == 2) taps.side = vec2(-along.y, along.x) * sqrt(width) / size;
        taps.first -= 0.5 * (count - 1.0) * taps.step + 0.5 * taps.side;
    }

    float squared = max(0.875 + 0.5 * (taps.count > taps.rows ? width : part * middle), 1.0);
    squared = min(squared, uintBitsToFloat((127u + 2u * last_level) << 23));
    taps.level = ((floatBitsToUint(squared) >> 23) - 127u) >> 1;
    float mantissa = squared * uintBitsToFloat((127u - 2u * taps.level) << 23);
    taps.fraction = 2.0 * (mantissa - 1.0) / (mantissa + 2.0);
    return taps;
}
