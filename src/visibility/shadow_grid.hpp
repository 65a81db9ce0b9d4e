// SPDX-License-Identifier: MIT
// Product of light and visibility on a grid of the upper half sphere: Gauss-Legendre rows, uniform columns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/mirror_harmonics.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Multiplier of light by mirrored visibility, for sixteen vertices at once. Visibility is mirrored at the
/// horizon, so the even and the odd part of a function under this mirror are multiplied by the same samples
/// on the upper half. On each row, each part is a sum of cosines and sines of m phi. The columns at phi,
/// -phi, pi - phi and pi + phi share the sums over even m and over odd m, so that only a quarter of the
/// columns is summed.
class ShadowGrid {
public:
    /// Makes a grid for light of this layout; the product is exact for visibility of twice the light's order.
    explicit ShadowGrid(const LightLayout& layout);

    [[nodiscard]] std::size_t samples() const noexcept { return 4 * quarter_ * rows_.count(); }
    /// Computes samples from the coefficients of visibility over real harmonics, by psh_index, of twice the
    /// light's order: [row][column of the quarter][phi, -phi, pi - phi, pi + phi].
    void sample(const Lanes* visibility, Lanes* samples) const;

    /// Computes out = visibility times in, both lights. Samples are multiples of 1 / kFixedOne,
    /// [sample][lane].
    void multiply(const std::int16_t* samples, const Lanes* in, Lanes* out) const;

    /// Sums over m that the four columns share: of cosines of even m, of odd m, sines of even m, of odd m.
    struct Slots {
        explicit Slots(int order, std::size_t quarter);
        [[nodiscard]] std::uint32_t of(int m) const;

        std::array<std::uint32_t, 5> begin{};  // first slot of each sum, and the end
        std::vector<float> table;              // [column][slot]
    };
    /// Consecutive harmonics that share a slot.
    struct Run {
        std::uint32_t first;
        std::uint32_t last;
        std::uint32_t slot;
    };
    /// One Stokes component of a group of harmonics.
    struct Component {
        std::vector<Run> runs;
        std::vector<float> on_rows;  // [row][harmonic]
        std::size_t harmonics = 0;
        std::size_t begin = 0;  // first coefficient in the light
    };
    /// A function: its even part and its odd part.
    using Pair = std::array<Component, 2>;

    /// Tables for implementations on other processors.
    [[nodiscard]] std::size_t rows() const noexcept { return rows_.count(); }
    [[nodiscard]] std::size_t columns() const noexcept { return quarter_; }  ///< columns of the quarter
    [[nodiscard]] const Slots& slots() const noexcept { return slots_; }
    /// Pairs of the Stokes components; pairs_out() includes the rows' weights.
    [[nodiscard]] const std::vector<Pair>& pairs_in() const noexcept { return pairs_in_; }
    [[nodiscard]] const std::vector<Pair>& pairs_out() const noexcept { return pairs_out_; }

private:
    void add_pairs(const LightLayout& layout, bool weighted, std::vector<Pair>& pairs) const;

    UpperRows rows_;
    std::size_t quarter_;
    Slots slots_;  // slots for the light
    Slots slots_visibility_;
    std::vector<Pair> pairs_in_;
    std::vector<Pair> pairs_out_;
    Component visibility_;
    std::vector<std::size_t> visibility_index_;  // psh_index of each harmonic of visibility_
};

}  // namespace nicol
