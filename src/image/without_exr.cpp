// SPDX-License-Identifier: MIT
// OpenEXR files in builds without them.
#include "files/file_error.hpp"
#include "image/exr_colors.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_exr(const std::filesystem::path& file) {
    refuse_left_out_format(file, "OpenEXR files", "NICOL_EXR");
}

}  // namespace

void write_exr(const std::filesystem::path& path, const StokesImage& /*image*/,
               const ExrOptions& /*options*/) {
    refuse_exr(path);
}

void encode_exr(std::FILE* /*file*/, const std::string& name, const StokesImage& /*image*/,
                const ExrOptions& /*options*/) {
    refuse_exr(name);
}

StokesImage read_exr(const std::filesystem::path& path, std::span<const double> /*wavelengths*/,
                     const LoadBudget& /*budget*/) {
    refuse_exr(path);
}

Bitmap read_exr_colors(const std::filesystem::path& file, const LoadBudget& /*budget*/) {
    refuse_exr(file);
}

}  // namespace nicol
