// SPDX-License-Identifier: MIT
// Response of a material as rows of coefficients, one set per outgoing zenith angle, whose dot products with
// the incident light are the reflected Stokes vector.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "material/material.hpp"

namespace nicol {

struct AngleTable;

/// Rows for the outgoing Stokes vector at zenith angle theta and azimuth 0, in the theta-phi frame there.
/// Light in the surface's frame, with even and odd numbers in pairs (LightLayout), gives
///     s_p = sum_j row_p[j] even_j + second_p[j] odd_j  for p = 0, 1,
///     s_p = sum_j row_p[j] odd_j + second_p[j] even_j  for p = 2, 3,
/// where `second`, the row of the second pairing, exists only for materials without mirror symmetry. Row
/// entries are the integral of M_pq cos(theta_i) against the basis over incident directions (Eq. 40 with the
/// outgoing side left in the angular domain), so nothing is truncated on the outgoing side. Rows are
/// interpolated linearly between angles.
class ResponseTable {
public:
    /// Number of zenith angles, evenly from 0 to pi/2. At most every second angle is integrated, and
    /// the others are cubic interpolations: all of them where rows vary slowly. The linear interpolation at
    /// run time then has an error below 4e-4 of a row up to order 16.
    static constexpr int kAngles = 512 + 1;
    /// Angles of of_outgoing_light(), whose error is below 1e-6 of the largest value up to order 16.
    static constexpr int kOutgoingAngles = 4097;

    /// Rows of all terms, for one layout, [angle] as RowIntegral has them; empty: not integrated yet.
    using KnownRows = std::array<std::vector<double>, kAngles>;

    /// Integrates every term of the material on quadrature nodes that are dense about the mirror direction,
    /// or evaluates the outgoing side of the matrix that defines the material. `channels`: 1 or the scene's;
    /// a material of one channel fits any. known: rows that materials with the same terms_key() share; null:
    /// none. Throws Error(invalid_argument) if the channels do not fit.
    ResponseTable(const Material& material, const LightLayout& layout, int channels,
                  KnownRows* known = nullptr);
    /// Takes the data() of another table with this layout, number of channels and pairings. Throws
    /// Error(invalid_argument) if the length does not fit.
    ResponseTable(const LightLayout& layout, int channels, std::size_t pairings, std::vector<float> data);
    /// Returns the table whose outgoing Stokes vector is the value of the light itself at the outgoing
    /// direction, for light that is reflected light already.
    [[nodiscard]] static ResponseTable of_outgoing_light(const LightLayout& layout);

    /// Returns the channels() that the table of a material has. Throws what the constructor throws.
    [[nodiscard]] static int channels_for(const Material& material, int channels);

    /// Returns 1 if every channel has the same rows, else the number of channels.
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// Returns the number of zenith angles, evenly from 0 to pi/2: kAngles or kOutgoingAngles.
    [[nodiscard]] int angles() const noexcept { return angles_; }
    /// Returns the length of a row, all pairings together.
    [[nodiscard]] std::size_t row_size() const noexcept { return row_size_; }
    /// Returns 1, or 2 for a material without mirror symmetry.
    [[nodiscard]] std::size_t pairings() const noexcept { return pairings_; }
    /// Returns whether the material reflects component p: false if row_p is zero at every angle.
    [[nodiscard]] bool makes(std::size_t p) const noexcept { return makes_[p]; }

    /// Returns the four rows of an angle, one after another.
    [[nodiscard]] std::span<const float> rows(int angle, int channel) const {
        const auto index = static_cast<std::size_t>(angle) * static_cast<std::size_t>(channels_) +
                           static_cast<std::size_t>(channel);
        return {data_.data() + 4 * row_size_ * index, 4 * row_size_};
    }

    /// Returns all rows: [angle][channel][p][pairing][j].
    [[nodiscard]] std::span<const float> data() const noexcept { return data_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return data_.size() * sizeof(float); }

private:
    ResponseTable(const LightLayout& layout, int channels, std::size_t pairings, int angles,
                  std::vector<float> data);
    void find_makes();
    void integrate(const Material& material, const LightLayout& layout, KnownRows* known);
    void integrate(const Material& material, const LightLayout& layout, KnownRows* known,
                   const AngleTable& table, std::span<const int> angles) const;
    void rows_of_matrices(const Material& material, const LightLayout& layout);

    std::size_t pairings_;
    std::size_t row_size_;
    int channels_;
    int angles_;
    std::array<bool, 4> makes_{};
    std::vector<float> data_;
};

}  // namespace nicol
