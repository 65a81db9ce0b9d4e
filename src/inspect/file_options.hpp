// SPDX-License-Identifier: MIT
// Kinds of files, and how files are converted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace nicol {

/// The values are those of nicol_file_kind in the C ABI.
enum class FileKind : std::uint32_t {
    light_image = 1,        ///< an equirectangular image (.exr)
    light_cross = 2,        ///< a cube map as four crosses (_s0.exr to _s3.exr)
    light_psh = 3,          ///< coefficients (.npz, SHVec)
    material_psh = 4,       ///< a coefficient matrix (.npz, SHMat)
    material_measured = 5,  ///< a table of Mueller matrices (.pbsdf)
    material_table = 6,     ///< a response table of the cache (.response)
};

[[nodiscard]] constexpr bool is_light(FileKind kind) {
    return kind <= FileKind::light_psh;
}

/// By suffix and, of archives, the shape of the coefficients. Throws Error(file_not_found),
/// Error(unsupported) and, of archives, what read_npy_header() throws.
[[nodiscard]] FileKind identify(const std::filesystem::path& file);

struct FileOptions {
    std::optional<int>
        order;       ///< of coefficients and tables; none: the file's own, or 32 (light), 16 (materials)
    int width = 0;   ///< of an image to write, columns; 0: not given
    int height = 0;  ///< rows; both are given or none
    int edge = 0;    ///< of a face of a cube map to write, pixels; 0: not given
    bool band_limited = false;           ///< an image holds samples of light without orders above `order`
    bool physical = false;               ///< images to write are made physical (Eq. 70)
    double scale = 1;                    ///< of radiance or reflectance
    std::optional<glm::dmat3> rotation;  ///< of light, with everything in it
    std::vector<double> wavelengths;     ///< nm, a channel each, of spectral files; empty: all
};

/// Throws Error(invalid_argument) where options are given that matter only when images are written.
void require_no_image_options(const FileOptions& options, const std::string& output);

}  // namespace nicol
