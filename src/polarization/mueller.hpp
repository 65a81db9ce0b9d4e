// SPDX-License-Identifier: MIT
// Mueller matrices, which map incident to outgoing Stokes vectors.
#pragma once

#include <array>
#include <cstddef>

#include "polarization/stokes.hpp"

namespace nicol {

/// A 4 x 4 Mueller matrix, row-major: out[row] = sum over column of m(row, column) in[column]. Not a glm
/// matrix on purpose, because glm matrices are column-major and a silent transposition still looks plausible.
class Mueller {
public:
    Mueller() = default;
    explicit Mueller(const std::array<double, 16>& rows) : m_(rows) {}

    [[nodiscard]] double& operator()(std::size_t row, std::size_t column) { return m_[4 * row + column]; }
    [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
        return m_[4 * row + column];
    }

    Mueller& operator*=(double scale);

private:
    std::array<double, 16> m_{};
};

[[nodiscard]] Mueller operator*(const Mueller& a, const Mueller& b);
[[nodiscard]] Stokes operator*(const Mueller& m, const Stokes& s);
[[nodiscard]] Mueller operator*(double scale, const Mueller& m);
[[nodiscard]] Mueller operator+(const Mueller& a, const Mueller& b);

/// Returns the matrix of rotated(), which gives components in the frame rotated by `angle` about z (Eq. 14).
[[nodiscard]] Mueller frame_rotation(double angle);

/// Returns the Mueller matrix of one optical element in other frames: `in` and `out` are the angles that
/// rotate the matrix's incident and outgoing frames into the wanted frames.
[[nodiscard]] Mueller in_rotated_frames(const Mueller& m, double in, double out);

}  // namespace nicol
