// SPDX-License-Identifier: MIT
// Reading, conversion and writing of light.
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
    int width = 0;  ///< columns of the image

    [[nodiscard]] int channels() const { return image ? image->channels() : coefficients.channels(); }
    /// Returns the order in the options, or the default for the kind of file.
    [[nodiscard]] int order(const FileOptions& options) const;
    /// Returns the rotated coefficients up to order(options).
    [[nodiscard]] PshVector project(const FileOptions& options) const;
    /// Returns the rotated image, in the size given in the options or in its own size.
    [[nodiscard]] EquirectImage draw(const FileOptions& options, int least_width = 512) const;
};

/// Reads or copies light. Images may be physically unrealizable. Throws what the readers throw, and
/// Error(invalid_argument) for options that the kind of file does not use.
[[nodiscard]] LightFile read_light_file(const std::filesystem::path& path, FileKind kind,
                                        const FileOptions& options);
[[nodiscard]] LightFile light_file(const Environment& light, const FileOptions& options);

/// Writes light in the format given by the suffix of `path`. Throws Error(invalid_argument) for options that
/// the format does not use, and what the writers throw.
void write_light_file(const LightFile& light, const FileOptions& options, const std::filesystem::path& path);

/// Returns the report of the image that would be written, with energies up to order(options) if `energies` is
/// true.
[[nodiscard]] LightReport describe(const LightFile& light, const FileOptions& options, bool energies);

}  // namespace nicol
