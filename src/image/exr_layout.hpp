// SPDX-License-Identifier: MIT
// Channel names of Stokes images in OpenEXR files.
#pragma once

#include <ImfHeader.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace nicol {

/// `S<component>.<colour>`, as Mitsuba 3 writes it.
[[nodiscard]] std::string exr_channel(std::size_t component, const std::string& colour);

/// The colour name of a wavelength by Fichet et al. (2021): "550,000000nm".
[[nodiscard]] std::string exr_wavelength(double nanometres);

/// What to read from a file.
struct ExrLayout {
    std::vector<std::array<std::string, 4>> names;  ///< [channel][p], empty where there is none
    std::vector<double> wavelengths;                ///< nm, [channel], or empty for colours
    bool left_handed = false;                       ///< s3 has the opposite sign
};

/// The layout by the names in the header; `wavelengths` chooses among spectral channels. Throws as
/// read_exr().
[[nodiscard]] ExrLayout find_exr_layout(const std::filesystem::path& file, const Imf::Header& header,
                                        std::span<const double> wavelengths);

}  // namespace nicol
