// SPDX-License-Identifier: MIT
// Materials between files.
#pragma once

#include <filesystem>
#include <vector>

#include "inspect/file_options.hpp"
#include "inspect/material_report.hpp"
#include "material/material.hpp"

namespace nicol {

/// A material and what its file said about it.
struct MaterialFile {
    MaterialPtr material;
    int file_order = 0;                        ///< 0 where the file has no coefficients
    LightKind light = LightKind::full;         ///< what a table answers to
    std::vector<double> measured_wavelengths;  ///< nm

    /// Of the options, or the default for the kind of file.
    [[nodiscard]] int order(const FileOptions& options) const;
};

/// Both throw Error(invalid_argument) for options that concern light, and what the readers throw.
[[nodiscard]] MaterialFile read_material_file(const std::filesystem::path& path, FileKind kind,
                                              const FileOptions& options);
[[nodiscard]] MaterialFile material_file(MaterialPtr material, const FileOptions& options);

/// Writes a material as SHMat (.npz) or, where `path` is a folder, as a table of the cache there. Throws
/// Error(invalid_argument) for other names and for a scale that a table cannot have, Error(unsupported) for a
/// material that the format cannot hold, and what the writers throw.
void write_material_file(const MaterialFile& file, const FileOptions& options,
                         const std::filesystem::path& path);

[[nodiscard]] MaterialReport describe(const MaterialFile& file, const FileOptions& options);

}  // namespace nicol
