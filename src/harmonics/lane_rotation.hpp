// SPDX-License-Identifier: MIT
// Rotation of light into the frames of sixteen vertices at once, and back.
#pragma once

#include <complex>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// Rotation of a light's coefficients by Ry(-theta) Rz(-phi), with one normal (theta, phi) per lane. The y
/// rotation is two constant matrices around a phase: d(theta) = i^m D e^{-ik theta} D^T i^-m', D = d(-pi/2).
/// Because D_{m,-n} = (-1)^{l+m} D_mn and D_{-m,n} = (-1)^{l+n} D_mn, a quarter of each product suffices, and
/// an eighth for real fields. D is orthogonal, so the reverse has equal products with opposite phases.
/// Immutable; threads share it.
class LaneRotation {
public:
    explicit LaneRotation(int order);

    /// Largest number of fields that are rotated at once, which saves time.
    static constexpr std::size_t kMostFields = 3;

    /// Kind of a field. real: s0 or s3, coefficients f_lm over complex harmonics for m >= 0 at position l (l
    /// + 1) / 2 + m. complex: s1 + i s2, all m at position psh_index(l, m).
    enum class Field { real, complex };

    /// Normals and fields of one thread.
    class Work {
    public:
        /// Returns the fields. Numbers of one position stand side by side; the real parts of all positions
        /// come first, the imaginary parts begin imaginary() positions later.
        [[nodiscard]] const Lanes* fields() const { return fields_.data(); }
        [[nodiscard]] Lanes* fields() { return fields_.data(); }
        [[nodiscard]] std::size_t imaginary() const { return fields_.size() / (2 * kMostFields); }

    private:
        friend class LaneRotation;
        explicit Work(int order);

        // exp(i m angle) of each lane.
        struct Phases {
            std::vector<Lanes> cosine;
            std::vector<Lanes> sine;
        };
        Phases azimuth_;  // angle phi + pi / 2
        Phases zenith_;   // angle -theta
        std::vector<Lanes> fields_;
        std::vector<Lanes> scratch_;
    };
    /// Returns the work space of the calling thread.
    [[nodiscard]] Work& work_of_thread() const;

    /// Sets at most kLanes unit normals; the other lanes repeat the first normal.
    void set_normals(std::span<const glm::vec3> normals, Work& work) const;

    /// Rotates 1 to kMostFields fields, common to all lanes, into all frames. The result, in `work`, is v_lm
    /// with f'_lm = (-i)^m v_lm.
    void rotate(Field kind, std::span<const std::complex<float>* const> in, Work& work) const;
    /// Rotates the fields in `work`, which differ from lane to lane.
    void rotate(Field kind, std::size_t fields, Work& work) const;
    /// Rotates back: v_lm in `work` becomes f_lm.
    void rotate_back(Field kind, std::size_t fields, Work& work) const;

private:
    // For each l, the quarter of D (or its transpose) with rows and columns >= 0, [row][column]. For real
    // fields, columns > 0 are doubled.
    struct Quarters {
        std::vector<float> first;   // quarters of the transpose of D
        std::vector<float> second;  // quarters of D
    };

    // Rotates the fields `in` or, if that is null, the fields in `work`.
    void rotate_by(Field kind, const std::complex<float>* const* in, std::size_t fields, bool back,
                   Work& work) const;

    int order_;
    Quarters real_;
    Quarters complex_;
};

}  // namespace nicol
