// SPDX-License-Identifier: MIT
// Materials between files.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "inspect_options.hpp"
#include "material/material.hpp"
#include "material/response_cache.hpp"

namespace nicol::capi {

/// A material and what its file said about it.
struct MaterialSource {
    MaterialPtr material;
    int file_order = 0;                        ///< 0 where the file has no coefficients
    LightKind light = LightKind::full;         ///< what a table answers to
    std::vector<double> measured_wavelengths;  ///< nm
    bool scaled = false;

    /// The order that the options mean.
    [[nodiscard]] int order(const FileOptions& options) const;
};

/// Reads a file of a material of this kind. Throws what the readers throw and Error(invalid_argument) for
/// options that concern light.
[[nodiscard]] MaterialSource read_material(const std::filesystem::path& path, nicol_file_kind kind,
                                           const FileOptions& options);
[[nodiscard]] MaterialSource material_source(MaterialPtr material, const FileOptions& options);

/// Writes a material as SHMat or into a cache folder.
void write_material(const MaterialSource& source, const FileOptions& options,
                    const std::filesystem::path& path);

/// Fills the report but for its kind; energy is empty or has room for [channel][l].
void report_material(const MaterialSource& source, const FileOptions& options, nicol_material_report& report,
                     std::span<double> energy);

/// The matrices of a table's channels: the light that leaves upwards (Eq. 40). Columns that the table does
/// not have are zero.
[[nodiscard]] std::vector<IsotropicMatrix> matrices_of(const StoredResponse& file);

/// What a coefficient matrix says about its material.
struct MatrixNumbers {
    double albedo = 0;              ///< of even unpolarized light
    double largest_albedo = 0;      ///< from one direction up to 75 degrees, in the worst polarization
    std::array<double, 9> norms{};  ///< [out][in] of the groups s0, (s1, s2), s3
    double asymmetry = 0;           ///< norm of what breaks mirror symmetry, over that of all
    std::vector<double> energy;     ///< [l] of max(l_out, l_in)
};
[[nodiscard]] MatrixNumbers describe_matrix(const IsotropicMatrix& matrix);

/// How far a channel of a material polarizes light beyond itself.
struct MuellerNumbers {
    double unphysical = 0;  ///< part of the pairs of directions, by projected solid angle
    double excess = 0;      ///< mean of sqrt(s1^2 + s2^2 + s3^2) - s0 where positive, over the mean M00
};
[[nodiscard]] MuellerNumbers describe_mueller(const Material& material, int channel);

}  // namespace nicol::capi
