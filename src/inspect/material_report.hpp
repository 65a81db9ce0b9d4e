// SPDX-License-Identifier: MIT
// What a material does to light, as plain numbers.
#pragma once

#include <array>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// What a coefficient matrix says about its material.
struct MatrixReport {
    double albedo = 0;              ///< of even unpolarized light
    double largest_albedo = 0;      ///< from one direction up to 75 degrees, in the worst polarization
    std::array<double, 9> norms{};  ///< [out][in] of the groups s0, (s1, s2), s3
    double asymmetry = 0;           ///< norm of what breaks mirror symmetry, over that of all
    std::vector<double> energy;     ///< [l] of max(l_out, l_in)
};
[[nodiscard]] MatrixReport describe(const IsotropicMatrix& matrix);

/// How far a channel of a material polarizes light beyond itself.
struct MuellerReport {
    double unphysical = 0;  ///< part of the pairs of directions, by projected solid angle
    double excess = 0;      ///< mean of sqrt(s1^2 + s2^2 + s3^2) - s0 where positive, over the mean M00
};
[[nodiscard]] MuellerReport describe(const Material& material, int channel);

struct MaterialReport {
    int order = 0;                             ///< of the matrices
    int file_order = 0;                        ///< of the file's own coefficients; 0 where it has none
    LightKind light = LightKind::full;         ///< that a table answers to
    std::vector<double> measured_wavelengths;  ///< nm
    struct Channel {
        MatrixReport matrix;
        MuellerReport mueller;
    };
    std::vector<Channel> channels;
};

}  // namespace nicol
