// SPDX-License-Identifier: MIT
#include "specular/lane_lobe.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "simd/dispatch.hpp"
#include "simd/lane_angle.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Bilinear interpolation at sixteen directions: the first texel and the weights of the four texels.
struct Positions {
    alignas(64) std::array<std::int32_t, kLanes> first;
    Lanes weight[4];
};

struct Grid {
    const float* texels;
    std::int32_t rows;
    std::int32_t columns;
    std::int32_t layers;
};

// Returns the angle of (x, y) within a few roundings, 0 if both are 0.
[[gnu::always_inline]] inline float angle_of(float y, float x) {
    const float across = std::abs(x);
    const float along = std::abs(y);
    const bool steep = along > across;
    const float large = steep ? along : across;
    const float ratio = (steep ? across : along) / (large > 0 ? large : 1.0F);
    float angle = 0;
    arctangent_rest(ratio, angle);
    angle += ratio > kEighth ? kPi / 4 : 0.0F;
    angle = steep ? kPi / 2 - angle : angle;
    angle = x < 0 ? kPi - angle : angle;
    return y < 0 ? -angle : angle;
}

[[gnu::always_inline]] inline void find_texels(const Grid& grid, const LaneVectors& d, Positions& out) {
    const std::int32_t texel = 4 * grid.layers;
    const std::int32_t row = texel * (grid.columns + 1);
    const float across = static_cast<float>(grid.columns) / (2 * kPi);
    const float down = static_cast<float>(grid.rows - 1) / kPi;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = d.x.value[i];
        const float y = d.y.value[i];
        const float azimuth = angle_of(y, x);
        const float u = (azimuth < 0 ? azimuth + 2 * kPi : azimuth) * across;
        const float v = angle_of(std::sqrt(x * x + y * y), d.z.value[i]) * down;
        // The comparisons replace a NaN by 0, because they are false for it.
        auto left = static_cast<std::int32_t>(u > 0 ? u : 0.0F);
        auto top = static_cast<std::int32_t>(v > 0 ? v : 0.0F);
        left = left < grid.columns - 1 ? left : grid.columns - 1;
        top = top < grid.rows - 2 ? top : grid.rows - 2;
        const float a = u - static_cast<float>(left);
        const float b = v - static_cast<float>(top);
        out.first[i] = top * row + left * texel;
        out.weight[0].value[i] = (1 - a) * (1 - b);
        out.weight[1].value[i] = a * (1 - b);
        out.weight[2].value[i] = (1 - a) * b;
        out.weight[3].value[i] = a * b;
    }
}

using FourFloats [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(4)]] = float;

// Transposes four numbers of each lane, stored one lane after the other, to four vectors of sixteen lanes.
[[gnu::always_inline]] inline void spread_fours(const LaneVector* fours, LaneVector* out) {
    const LaneVector a =
        __builtin_shufflevector(fours[0], fours[1], 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
    const LaneVector b = __builtin_shufflevector(fours[0], fours[1], 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11,
                                                 15, 19, 23, 27, 31);
    const LaneVector c =
        __builtin_shufflevector(fours[2], fours[3], 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
    const LaneVector d = __builtin_shufflevector(fours[2], fours[3], 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11,
                                                 15, 19, 23, 27, 31);
    out[0] = __builtin_shufflevector(a, c, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    out[1] = __builtin_shufflevector(a, c, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    out[2] = __builtin_shufflevector(b, d, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    out[3] = __builtin_shufflevector(b, d, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
}

// Interpolates the numbers of Layers layers from `texels` on.
template <int Layers>
[[gnu::always_inline]] inline void fetch(const Grid& grid, const float* texels, const Positions& at,
                                         LaneVector (*out)[4]) {
    const std::int32_t texel = 4 * grid.layers;
    const std::int32_t row = texel * (grid.columns + 1);
    LaneVector fours[Layers][4];
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float* const t = texels + at.first[i];
        for (int layer = 0; layer < Layers; ++layer) {
            const auto corner = [&](std::int32_t offset) {
                return *reinterpret_cast<const FourFloats*>(t + offset + 4 * layer);
            };
            const FourFloats sum = at.weight[0].value[i] * corner(0) + at.weight[1].value[i] * corner(texel) +
                                   at.weight[2].value[i] * corner(row) +
                                   at.weight[3].value[i] * corner(row + texel);
            reinterpret_cast<FourFloats*>(fours[layer])[i] = sum;
        }
    }
    for (int layer = 0; layer < Layers; ++layer) spread_fours(fours[layer], out[layer]);
}

[[gnu::always_inline]] inline void sample_plain(const Grid& grid, const LaneVectors& d, Lanes* out) {
    Positions at;
    find_texels(grid, d, at);
    for (std::int32_t layer = 0; layer < grid.layers; ++layer) {
        LaneVector found[1][4];
        fetch<1>(grid, grid.texels + 4 * layer, at, found);
        for (const LaneVector& s0 : found[0]) store(out++, s0);
    }
}

// Computes s1 = (x T x - y T y) / 2 and s2 = x T y from the five elements of T.
[[gnu::always_inline]] inline void sample_polarized(const Grid& grid, const LaneVectors& d,
                                                    const LaneVectors& x, Lanes* out) {
    Positions at;
    find_texels(grid, d, at);
    LaneVector dx;
    LaneVector dy;
    LaneVector dz;
    LaneVector xx;
    LaneVector xy;
    LaneVector xz;
    load(&d.x, dx);
    load(&d.y, dy);
    load(&d.z, dz);
    load(&x.x, xx);
    load(&x.y, xy);
    load(&x.z, xz);
    const LaneVector yx = dy * xz - dz * xy;
    const LaneVector yy = dz * xx - dx * xz;
    const LaneVector yz = dx * xy - dy * xx;
    const LaneVector zz1 = xz * xz - yz * yz;
    const LaneVector zz2 = xz * yz;
    const LaneVector first[5] = {0.5F * (xx * xx - yx * yx - zz1), 0.5F * (xy * xy - yy * yy - zz1),
                                 xx * xy - yx * yy, xx * xz - yx * yz, xy * xz - yy * yz};
    const LaneVector second[5] = {xx * yx - zz2, xy * yy - zz2, xx * yy + xy * yx, xx * yz + xz * yx,
                                  xy * yz + xz * yy};
    for (std::int32_t layer = 0; layer < grid.layers; layer += 2) {
        LaneVector found[2][4];
        fetch<2>(grid, grid.texels + 4 * layer, at, found);
        const LaneVector tensor[5] = {found[0][2], found[0][3], found[1][0], found[1][1], found[1][2]};
        LaneVector s1{};
        LaneVector s2{};
        for (int k = 0; k < 5; ++k) {
            s1 += first[k] * tensor[k];
            s2 += second[k] * tensor[k];
        }
        store(out++, found[0][0]);
        store(out++, s1);
        store(out++, s2);
        store(out++, found[0][1]);
    }
}

}  // namespace

void sample_lobe(const LobeMap& map, const LaneVectors& direction, const LaneVectors& x, Lanes* out) {
    const Grid grid{
        .texels = map.texels().data(), .rows = map.rows(), .columns = map.columns(), .layers = map.layers()};
    if (map.polarized()) {
        dispatch<sample_polarized>(grid, direction, x, out);
    } else {
        dispatch<sample_plain>(grid, direction, out);
    }
}

}  // namespace nicol
