// SPDX-License-Identifier: MIT
// Light between files.
#pragma once

#include <filesystem>
#include <span>

#include "inspect_options.hpp"
#include "light/environment.hpp"

namespace nicol::capi {

/// Light with the options' scale, not yet rotated: an image or its coefficients.
struct LightSource {
    EnvironmentPtr image;  ///< none for coefficients
    PshVector coefficients;
    int width = 0;  ///< of the image

    [[nodiscard]] int channels() const { return image ? image->channels() : coefficients.channels(); }
    /// The order that the options mean.
    [[nodiscard]] int order(const FileOptions& options) const;
    /// Rotated coefficients of that order.
    [[nodiscard]] PshVector project(const FileOptions& options) const;
    /// The rotated image in the size that the options mean.
    [[nodiscard]] EquirectImage draw(const FileOptions& options, int least_width = 512) const;
};

/// Reads a file of light of this kind. Images may be unphysical. Throws what the readers throw.
[[nodiscard]] LightSource read_light(const std::filesystem::path& path, nicol_file_kind kind,
                                     const FileOptions& options);
[[nodiscard]] LightSource light_source(const Environment& light, const FileOptions& options);

/// Writes light in the format that the name says. Throws Error(invalid_argument) for options that the format
/// has no use for, and what the writers throw.
void write_light(const LightSource& light, const FileOptions& options, const std::filesystem::path& path);

/// Fills the report but for its kind; energy is empty or has room for [channel][l][4].
void report_light(const LightSource& light, const FileOptions& options, nicol_light_report& report,
                  std::span<double> energy);

}  // namespace nicol::capi
