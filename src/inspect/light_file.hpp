// SPDX-License-Identifier: MIT
// Light between files.
#pragma once

#include <filesystem>

#include "inspect/file_options.hpp"
#include "inspect/light_report.hpp"
#include "light/environment.hpp"

namespace nicol {

/// Light with the options' scale, not yet rotated: an image or coefficients.
struct LightFile {
    EnvironmentPtr image;  ///< null for coefficients
    PshVector coefficients;
    int width = 0;  ///< of the image

    [[nodiscard]] int channels() const { return image ? image->channels() : coefficients.channels(); }
    /// Of the options, or the default for the kind of file.
    [[nodiscard]] int order(const FileOptions& options) const;
    /// Rotated coefficients of that order.
    [[nodiscard]] PshVector project(const FileOptions& options) const;
    /// The rotated image, in the size of the options, or its own.
    [[nodiscard]] EquirectImage draw(const FileOptions& options, int least_width = 512) const;
};

/// Images may be unphysical. Throws what the readers throw, and Error(invalid_argument) for options that the
/// kind of file has no use for.
[[nodiscard]] LightFile read_light_file(const std::filesystem::path& path, FileKind kind,
                                        const FileOptions& options);
[[nodiscard]] LightFile light_file(const Environment& light, const FileOptions& options);

/// Writes light in the format that the name says. Throws Error(invalid_argument) for options that the format
/// has no use for, and what the writers throw.
void write_light_file(const LightFile& light, const FileOptions& options, const std::filesystem::path& path);

/// Of the image that would be written; `energies` up to order(options), or none.
[[nodiscard]] LightReport describe(const LightFile& light, const FileOptions& options, bool energies);

}  // namespace nicol
