// SPDX-License-Identifier: MIT
// Measured materials.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "material/material.hpp"

namespace nicol {

enum class WavelengthSampling { linear, nearest };

/// Mitsuba 3's `measured_polarized`.
struct MeasuredParameters {
    /// Empty: red, green and blue (rgb_weights()), or one channel if the file has one wavelength. Else one
    /// channel per wavelength in nm: 1..16 values from 100 to 5000.
    std::vector<double> wavelengths;
    WavelengthSampling sampling = WavelengthSampling::linear;
    /// Averages M(phi_d) with the mirror image of M(-phi_d), which takes out noise and half of the memory.
    bool symmetrize = false;
};

/// Reads a .pbsdf file: fields theta_h, theta_d, phi_d (f32, [1][N] or [N], radians, increasing), wvls (u16
/// or f32, nm, increasing) and M (f32, [phi_d][theta_d][theta_h][wvls][4][4], s-frames, without the cosine).
/// Linear between the angles, constant beyond them; phi_d runs over -pi..pi or 0..2 pi. Angle fields of shape
/// [0][N], which hold no values, stand for N evenly spaced angles, both ends included: theta_h and theta_d
/// over 0..pi/2, phi_d over 0..2 pi. One call of `notice` then names them.
///
/// The file is streamed. Memory, which is taken from `budget` before it is allocated: 34 bytes per channel
/// and direction, 102 MB per channel at the resolution of the KAIST data set (361 x 91 x 91), half of that
/// where the material is mirror symmetric: symmetrized, or where the file has azimuths on one side of the
/// plane of incidence only, whose mirror images stand for the other.
///
/// Elements other than M00 are stored relative to M00, clamped to -2..2, in steps of 6e-5. A matrix whose M00
/// is NaN is missing and replaced by that of the nearest wavelength or the mirror image of that of the
/// mirrored direction, else by zero. A matrix whose M00 is negative is zero, and so is any other element that
/// is not finite.
///
/// Throws Error(file_not_found); Error(invalid_file) naming file and field if malformed, truncated or empty;
/// Error(unsupported) for tables above 1 GiB; Error(invalid_argument) for the parameters.
[[nodiscard]] MaterialPtr load_measured(const std::filesystem::path& path,
                                        const MeasuredParameters& parameters = {},
                                        const std::function<void(const std::string&)>& notice = {},
                                        const LoadBudget& budget = {});

}  // namespace nicol
