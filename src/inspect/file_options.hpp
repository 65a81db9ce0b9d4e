// SPDX-License-Identifier: MIT
// Kinds of files, and the options of conversions between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace nicol {

/// Kinds of files. The values are those of nicol_file_kind in the C ABI.
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

/// Returns the kind of a file by its suffix; for archives (.npz), by the shape of the coefficients. Throws
/// Error(file_not_found), Error(unsupported), and for archives what read_npy_header() throws.
[[nodiscard]] FileKind identify(const std::filesystem::path& file);

struct FileOptions {
    std::optional<int> order;   ///< highest order of coefficients and tables; none: the file's own, or 32
                                ///< (light), 16 (materials)
    int width = 0;              ///< columns of the image to write; 0: not given
    int height = 0;             ///< rows of the image to write; given together with width or not at all
    int edge = 0;               ///< edge of a face of the cube map to write, in pixels; 0: not given
    bool band_limited = false;  ///< whether the image holds samples of light without orders above `order`
    bool physical = false;      ///< whether images to write are made physically realizable (Eq. 70)
    double scale = 1;           ///< factor on radiance or reflectance
    std::optional<glm::dmat3> rotation;  ///< rotation of the light, with its Stokes frames
    std::vector<double> wavelengths;     ///< channels to read from spectral files, in nm; empty: all
};

/// Throws Error(invalid_argument) if options are given that matter only when images are written.
void require_no_image_options(const FileOptions& options, const std::string& output);

}  // namespace nicol
