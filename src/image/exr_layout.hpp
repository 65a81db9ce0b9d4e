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

/// Returns `S<component>.<colour>`, as Mitsuba 3 writes it.
[[nodiscard]] std::string exr_channel(std::size_t component, const std::string& colour);

/// Returns the colour name of a wavelength by Fichet et al. (2021): "550,000000nm".
[[nodiscard]] std::string exr_wavelength(double nanometres);

/// Channels to read from a file.
struct ExrLayout {
    std::vector<std::array<std::string, 4>> names;  ///< [channel][p]; empty if the file has none
    std::vector<double> wavelengths;                ///< nm, [channel]; empty for colours
    bool left_handed = false;                       ///< whether s3 has the opposite sign
};

/// Returns the layout according to the names in the header. `wavelengths` selects among spectral channels.
/// Throws what read_exr() throws.
[[nodiscard]] ExrLayout find_exr_layout(const std::filesystem::path& file, const Imf::Header& header,
                                        std::span<const double> wavelengths);

}  // namespace nicol
