// SPDX-License-Identifier: MIT
// Turns one light into the frames of sixteen vertices at once.
#pragma once

#include <array>
#include <complex>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "transfer/lanes.hpp"

namespace nicol {

/// A light's coefficients turned by Ry(-theta) Rz(-phi), one normal (theta, phi) a lane. The y rotation is
/// two constant matrices around a phase: d(theta) = i^m D e^{-ik theta} D^T i^-m', D = d(-pi/2). Because
/// D_{m,-n} = (-1)^{l+m} D_mn and D_{-m,n} = (-1)^{l+n} D_mn, a quarter of each product suffices, and an
/// eighth for real fields. Holds work space: one object a thread.
class LaneRotation {
public:
    explicit LaneRotation(int order);

    /// At most kLanes unit normals; the other lanes repeat the first.
    void set_normals(std::span<const glm::vec3> normals);

    /// A real field (s0 or s3): `in` are its coefficients f_lm over complex harmonics for m >= 0, the result
    /// is v_lm with f'_lm = (-i)^m v_lm. Position l (l + 1) / 2 + m.
    void turn_real(std::span<const std::complex<float>> in);
    /// A complex field (s1 + i s2): all m, position psh_index(l, m); result likewise.
    void turn_complex(std::span<const std::complex<float>> in);

    [[nodiscard]] const Lanes& re(std::size_t position) const { return re_[position]; }
    [[nodiscard]] const Lanes& im(std::size_t position) const { return im_[position]; }

private:
    // The quarter of D (and of its transpose) that is needed for one order: rows a >= 0, columns n >= 0
    // sorted into those with n = l mod 2 and the others; rows sorted by the parity of l + a.
    struct Quarter {
        std::array<std::vector<float>, 4> part;  // [2 * odd row + odd column]
    };
    // exp(i m angle) of each lane.
    struct Phases {
        std::vector<Lanes> cosine;
        std::vector<Lanes> sine;
    };

    void multiply_real(const Quarter& quarter, int l, std::size_t first);
    void multiply_complex(const Quarter& quarter, int l, std::size_t middle);

    int order_;
    std::vector<Quarter> first_;   // transposed
    std::vector<Quarter> second_;  // as it is
    Phases azimuth_;               // m (phi + pi / 2)
    Phases zenith_;                // -m theta
    std::vector<Lanes> re_;
    std::vector<Lanes> im_;
    std::vector<Lanes> folded_;
    std::vector<Lanes> product_;
};

}  // namespace nicol
