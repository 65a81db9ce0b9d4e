// SPDX-License-Identifier: MIT
// Texels of images around sixteen points.
#pragma once

#include <array>
#include <cstdint>

#include "simd/lanes.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {

/// Integers of sixteen points.
struct alignas(64) LaneIntegers {
    std::array<std::int32_t, kLanes> value;

    [[nodiscard]] std::int32_t& operator[](std::size_t i) { return value[i]; }
    [[nodiscard]] std::int32_t operator[](std::size_t i) const { return value[i]; }
};

/// Four texels of an image around each of sixteen points. Texel centres are at (i + 0.5) / size.
struct LaneTexels {
    LaneIntegers upper_left, upper_right, lower_left, lower_right;  ///< index: row times width plus column
    Lanes right, down;  ///< distance from the upper left texel, 0 to 1
};

/// Returns u and v after the transform, wrapped to 0 to 1.
[[nodiscard]] std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& uv, const UvTransform& transform,
                                           TextureSampling::Wrap wrap);

/// Returns first + j side + k step, wrapped to 0 to 1. The arguments are u and v after the transform.
[[nodiscard]] std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& first,
                                           const std::array<Lanes, 2>& side, int j,
                                           const std::array<Lanes, 2>& step, int k,
                                           TextureSampling::Wrap wrap);

/// Finds the four texels around points that wrapped() returned, in each point's level of a mipmap whose
/// finest level, 0, has width x height texels.
void find_texels(const std::array<Lanes, 2>& uv, int width, int height, const LaneIntegers& level,
                 TextureSampling::Wrap wrap, LaneTexels& out);

/// Finds the index of the texel that contains each point: row times width plus column.
void find_nearest(const std::array<Lanes, 2>& uv, int width, int height, LaneIntegers& out);

}  // namespace nicol
