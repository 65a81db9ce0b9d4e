// SPDX-License-Identifier: MIT
#include "inspect_options.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "files/npy.hpp"
#include "files/zip.hpp"
#include "harmonics/rotation.hpp"
#include "light/cube_names.hpp"

namespace nicol::capi {
namespace {

using std::filesystem::path;

std::optional<glm::dmat3> rotation_from(const double (&rows)[9]) {
    if (std::ranges::all_of(rows, [](double v) { return v == 0; })) return std::nullopt;
    glm::dmat3 rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const double value = rows[3 * row + column];
            if (!std::isfinite(value)) refuse("options->rotation has a value that is not finite");
            rotation[column][row] = value;
        }
    (void)euler_zyz(rotation);  // refuses what is no rotation
    return rotation;
}

// Light and materials share the suffix: the shape of the coefficients tells.
nicol_file_kind kind_of_archive(const path& file) {
    for (const ZipEntry& entry : read_zip_directory(file)) {
        if (entry.name != "coeff.npy") continue;
        ZipStream stream(file, entry);
        const NpyHeader header = read_npy_header(stream, file.string() + ": member coeff.npy");
        return header.shape.size() >= 4 ? NICOL_FILE_MATERIAL_PSH : NICOL_FILE_LIGHT_PSH;
    }
    throw Error(ErrorCode::unsupported,
                file.string() + ": has no member coeff.npy; neither light (SHVec) nor a material (SHMat)");
}

}  // namespace

FileOptions read_file_options(const nicol_file_options* options) {
    FileOptions out;
    if (options == nullptr) return out;
    const nicol_file_options given = read_struct(options, "options");
    const auto limit = [](std::uint64_t value, const char* name, std::uint32_t low, std::uint32_t high) {
        if (value == 0 || (value >= low && value <= high)) return static_cast<int>(value);
        refuse("options->" + std::string(name) + " is " + std::to_string(value) + "; it must be 0 or " +
               std::to_string(low) + " to " + std::to_string(high));
    };
    if (given.order < -1 || given.order > NICOL_PSH_MAX_ORDER)
        refuse("options->order is " + std::to_string(given.order) + "; it must be -1 to " +
               std::to_string(NICOL_PSH_MAX_ORDER));
    if (given.order != 0) out.order = std::max(given.order, 0);
    out.width = limit(given.width, "width", 2, NICOL_MAX_SIZE);
    out.height = limit(given.height, "height", 2, NICOL_MAX_SIZE);
    if ((out.width == 0) != (out.height == 0)) refuse("options has a width or a height; it needs both");
    out.edge = limit(given.edge, "edge", 2, 4096);
    if ((given.flags & ~std::uint32_t{NICOL_FILE_BAND_LIMITED | NICOL_FILE_PHYSICAL}) != 0)
        refuse("options->flags has bits that are no NICOL_FILE_BAND_LIMITED and NICOL_FILE_PHYSICAL");
    out.band_limited = (given.flags & NICOL_FILE_BAND_LIMITED) != 0;
    out.physical = (given.flags & NICOL_FILE_PHYSICAL) != 0;
    if (!(given.scale >= 0 && given.scale <= 1e12))
        refuse("options->scale is " + std::to_string(given.scale) + "; it must be 0 (for 1) to 1e12");
    if (given.scale != 0) out.scale = given.scale;
    out.rotation = rotation_from(given.rotation);
    if (given.reserved != 0) refuse("options->reserved must be 0");
    if (given.wavelengths.count > NICOL_MAX_CHANNELS)
        refuse("options->wavelengths.count is " + std::to_string(given.wavelengths.count) +
               "; it must be at most " + std::to_string(NICOL_MAX_CHANNELS));
    out.wavelengths.assign(given.wavelengths.values, given.wavelengths.values + given.wavelengths.count);
    for (const double wavelength : out.wavelengths)
        if (!(wavelength >= 100 && wavelength <= 5000))
            refuse("options->wavelengths has " + std::to_string(wavelength) +
                   "; a wavelength must be 100 to 5000 nm");
    return out;
}

void require_no_image_options(const FileOptions& options, const std::string& output) {
    if (options.width != 0) refuse("width and height are those of an image to write, not of " + output);
    if (options.edge != 0) refuse("edge is that of a cube map to write, not of " + output);
    if (options.physical) refuse("NICOL_FILE_PHYSICAL is for images to write, not for " + output);
}

nicol_file_kind kind_of_input(const path& file) {
    std::error_code error;
    const bool there = std::filesystem::exists(file, error);
    if (cube_cross_stem(file) ||
        (!there && !file.empty() && std::filesystem::exists(cube_cross_file(file, 0), error)))
        return NICOL_FILE_LIGHT_CROSS;
    if (!there) throw Error(ErrorCode::file_not_found, file.string() + ": does not exist");
    if (!std::filesystem::is_regular_file(file, error))
        throw Error(ErrorCode::unsupported, file.string() + ": is not a file");
    const path suffix = file.extension();
    if (suffix == ".exr") return NICOL_FILE_LIGHT_IMAGE;
    if (suffix == ".npz") return kind_of_archive(file);
    if (suffix == ".pbsdf") return NICOL_FILE_MATERIAL_MEASURED;
    if (suffix == ".response") return NICOL_FILE_MATERIAL_TABLE;
    throw Error(ErrorCode::unsupported,
                file.string() +
                    ": the suffix must be .exr or .npz for light, .npz, .pbsdf or .response "
                    "for materials");
}

std::span<double> energy_room(double* energy, std::uint64_t count, std::size_t needed) {
    if (count == 0) return {};
    require(energy, "energy");
    if (count < needed)
        refuse("energy has room for " + std::to_string(count) + " numbers; there are " +
               std::to_string(needed));
    return {energy, needed};
}

}  // namespace nicol::capi
