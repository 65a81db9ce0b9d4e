// SPDX-License-Identifier: MIT
// Measured materials.
#pragma once

#include <filesystem>
#include <vector>

#include "material/material.hpp"

namespace nicol {

enum class WavelengthSampling { linear, nearest };

/// Mitsuba 3's `measured_polarized`.
struct MeasuredParameters {
    /// Empty: red, green and blue (rgb_weights() of spectrum_weights.hpp), or one channel where the file has
    /// one wavelength. Else a channel for each of these wavelengths in nm, 1..16 of 100 to 5000.
    std::vector<double> wavelengths;
    WavelengthSampling sampling = WavelengthSampling::linear;
};

/// Reads a .pbsdf file: fields theta_h, theta_d, phi_d (f32, [1][N] or [N], radians, increasing), wvls (u16
/// or f32, nm, increasing) and M (f32, [phi_d][theta_d][theta_h][wvls][4][4], s-frames, without the cosine).
/// Between the angles linear, beyond them constant; phi_d runs over -pi..pi or 0..2 pi.
///
/// Streamed: the file is never in memory. What stays are 34 bytes for each channel and pair of mirrored
/// directions, 52 MB a channel at the resolution of the KAIST data set (361 x 91 x 91).
///
/// A Material is mirror symmetric, so M(phi_d) is averaged with the mirror image of M(-phi_d); the rest is a
/// measurement's error. The elements but M00 are kept relative to M00 within -2..2, in steps of 6e-5. A
/// matrix with NaN as M00 is missing: the nearest wavelength or the mirrored direction stands in for it, else
/// it is zero, as it is where M00 is negative; any other element that is not finite is zero.
///
/// Throws Error(file_not_found); Error(invalid_file) naming file and field for what is malformed, truncated
/// or empty; Error(unsupported) for tables above 1 GiB; Error(invalid_argument) for the parameters.
[[nodiscard]] MaterialPtr load_measured(const std::filesystem::path& path,
                                        const MeasuredParameters& parameters = {});

}  // namespace nicol
