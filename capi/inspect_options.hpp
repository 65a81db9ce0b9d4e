// SPDX-License-Identifier: MIT
// Options and kinds of files.
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "boundary.hpp"

namespace nicol::capi {

/// nicol_file_options after all checks that need no file.
struct FileOptions {
    std::optional<int> order;
    int width = 0;  ///< 0: not given
    int height = 0;
    int edge = 0;
    bool band_limited = false;
    bool physical = false;
    double scale = 1;
    std::optional<glm::dmat3> rotation;
    std::vector<double> wavelengths;
};

/// Throws Error(invalid_argument) naming the member that is out of range.
[[nodiscard]] FileOptions read_file_options(const nicol_file_options* options);

/// Throws Error(invalid_argument) where options are given that matter only when images are written.
void require_no_image_options(const FileOptions& options, const std::string& output);

/// What a file to read is. Throws Error(file_not_found), Error(unsupported) and, of archives, what
/// read_npy_header() throws.
[[nodiscard]] nicol_file_kind kind_of_input(const std::filesystem::path& path);

[[nodiscard]] constexpr bool is_light(nicol_file_kind kind) {
    return kind <= NICOL_FILE_LIGHT_PSH;
}

/// Throws Error(invalid_argument) unless `count` is 0 or at least `needed`.
[[nodiscard]] std::span<double> energy_room(double* energy, std::uint64_t count, std::size_t needed);

}  // namespace nicol::capi
