// SPDX-License-Identifier: MIT
// Reading, conversion and writing of materials.
#pragma once

#include <filesystem>
#include <vector>

#include "inspect/file_options.hpp"
#include "inspect/material_report.hpp"
#include "material/material.hpp"

namespace nicol {

/// Material and the metadata of its file.
struct MaterialFile {
    MaterialPtr material;
    int file_order = 0;                        ///< order of the file's coefficients; 0 if it has none
    LightKind light = LightKind::full;         ///< Stokes components of the light that a table covers
    std::vector<double> measured_wavelengths;  ///< nm

    /// Returns the order in the options, or the default for the kind of file.
    [[nodiscard]] int order(const FileOptions& options) const;
};

/// Reads or wraps a material. Both functions throw Error(invalid_argument) for options that concern light,
/// and what the readers throw.
[[nodiscard]] MaterialFile read_material_file(const std::filesystem::path& path, FileKind kind,
                                              const FileOptions& options);
[[nodiscard]] MaterialFile material_file(MaterialPtr material, const FileOptions& options);

/// Writes a material as SHMat (.npz) or, if `path` is a folder, as a table of the cache there. Throws
/// Error(invalid_argument) for other names and for a scale that a table cannot have, Error(unsupported) for a
/// material that the format cannot hold, and what the writers throw.
void write_material_file(const MaterialFile& file, const FileOptions& options,
                         const std::filesystem::path& path);

[[nodiscard]] MaterialReport describe(const MaterialFile& file, const FileOptions& options);

}  // namespace nicol
