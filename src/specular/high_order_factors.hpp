// SPDX-License-Identifier: MIT
// What a material does to light of high orders that was filtered beforehand, by the outgoing zenith angle.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Widths of the lobes that light is filtered with, as for gaussian_gains(). All materials share them, so a
/// light is filtered once a lobe.
inline constexpr std::array<double, 4> kLobeWidths{0.0, 0.05, 0.1, 0.2};

/// The stencil: filtered light is looked up at six taps. With the view direction v and the mirror direction
/// d = v - 2 n (n.v) (both propagation directions, n the surface's normal), the central tap is at d; the
/// outer taps are up/down = d cos a +- y sin a within the plane of incidence and right/left = d cos a +- x
/// sin a across it. x = n x v, y = d x x are the frame of s1, s2 at d; x is made orthogonal to the direction
/// at left and right, and is the outgoing light's frame, too. The base tap, for what a diffuse base reflects,
/// is at -n in light filtered by cosine_gains(). With S the Stokes vectors at the taps, outgoing light is
///     F_central S_d + F_up S_up + F_down S_down + F_sum (S_right + S_left) + F_difference (S_right - S_left)
///     + F_base S_-n.
/// Mirror symmetry leaves eight elements each (the last: s0 to s0 and s1). A material without it is the sum
/// of two that have it, of which the second one's outgoing (s0, s1) and (s2, s3) change places: its second
/// pairing.
class HighOrderFactors {
public:
    /// Cosines of the zenith angle, evenly from 0 to 1. In between, factors are linear.
    static constexpr int kAngles = 129;

    /// Elements in the order they are stored, (row, column): those that unpolarized light needs come first.
    /// (0,0) (1,0) of central, up, down and sum; (2,0) (3,0) of difference; (0,0) (1,0) of base; then of
    /// central, up, down and sum (0,1) (1,1) (2,2) (3,2) (2,3) (3,3); of difference (0,2) (1,2) (2,1) (3,1)
    /// (0,3) (1,3).
    static constexpr int kUnpolarized = 12;
    static constexpr int kElements = 42;

    /// A perfect mirror: the central tap alone, for light that is convolved with a material's kernel.
    [[nodiscard]] static HighOrderFactors mirror();

    /// The nearest to a material, in orders l_low + 1 .. l_high of light whose power falls with l (l + 1), by
    /// least squares at every angle. channels: 1 or the scene's. Throws Error(invalid_argument) for orders
    /// out of 0 <= l_low < l_high <= kMaxOrder or channels that do not fit.
    HighOrderFactors(const Material& material, int l_low, int l_high, int channels);

    /// From what the members below gave of another; nothing where that cannot be.
    [[nodiscard]] static std::optional<HighOrderFactors> stored(int channels, std::size_t pairings,
                                                                int central_lobe, int outer_lobe,
                                                                bool has_base, std::vector<float> data);

    /// 1 where all channels have the same factors.
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// 1 of mirror symmetric materials, else 2.
    [[nodiscard]] std::size_t pairings() const noexcept { return pairings_; }
    /// Positions in kLobeWidths of the lobes for the central tap and for the four outer ones.
    [[nodiscard]] int central_lobe() const noexcept { return central_lobe_; }
    [[nodiscard]] int outer_lobe() const noexcept { return outer_lobe_; }
    /// The angle a between the central tap and the outer ones, radians; 0 where there are no outer taps.
    [[nodiscard]] double spread() const noexcept { return spread_; }
    /// Whether there is a tap at -n.
    [[nodiscard]] bool has_base() const noexcept { return has_base_; }

    /// [angle][channel][pairing][element]
    [[nodiscard]] std::span<const float> data() const noexcept { return data_; }
    /// For a texture that is kAngles wide: [pairing][element][angle][4], the first `count` channels (1..4)
    /// from `first_channel` on in the components; the elements of unpolarized light, or all.
    [[nodiscard]] std::vector<float> texels(int first_channel, int count, bool polarized) const;
    /// The elements [pairing][element] of an angle and channel; those of the next angle are step() further.
    [[nodiscard]] const float* row(std::size_t angle, std::size_t channel) const {
        return &data_[angle * step() + channel * pairings_ * kElements];
    }
    [[nodiscard]] std::size_t step() const noexcept {
        return static_cast<std::size_t>(channels_) * pairings_ * kElements;
    }
    /// Where the cosine of a zenith angle lies: the angle below, and the weight of the next one.
    struct Position {
        std::size_t angle;
        float fraction;
    };
    [[nodiscard]] static Position position(float cos_zenith) {
        const float x =
            (cos_zenith > 0 ? std::min(cos_zenith, 1.0F) : 0.0F) * static_cast<float>(kAngles - 1);
        const std::size_t angle =
            std::min(static_cast<std::size_t>(x), static_cast<std::size_t>(kAngles - 2));
        return {angle, x - static_cast<float>(angle)};
    }

private:
    HighOrderFactors() = default;

    int channels_ = 1;
    std::size_t pairings_ = 1;
    int central_lobe_ = 0;
    int outer_lobe_ = 0;
    double spread_ = 0;
    bool has_base_ = false;
    std::vector<float> data_;
};

}  // namespace nicol
