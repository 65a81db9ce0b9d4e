// SPDX-License-Identifier: MIT
// Rotates one light into the frames of sixteen vertices at once.
#pragma once

#include <complex>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// A light's coefficients rotated by Ry(-theta) Rz(-phi), one normal (theta, phi) a lane. The y rotation is
/// two constant matrices around a phase: d(theta) = i^m D e^{-ik theta} D^T i^-m', D = d(-pi/2). Because
/// D_{m,-n} = (-1)^{l+m} D_mn and D_{-m,n} = (-1)^{l+n} D_mn, a quarter of each product suffices, and an
/// eighth for real fields. Immutable; threads share it.
class LaneRotation {
public:
    explicit LaneRotation(int order);

    /// Fields that are rotated at once, which saves time.
    static constexpr std::size_t kMostFields = 3;

    /// One thread's: normals and results.
    class Work {
    public:
        /// Of the last rotation of `fields` fields: those of one position stand side by side, first the real
        /// parts of all positions, then from imaginary() positions on the imaginary ones.
        [[nodiscard]] const Lanes* results() const { return results_.data(); }
        [[nodiscard]] std::size_t imaginary() const { return results_.size() / (2 * kMostFields); }

    private:
        friend class LaneRotation;
        // exp(i m angle) of each lane.
        struct Phases {
            std::vector<Lanes> cosine;
            std::vector<Lanes> sine;
        };
        Phases azimuth_;  // m (phi + pi / 2)
        Phases zenith_;   // -m theta
        std::vector<Lanes> results_;
        std::vector<Lanes> scratch_;
    };
    [[nodiscard]] Work work() const;

    /// At most kLanes unit normals; the other lanes repeat the first.
    void set_normals(std::span<const glm::vec3> normals, Work& work) const;

    /// Real fields (s0 or s3), 1 to kMostFields: each of `in` holds coefficients f_lm over complex harmonics
    /// for m >= 0, the result is v_lm with f'_lm = (-i)^m v_lm. Position l (l + 1) / 2 + m.
    void rotate_real(std::span<const std::complex<float>* const> in, Work& work) const;
    /// Complex fields (s1 + i s2): all m, position psh_index(l, m); result likewise.
    void rotate_complex(std::span<const std::complex<float>* const> in, Work& work) const;

private:
    // For each l the quarter of D (or its transpose) with rows and columns >= 0, [row][column]; for real
    // fields with columns > 0 doubled.
    struct Quarters {
        std::vector<float> first;   // transposed
        std::vector<float> second;  // as it is
    };

    // Calls `run` with what a rotation needs.
    template <class Run>
    void rotate_by(const Quarters& quarters, std::span<const std::complex<float>* const> in, Work& work,
                   Run run) const;

    int order_;
    Quarters real_;
    Quarters complex_;
};

}  // namespace nicol
