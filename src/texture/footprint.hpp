// SPDX-License-Identifier: MIT
// Look-ups of a mipmap that average a texture over the footprint of a pixel.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "simd/lanes.hpp"
#include "texture/lane_texels.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {

/// Look-ups of one footprint. The texture's value is the mean over one or two parallel rows of points: first,
/// first + step, ..., and again from first + side. The more the footprint is stretched, the more points a row
/// has. Coordinates are after the transform and before wrapping.
///
/// The footprint is the parallelogram of du and dv. An ellipse has equal second moments if its axes, in
/// texels, have the squared lengths l1 >= l2 that are the eigenvalues of du du^T + dv dv^T. Rows run along
/// the longer axis. n points at a distance d, each with a width of w, have equal second moments if (n^2 - 1)
/// d^2 = l1 - w^2. One row has w^2 = l2; two rows have w^2 = l2 / 4 and a distance of w between them.
///
/// The texels of level L are 2^L wide. 4^(level + fraction) is 7/8 + w^2 / 2, or 7/8 + (l1 + l2) / 4 / rows^2
/// if count equals rows, and at least 1. This choice has the smallest error, on average over widths and
/// images, against a reference: the mean over the footprint of the finest level, interpolated bilinearly. The
/// error of two rows is a third of the error of one row.
struct FootprintTaps {
    glm::vec2 first, step, side;
    /// Points in each row: the length of the longer axis divided by the larger of w and half a texel,
    /// approximately; at least as many as rows, at most 16.
    int count;
    int rows;        ///< 1 if the footprint is below 0.35 texels, or eight times as long as wide; else 2
    int level;       ///< level of the mipmap; 0 is the finest
    float fraction;  ///< weight of the next level, 0 to 1; 0 at the last level
};

/// FootprintTaps of sixteen points.
struct LaneFootprintTaps {
    std::array<Lanes, 2> first, step, side;
    LaneIntegers count, rows, level;
    Lanes fraction;
};

/// Size and transform of the mipmap in which points are looked up. The finest level has width x height
/// texels.
struct MipmapShape {
    int width, height;
    int last_level;
    UvTransform to_uv;
};

/// Returns the look-ups of a point's footprint. Points and level are finite for every footprint, including a
/// footprint that is not finite.
[[nodiscard]] FootprintTaps footprint_taps(const TexturePoint& point, const MipmapShape& shape);
void footprint_taps(const TexturePoints& points, const MipmapShape& shape, LaneFootprintTaps& out);

}  // namespace nicol
