// SPDX-License-Identifier: MIT
// Statistics of a material's reflection.
#pragma once

#include <array>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// Statistics of one coefficient matrix of a material.
struct MatrixReport {
    double albedo = 0;  ///< albedo for uniform unpolarized light
    /// Largest albedo for light from one direction up to 75 degrees from the normal, in the worst
    /// polarization.
    double largest_albedo = 0;
    std::array<double, 9> norms{};  ///< norms of the parts between the groups s0, (s1, s2), s3: [out][in]
    double asymmetry = 0;  ///< norm of the part that breaks mirror symmetry, divided by the matrix's norm
    std::vector<double> energy;  ///< [l]: sum of squared coefficients with max(l_out, l_in) = l
};
[[nodiscard]] MatrixReport describe(const IsotropicMatrix& matrix);

/// Polarization beyond the physically realizable range in one channel of a material.
struct MuellerReport {
    double unphysical = 0;  ///< fraction of the pairs of directions, by projected solid angle
    double excess = 0;      ///< mean of sqrt(s1^2 + s2^2 + s3^2) - s0 where positive, divided by the mean M00
};
[[nodiscard]] MuellerReport describe(const Material& material, int channel);

struct MaterialReport {
    int order = 0;                             ///< order of the matrices
    int file_order = 0;                        ///< order of the file's own coefficients; 0 if it has none
    LightKind light = LightKind::full;         ///< Stokes components of the light that a table covers
    std::vector<double> measured_wavelengths;  ///< nm
    struct Channel {
        MatrixReport matrix;
        MuellerReport mueller;
    };
    std::vector<Channel> channels;
};

}  // namespace nicol
