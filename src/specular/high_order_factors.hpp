// SPDX-License-Identifier: MIT
// Reflection factors of a material for prefiltered light of high orders, by the outgoing zenith angle.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "material/material.hpp"

namespace nicol {

class KnownMoments;
class SplitBasis;

/// Widths of the lobes that filter light, radians, as for gaussian_gains(). All materials share them, so a
/// light is filtered once per lobe.
inline constexpr std::array<double, 4> kLobeWidths{0.0, 0.05, 0.1, 0.2};

/// Factors of a stencil: filtered light is evaluated at six taps. With the view direction v and the mirror
/// direction d = v - 2 n (n.v) (both propagation directions, n the surface's normal), the central tap is at
/// d; the outer taps are up/down = d cos a +- y sin a within the plane of incidence and right/left = d cos a
/// +- x sin a across it. x = n x v, y = d x x are the frame of s1, s2 at d; x is made orthogonal to the
/// direction at left and right. x is also the x axis of the outgoing light's frame. The base tap, which
/// represents a diffuse base, is at -n in light filtered by cosine_gains(). With S the Stokes vectors at the
/// taps, outgoing light is
///     F_central S_d + F_up S_up + F_down S_down + F_sum (S_right + S_left) + F_difference (S_right - S_left)
///     + F_base S_-n.
/// Mirror symmetry leaves eight elements of each factor (of F_base two: s0 to s0 and to s1). A material
/// without mirror symmetry is the sum of two parts with it, called pairings. In the second pairing, the
/// outgoing (s0, s1) and (s2, s3) change places.
class HighOrderFactors {
public:
    /// Number of zenith angles, whose cosines are spaced evenly from 0 to 1. Factors are linear between them.
    static constexpr int kAngles = 129;

    /// Elements in stored order, (row, column); the elements that unpolarized light needs come first:
    /// (0,0) (1,0) of central, up, down and sum; (2,0) (3,0) of difference; (0,0) (1,0) of base; then (0,1)
    /// (1,1) (2,2) (3,2) (2,3) (3,3) of central, up, down and sum; (0,2) (1,2) (2,1) (3,1) (0,3) (1,3) of
    /// difference.
    static constexpr int kUnpolarized = 12;
    static constexpr int kElements = 42;

    /// Returns a perfect mirror: the central tap alone, for light that is convolved with a material's kernel.
    [[nodiscard]] static HighOrderFactors mirror();

    /// Fits the factors to a material, for the orders of the basis and light whose power falls with l (l +
    /// 1), by least squares at every angle. channels: 1 or the scene's. known: moments that materials with
    /// the same terms_key() share; null: none. Throws Error(invalid_argument) for channels that do not fit.
    HighOrderFactors(const Material& material, const SplitBasis& basis, int channels,
                     KnownMoments* known = nullptr);

    /// Returns an object with the values of the members below of another object, or nothing if they are
    /// invalid.
    [[nodiscard]] static std::optional<HighOrderFactors> stored(int channels, std::size_t pairings,
                                                                int central_lobe, int outer_lobe,
                                                                bool has_base, std::vector<float> data);

    /// Returns the number of channels; 1 if all channels have equal factors.
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// Returns 1 for mirror-symmetric materials, else 2.
    [[nodiscard]] std::size_t pairings() const noexcept { return pairings_; }
    /// Returns the index in kLobeWidths of the lobe for the central tap (or for the four outer taps).
    [[nodiscard]] int central_lobe() const noexcept { return central_lobe_; }
    [[nodiscard]] int outer_lobe() const noexcept { return outer_lobe_; }
    /// Returns the angle a between the central tap and the outer taps, radians; 0 if there are no outer taps.
    [[nodiscard]] double spread() const noexcept { return spread_; }
    /// Returns whether there is a tap at -n.
    [[nodiscard]] bool has_base() const noexcept { return has_base_; }

    /// Returns all factors, [angle][channel][pairing][element].
    [[nodiscard]] std::span<const float> data() const noexcept { return data_; }
    /// Returns texels for a texture that is kAngles wide, [pairing][element][angle][4]. The four components
    /// hold the first `count` channels (1..4) from `first_channel` on. The elements are those of unpolarized
    /// light, or all if `polarized`.
    [[nodiscard]] std::vector<float> texels(int first_channel, int count, bool polarized) const;
    /// Returns the elements [pairing][element] of an angle and channel; those of the next angle are step()
    /// further.
    [[nodiscard]] const float* row(std::size_t angle, std::size_t channel) const {
        return &data_[angle * step() + channel * pairings_ * kElements];
    }
    [[nodiscard]] std::size_t step() const noexcept {
        return static_cast<std::size_t>(channels_) * pairings_ * kElements;
    }
    /// Position of the cosine of a zenith angle: the angle below, and the weight of the next angle.
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
