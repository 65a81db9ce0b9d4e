// SPDX-License-Identifier: MIT
// Texels of equirectangular images, and where directions lie in them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <glm/vec4.hpp>
#include <vector>

#include "light/environment.hpp"
#include "polarization/view_geometry.hpp"
#include "simd/lane_angle.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {

/// Place of a direction in an equirectangular image. Number: float, or a vector of it.
template <class Number>
struct EquirectPlace {
    Number turn;       ///< turns about the vertical, 0 to 1
    Number half_turn;  ///< half turns from the zenith, 0 to 1
    Number across;     ///< distance of the direction from the vertical
};

/// Returns the place of a direction of any length but 0.
template <class Number>
[[gnu::always_inline]] inline EquirectPlace<Number> equirect_place(const Number& x, const Number& y,
                                                                   const Number& z) {
    EquirectPlace<Number> out;
    out.across = x * x + z * z;
    square_root(out.across);
    Number quarter, height;
    quarter_turns<Number>(x < 0.0F ? -x : x, z < 0.0F ? -z : z, quarter);
    quarter *= 0.25F;
    const Number from_front = z > 0.0F ? 0.5F - quarter : quarter;
    out.turn = x < 0.0F ? 1.0F - from_front : from_front;
    out.turn = out.across > 0.0F ? out.turn : Number{};
    quarter_turns<Number>(out.across, y < 0.0F ? -y : y, height);
    height *= 0.5F;
    out.half_turn = y < 0.0F ? 1.0F - height : height;
    return out;
}

[[gnu::always_inline]] inline FourLanes in_register(const glm::vec4& texel) {
    FourLanes out;
    std::memcpy(&out, &texel, sizeof out);
    return out;
}

/// Planes of texels. Columns are pixel-centred and periodic.
struct EquirectTexels {
    int width;
    int height;
    float rows;                     ///< rows from the zenith to the nadir
    float first_row;                ///< distance of the first row from the zenith, in rows
    std::vector<glm::vec4> texels;  ///< [plane][row][column]

    /// Returns the interpolated texel of a plane.
    [[nodiscard]] glm::vec4 at(std::size_t plane, float turn, float half_turn) const {
        const float x = turn * static_cast<float>(width) + 0.5F;
        const float y = std::clamp(half_turn * rows - first_row, 0.0F, static_cast<float>(height - 1));
        const int after = std::min(static_cast<int>(x), width);  // the column to the right, plus one
        const int left = after == 0 ? width - 1 : after - 1;
        const int right = after == width ? 0 : after;
        const int upper = static_cast<int>(y);
        const int lower = std::min(upper + 1, height - 1);
        const float right_part = x - static_cast<float>(after);
        const float lower_part = y - static_cast<float>(upper);
        const auto w = static_cast<std::size_t>(width);
        const glm::vec4* const of_plane = texels.data() + plane * w * static_cast<std::size_t>(height);
        const glm::vec4* const upper_row = of_plane + static_cast<std::size_t>(upper) * w;
        const glm::vec4* const lower_row = of_plane + static_cast<std::size_t>(lower) * w;
        const FourLanes above_left = in_register(upper_row[left]), below_left = in_register(lower_row[left]);
        const FourLanes a = above_left + right_part * (in_register(upper_row[right]) - above_left);
        const FourLanes b = below_left + right_part * (in_register(lower_row[right]) - below_left);
        const FourLanes mean = a + lower_part * (b - a);
        glm::vec4 out;
        std::memcpy(&out, &mean, sizeof out);
        return out;
    }
};

/// Returns black texels of width x height. centred: whether rows are pixel-centred; else the first is the
/// zenith and the last the nadir.
[[nodiscard]] EquirectTexels black_texels(int width, int height, bool centred, std::size_t planes);

/// Returns the texels of an image, whose rows are vertex-centred: a plane of Stokes vectors for each channel
/// of polarized light, else a plane of s0 for four channels. An image of one channel serves all channels.
[[nodiscard]] EquirectTexels texels_of(const EquirectImage& image, bool polarized, std::size_t channels);

}  // namespace nicol
