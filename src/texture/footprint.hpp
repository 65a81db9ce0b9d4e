// SPDX-License-Identifier: MIT
// Where a mipmap is looked up to show what a pixel covers.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "simd/lanes.hpp"
#include "texture/lane_texels.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {

/// A mipmap's look-ups are averaged over one or two rows of places side by side, as many as the footprint is
/// stretched: at first, first + step, ..., and again from first + side. These are coordinates after the
/// transform, before wrapping.
///
/// The footprint is the parallelogram of du and dv. An ellipse has the same second moments if its axes, in
/// texels, have the squared lengths l1 >= l2 that are the eigenvalues of du du^T + dv dv^T. Rows run along
/// the longer axis. n places at a distance d, with a width of w all around each, have the second moments
/// again where (n^2 - 1) d^2 = l1 - w^2. One row has w^2 = l2; two rows w^2 = l2 / 4, at a distance of w.
///
/// The texels of level L are 2^L wide. 4^(level + fraction) is 7/8 + w^2 / 2, or, with as many places as
/// rows, 7/8 + (l1 + l2) / 4 / rows^2, at least 1: what, on average over widths and images, errs least
/// against the mean over the footprint of the finest level, which the truth interpolates bilinearly as well.
/// Two rows err a third of what one errs.
struct FootprintTaps {
    glm::vec2 first, step, side;
    /// In each row: about the longer axis over the larger of w and half a texel; at least as many as rows, at
    /// most 16.
    int count;
    int rows;        ///< 1 where the footprint is below 0.35 texels, or eight times as long as wide; else 2
    int level;       ///< 0 is the finest one
    float fraction;  ///< of the next level, 0 to 1; 0 at the last one
};

/// The same of sixteen points.
struct LaneFootprintTaps {
    std::array<Lanes, 2> first, step, side;
    LaneIntegers count, rows, level;
    Lanes fraction;
};

/// What the points are looked up in: a mipmap whose finest level has this many texels.
struct MipmapShape {
    int width, height;
    int last_level;
    UvTransform to_uv;
};

/// Finite places and a level for all footprints, those that are not finite included.
[[nodiscard]] FootprintTaps footprint_taps(const TexturePoint& point, const MipmapShape& shape);
void footprint_taps(const TexturePoints& points, const MipmapShape& shape, LaneFootprintTaps& out);

}  // namespace nicol
