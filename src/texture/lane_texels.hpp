// SPDX-License-Identifier: MIT
// The texels of images that sixteen points lie between.
#pragma once

#include <array>
#include <cstdint>

#include "simd/lanes.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {

/// A whole number of each of sixteen points.
struct alignas(64) LaneIntegers {
    std::array<std::int32_t, kLanes> value;

    [[nodiscard]] std::int32_t& operator[](std::size_t i) { return value[i]; }
    [[nodiscard]] std::int32_t operator[](std::size_t i) const { return value[i]; }
};

/// Of an image. Texel centres are at (i + 0.5) / size.
struct LaneTexels {
    LaneIntegers upper_left, upper_right, lower_left, lower_right;  ///< row times width plus column
    Lanes right, down;                                              ///< how far from the upper left, 0 to 1
};

/// u or v after the transform, within 0 and 1.
[[nodiscard]] std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& uv, const UvTransform& transform,
                                           TextureSampling::Wrap wrap);

/// first + j side + k step, of u or v after the transform, within 0 and 1.
[[nodiscard]] std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& first,
                                           const std::array<Lanes, 2>& side, int j,
                                           const std::array<Lanes, 2>& step, int k,
                                           TextureSampling::Wrap wrap);

/// Of what wrapped() returns, in each point's level of a mipmap whose finest one, 0, has this many texels.
void find_texels(const std::array<Lanes, 2>& uv, int width, int height, const LaneIntegers& level,
                 TextureSampling::Wrap wrap, LaneTexels& out);

/// The texel that holds each point: row times width plus column.
void find_nearest(const std::array<Lanes, 2>& uv, int width, int height, LaneIntegers& out);

}  // namespace nicol
