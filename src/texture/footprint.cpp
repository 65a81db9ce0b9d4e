// SPDX-License-Identifier: MIT
#include "texture/footprint.hpp"

#include <cstdint>
#include <type_traits>

#include "polarization/view_geometry.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Look-ups of one point (single numbers) or of several (the compiler's own vectors).
template <class Number, class Integer>
struct FoundTaps {
    Number first[2], step[2], side[2], fraction;
    Integer count, rows, level;
};

template <class From, class To>
[[gnu::always_inline]] inline void convert(const From& from, To& to) {
    if constexpr (std::is_arithmetic_v<From>)
        to = static_cast<To>(from);
    else
        to = __builtin_convertvector(from, To);
}

// Limits coordinates in texels so that their fourth powers are finite. Not-a-number becomes the lower end.
template <class Number>
[[gnu::always_inline]] inline void limit(Number& texels) {
    const Number most = Number{} + 1e9F;
    texels = texels > -most ? texels : -most;
    texels = texels < most ? texels : most;
}

template <class Number, class Integer>
[[gnu::always_inline]] inline void find_taps(const Number (&uv)[2], const Number (&du)[2],
                                             const Number (&dv)[2], const MipmapShape& shape,
                                             FoundTaps<Number, Integer>& out) {
    const Number zero{}, one = zero + 1.0F;
    const float size[2] = {static_cast<float>(shape.width), static_cast<float>(shape.height)};
    Number across[2], down[2];
    for (glm::length_t k = 0; k < 2; ++k) {
        const float by_u = shape.to_uv.linear[0][k], by_v = shape.to_uv.linear[1][k];
        out.first[k] = by_u * uv[0] + by_v * uv[1] + shape.to_uv.offset[k];
        across[k] = size[k] * (by_u * du[0] + by_v * du[1]);
        down[k] = size[k] * (by_u * dv[0] + by_v * dv[1]);
        limit(across[k]);
        limit(down[k]);
    }

    // Squared axes of the ellipse: middle + radius and middle - radius.
    const Number xx = across[0] * across[0] + down[0] * down[0];
    const Number yy = across[1] * across[1] + down[1] * down[1];
    const Number xy = across[0] * across[1] + down[0] * down[1];
    const Number middle = 0.5F * (xx + yy), half = 0.5F * (xx - yy);
    Number radius = half * half + xy * xy;
    square_root(radius);
    const Number longer = middle + radius;
    const Number area = across[0] * down[1] - across[1] * down[0];
    Number shorter = longer > 0 ? area * area / longer : zero;
    constexpr float most = 16;
    const Number least = longer * (1 / (most * most));
    shorter = shorter > least ? shorter : least;

    constexpr float most_of_two = most / 2;
    const Number single = ((longer > most_of_two * most_of_two * shorter) | (shorter < 0.125F)) ? one : zero;
    const Number rows = 2.0F - single, part = 0.25F + 0.75F * single;
    const Number width = part * shorter;
    convert(rows, out.rows);

    Number count = longer / (width > 0.25F ? width : zero + 0.25F);
    square_root(count);
    count += 0.5F;
    count = count > rows ? count : rows;
    convert(count, out.count);
    convert(out.count, count);

    // The longer axis has the direction (radius + half, xy), and also (xy, radius - half). One of the two may
    // vanish. If both vanish, any direction will do.
    const Number sum = radius + (half > 0 ? half : -half);
    const Number along[2] = {half > 0 ? sum : xy, half > 0 ? xy : sum};
    Number inverse = along[0] * along[0] + along[1] * along[1];
    square_root(inverse);
    inverse = inverse > 0 ? 1.0F / inverse : zero;
    const Number axis[2] = {inverse > 0 ? along[0] * inverse : one, along[1] * inverse};
    Number step = (longer - width) / (count * count - 1.0F), side = width;
    step = step > 0 ? step : zero;
    square_root(step);
    square_root(side);
    step = count > one ? step : zero;
    side = rows > one ? side : zero;
    for (std::size_t k = 0; k < 2; ++k) {
        out.step[k] = step * axis[k] * (1 / size[k]);
        out.side[k] = (k == 0 ? -side : side) * axis[1 - k] * (1 / size[k]);
        out.first[k] -= 0.5F * (count - 1.0F) * out.step[k] + 0.5F * out.side[k];
    }

    // The squared width's logarithm to base four: powers of four come from the exponent, the rest from the
    // mantissa. For a mantissa m of 1 to 4, log2(m) / 2 is 2 (m - 1) / (m + 2) within 0.008.
    Number squared = 0.875F + 0.5F * (count > rows ? width : part * middle);
    squared = squared > one ? squared : one;
    const Number last = zero + static_cast<float>(std::int64_t{1} << (2 * shape.last_level));
    squared = squared < last ? squared : last;
    const Integer exponent = (__builtin_bit_cast(Integer, squared) >> 23) - 127;
    out.level = exponent >> 1;
    const Integer scale = (127 - 2 * out.level) << 23;
    const Number mantissa = squared * __builtin_bit_cast(Number, scale);
    out.fraction = 2.0F * (mantissa - 1.0F) / (mantissa + 2.0F);
}

using Number [[gnu::vector_size(64)]] = float;
using Integer [[gnu::vector_size(64)]] = std::int32_t;

[[gnu::always_inline]] inline void load_all(const std::array<Lanes, 2>& from, Number (&to)[2]) {
    for (std::size_t k = 0; k < 2; ++k) to[k] = *reinterpret_cast<const LaneVector*>(&from[k]);
}

[[gnu::always_inline]] inline void find_lane_taps(const TexturePoints& points, const MipmapShape& shape,
                                                  LaneFootprintTaps& out) {
    Number uv[2], du[2], dv[2];
    load_all(points.uv, uv);
    load_all(points.du, du);
    load_all(points.dv, dv);
    FoundTaps<Number, Integer> taps;
    find_taps(uv, du, dv, shape, taps);
    for (std::size_t k = 0; k < 2; ++k) {
        store(&out.first[k], taps.first[k]);
        store(&out.step[k], taps.step[k]);
        store(&out.side[k], taps.side[k]);
    }
    store(&out.fraction, taps.fraction);
    *reinterpret_cast<IntVector*>(&out.count) = taps.count;
    *reinterpret_cast<IntVector*>(&out.rows) = taps.rows;
    *reinterpret_cast<IntVector*>(&out.level) = taps.level;
}

}  // namespace

FootprintTaps footprint_taps(const TexturePoint& point, const MipmapShape& shape) {
    const float uv[2] = {point.uv.x, point.uv.y}, du[2] = {point.du.x, point.du.y},
                dv[2] = {point.dv.x, point.dv.y};
    FoundTaps<float, std::int32_t> taps;
    find_taps(uv, du, dv, shape, taps);
    return {.first = {taps.first[0], taps.first[1]},
            .step = {taps.step[0], taps.step[1]},
            .side = {taps.side[0], taps.side[1]},
            .count = taps.count,
            .rows = taps.rows,
            .level = taps.level,
            .fraction = taps.fraction};
}

void footprint_taps(const TexturePoints& points, const MipmapShape& shape, LaneFootprintTaps& out) {
    dispatch<find_lane_taps>(points, shape, out);
}

}  // namespace nicol
