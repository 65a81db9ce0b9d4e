// SPDX-License-Identifier: MIT
#include "polarization/mueller.hpp"

#include <cmath>

namespace nicol {

Mueller& Mueller::operator*=(double scale) {
    for (double& value : m_) value *= scale;
    return *this;
}

Mueller operator*(const Mueller& a, const Mueller& b) {
    Mueller product;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += a(row, k) * b(k, column);
            product(row, column) = sum;
        }
    }
    return product;
}

Stokes operator*(const Mueller& m, const Stokes& s) {
    Stokes out(0.0);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t k = 0; k < 4; ++k) out[static_cast<int>(row)] += m(row, k) * s[static_cast<int>(k)];
    }
    return out;
}

Mueller operator*(double scale, const Mueller& m) {
    Mueller scaled = m;
    scaled *= scale;
    return scaled;
}

Mueller operator+(const Mueller& a, const Mueller& b) {
    Mueller sum = a;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) sum(row, column) += b(row, column);
    }
    return sum;
}

Mueller frame_rotation(double angle) {
    const double c = std::cos(2 * angle);
    const double s = std::sin(2 * angle);
    return Mueller({1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1});
}

Mueller in_rotated_frames(const Mueller& m, double in, double out) {
    return frame_rotation(out) * m * frame_rotation(-in);
}

}  // namespace nicol
