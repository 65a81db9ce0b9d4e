// SPDX-License-Identifier: MIT
// Materials measured as Mueller matrices, from .pbsdf files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "material/material.hpp"

namespace nicol {

enum class WavelengthSampling { linear, nearest };

/// Parameters of Mitsuba 3's `measured_polarized`.
struct MeasuredParameters {
    /// Wavelengths in nm, 1..16 values from 100 to 5000, with one channel each. Empty: red, green and blue
    /// (rgb_weights()), or one channel if the file has one wavelength.
    std::vector<double> wavelengths;
    WavelengthSampling sampling = WavelengthSampling::linear;
    /// Averages M(phi_d) with the mirror image of M(-phi_d), which reduces noise and halves the memory.
    bool symmetrize = false;
};

/// Reads a .pbsdf file with the fields theta_h, theta_d, phi_d (f32, [1][N] or [N], radians, increasing),
/// wvls (u16 or f32, nm, increasing) and M (f32, [phi_d][theta_d][theta_h][wvls][4][4], in s-frames, without
/// the cosine). Values are linear between the angles and constant beyond them; phi_d runs over -pi..pi or
/// 0..2 pi. An angle field of shape [0][N] has no values and stands for N evenly spaced angles, both ends
/// included: theta_h and theta_d over 0..pi/2, phi_d over 0..2 pi. One call of `notice` names these fields.
///
/// The file is streamed. Its memory is taken from `budget` before allocation: 34 bytes per channel and
/// direction, which is 102 MB per channel at the resolution of the KAIST data set (361 x 91 x 91). A
/// mirror-symmetric material takes half: one that is symmetrized, or whose file has azimuths on only one side
/// of the plane of incidence, because mirror images give the other side.
///
/// Elements other than M00 are stored relative to M00, clamped to -2..2, in steps of 6e-5. A matrix whose M00
/// is not finite is missing: the matrix of the nearest wavelength replaces it, else the mirror image of the
/// matrix at the mirrored direction, else zero. A matrix whose M00 is negative counts as zero, and so does
/// any other element that is not finite.
///
/// Throws Error(file_not_found), Error(invalid_file) that names file and field for a malformed, truncated or
/// empty file, Error(unsupported) for tables above 1 GiB, and Error(invalid_argument) for the parameters.
[[nodiscard]] MaterialPtr load_measured(const std::filesystem::path& path,
                                        const MeasuredParameters& parameters = {},
                                        const std::function<void(const std::string&)>& notice = {},
                                        const LoadBudget& budget = {});

}  // namespace nicol
