// SPDX-License-Identifier: MIT
// Turns one light into the frames of sixteen vertices at once.
#pragma once

#include <complex>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "transfer/lanes.hpp"

namespace nicol {

/// A light's coefficients turned by Ry(-theta) Rz(-phi), one normal (theta, phi) a lane. The y rotation is
/// two constant matrices around a phase: d(theta) = i^m D e^{-ik theta} D^T i^-m', D = d(-pi/2). Because
/// D_{m,-n} = (-1)^{l+m} D_mn and D_{-m,n} = (-1)^{l+n} D_mn, a quarter of each product suffices, and an
/// eighth for real fields. Immutable; threads share it.
class LaneRotation {
public:
    explicit LaneRotation(int order);

    /// One thread's: normals and results.
    class Work {
    public:
        [[nodiscard]] const Lanes& re(std::size_t position) const { return re_[position]; }
        [[nodiscard]] const Lanes& im(std::size_t position) const { return im_[position]; }

    private:
        friend class LaneRotation;
        // exp(i m angle) of each lane.
        struct Phases {
            std::vector<Lanes> cosine;
            std::vector<Lanes> sine;
        };
        Phases azimuth_;  // m (phi + pi / 2)
        Phases zenith_;   // -m theta
        std::vector<Lanes> re_;
        std::vector<Lanes> im_;
        std::vector<Lanes> scratch_;
    };
    [[nodiscard]] Work work() const;

    /// At most kLanes unit normals; the other lanes repeat the first.
    void set_normals(std::span<const glm::vec3> normals, Work& work) const;

    /// A real field (s0 or s3): `in` are its coefficients f_lm over complex harmonics for m >= 0, the result
    /// is v_lm with f'_lm = (-i)^m v_lm. Position l (l + 1) / 2 + m.
    void turn_real(std::span<const std::complex<float>> in, Work& work) const;
    /// A complex field (s1 + i s2): all m, position psh_index(l, m); result likewise.
    void turn_complex(std::span<const std::complex<float>> in, Work& work) const;

private:
    // For each l the quarter of D (or its transpose) with rows and columns >= 0, [row][column]; for real
    // fields with columns > 0 doubled.
    struct Quarters {
        std::vector<float> first;   // transposed
        std::vector<float> second;  // as it is
    };

    int order_;
    Quarters real_;
    Quarters complex_;
};

}  // namespace nicol
