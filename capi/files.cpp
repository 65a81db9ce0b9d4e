// SPDX-License-Identifier: MIT
// Files of light and materials: descriptions and conversions between formats.
#include <algorithm>
#include <cmath>
#include <string>

#include "handles.hpp"
#include "harmonics/rotation.hpp"
#include "initialiser.hpp"
#include "inspect/light_file.hpp"
#include "inspect/material_file.hpp"
#include "light/psh_file.hpp"
#include "nicol_files.h"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

static_assert(NICOL_FILE_LIGHT_IMAGE == static_cast<int>(FileKind::light_image) &&
              NICOL_FILE_LIGHT_CROSS == static_cast<int>(FileKind::light_cross) &&
              NICOL_FILE_LIGHT_PSH == static_cast<int>(FileKind::light_psh) &&
              NICOL_FILE_MATERIAL_PSH == static_cast<int>(FileKind::material_psh) &&
              NICOL_FILE_MATERIAL_MEASURED == static_cast<int>(FileKind::material_measured) &&
              NICOL_FILE_MATERIAL_TABLE == static_cast<int>(FileKind::material_table));

std::optional<glm::dmat3> rotation_from(const double (&rows)[9]) {
    glm::dmat3 rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const double value = rows[3 * row + column];
            if (!std::isfinite(value)) refuse("options->rotation has a value that is not finite");
            rotation[column][row] = value;
        }
    if (rotation == glm::dmat3(1)) return std::nullopt;
    (void)euler_zyz(rotation);  // throws if it is not a rotation
    return rotation;
}

FileOptions options_from(const nicol_file_options* options) {
    FileOptions out;
    const auto given = read_options(options, nicol_file_options NICOL_FILE_OPTIONS_INIT);
    const auto limit = [](std::uint64_t value, const char* name, std::uint32_t low, std::uint32_t high) {
        if (value >= low && value <= high) return static_cast<int>(value);
        refuse("options->" + std::string(name) + " is " + std::to_string(value) + "; it must be " +
               std::to_string(low) + " to " + std::to_string(high));
    };
    if (given.order != NICOL_FILE_ORDER_AUTOMATIC)
        out.order = limit(given.order, "order", 0, NICOL_PSH_MAX_ORDER);
    if ((given.width == 0) != (given.height == 0)) refuse("options has a width or a height; it needs both");
    if (given.width != 0) {
        out.width = limit(given.width, "width", 2, NICOL_MAX_SIZE);
        out.height = limit(given.height, "height", 2, NICOL_MAX_SIZE);
    }
    if (given.edge != 0) out.edge = limit(given.edge, "edge", 2, 4096);
    if ((given.flags & ~std::uint32_t{NICOL_FILE_BAND_LIMITED | NICOL_FILE_PHYSICAL}) != 0)
        refuse("options->flags has bits that are no NICOL_FILE_BAND_LIMITED and NICOL_FILE_PHYSICAL");
    out.band_limited = (given.flags & NICOL_FILE_BAND_LIMITED) != 0;
    out.physical = (given.flags & NICOL_FILE_PHYSICAL) != 0;
    if (!(given.scale >= 0 && given.scale <= 1e12))
        refuse("options->scale is " + std::to_string(given.scale) + "; it must be 0 to 1e12");
    out.scale = given.scale;
    out.rotation = rotation_from(given.rotation);
    if (given.reserved != 0) refuse("options->reserved must be 0");
    out.wavelengths = spectrum(given.wavelengths, 0, 0, "options->wavelengths");
    for (const double wavelength : out.wavelengths)
        if (!(wavelength >= 100 && wavelength <= 5000))
            refuse("options->wavelengths has " + std::to_string(wavelength) +
                   "; a wavelength must be 100 to 5000 nm");
    return out;
}

// Checks before a file is read that the caller's struct holds at least its size.
template <class T>
void require_report(const T* report) {
    require(report, "report");
    if (report->struct_size < sizeof report->struct_size)
        refuse("report->struct_size is not set; it must be sizeof(the struct)");
}

void require_room(const double* energy, std::uint64_t count, std::size_t needed) {
    if (count == 0) return;
    require(energy, "energy");
    if (count < needed)
        refuse("energy has room for " + std::to_string(count) + " numbers; there are " +
               std::to_string(needed));
}

nicol_light_report report_from(const LightReport& light) {
    nicol_light_report out = NICOL_LIGHT_REPORT_INIT;
    out.channels = static_cast<std::uint32_t>(light.channels.size());
    out.width = static_cast<std::uint32_t>(light.width);
    out.height = static_cast<std::uint32_t>(light.height);
    out.polarized = light.polarized ? 1 : 0;
    out.circular = light.circular ? 1 : 0;
    std::ranges::copy(light.wavelengths, out.wavelengths);
    for (std::size_t c = 0; c < light.channels.size(); ++c) {
        const LightChannelReport& channel = light.channels[c];
        out.mean[c] = channel.mean;
        out.smallest[c] = channel.smallest;
        out.largest[c] = channel.largest;
        out.mean_dolp[c] = channel.mean_dolp;
        out.largest_dolp[c] = channel.largest_dolp;
        out.largest_circular[c] = channel.circular;
        out.unphysical[c] = channel.unphysical;
        out.largest_excess[c] = channel.largest_excess;
        for (int i = 0; i < 3; ++i) out.direction[3 * c + static_cast<std::size_t>(i)] = channel.direction[i];
    }
    return out;
}

nicol_material_report report_from(const MaterialReport& material) {
    nicol_material_report out = NICOL_MATERIAL_REPORT_INIT;
    out.channels = static_cast<std::uint32_t>(material.channels.size());
    out.order = static_cast<std::uint32_t>(material.order);
    out.file_order = static_cast<std::uint32_t>(material.file_order);
    out.stokes_columns = static_cast<std::uint32_t>(material.light);
    out.measured_wavelengths = static_cast<std::uint32_t>(material.measured_wavelengths.size());
    if (!material.measured_wavelengths.empty()) {
        out.measured_range[0] = material.measured_wavelengths.front();
        out.measured_range[1] = material.measured_wavelengths.back();
    }
    for (std::size_t c = 0; c < material.channels.size(); ++c) {
        const auto& [matrix, mueller] = material.channels[c];
        out.albedo[c] = matrix.albedo;
        out.largest_albedo[c] = matrix.largest_albedo;
        std::ranges::copy(matrix.norms, out.norms + 9 * c);
        out.asymmetry[c] = matrix.asymmetry;
        out.unphysical[c] = mueller.unphysical;
        out.excess[c] = mueller.excess;
    }
    return out;
}

}  // namespace

nicol_result nicol_file_identify(const char* path, nicol_file_kind* kind) {
    return guarded([&] {
        require(kind, "kind");
        *kind = static_cast<nicol_file_kind>(identify(read_path(path, "path")));
    });
}

nicol_result nicol_file_describe_light(const char* path, const nicol_file_options* options,
                                       nicol_light_report* report, double* energy, uint64_t count) {
    return guarded([&] {
        const std::filesystem::path file = read_path(path, "path");
        require_report(report);
        const FileOptions given = options_from(options);
        require_no_image_options(given, "a report");
        const FileKind kind = identify(file);
        if (!is_light(kind)) refuse(file.string() + ": is a material, not light");
        const LightFile light = read_light_file(file, kind, given);
        const auto orders = static_cast<std::size_t>(light.order(given)) + 1;
        require_room(energy, count, 4 * static_cast<std::size_t>(light.channels()) * orders);
        const LightReport found = describe(light, given, count > 0);
        nicol_light_report out = report_from(found);
        out.kind = static_cast<nicol_file_kind>(kind);
        out.order = static_cast<std::uint32_t>(light.order(given));
        write_struct(report, out, "report");
        for (const LightChannelReport& channel : found.channels)
            for (const Stokes& of_order : channel.energy)
                for (int p = 0; p < 4; ++p) *energy++ = of_order[p];
    });
}

nicol_result nicol_file_describe_material(const char* path, const nicol_file_options* options,
                                          nicol_material_report* report, double* energy, uint64_t count) {
    return guarded([&] {
        const std::filesystem::path file = read_path(path, "path");
        require_report(report);
        const FileOptions given = options_from(options);
        const FileKind kind = identify(file);
        if (is_light(kind)) refuse(file.string() + ": is light, not a material");
        const MaterialFile material = read_material_file(file, kind, given);
        const auto orders = static_cast<std::size_t>(material.order(given)) + 1;
        require_room(energy, count, static_cast<std::size_t>(material.material->channels()) * orders);
        const MaterialReport found = describe(material, given);
        nicol_material_report out = report_from(found);
        out.kind = static_cast<nicol_file_kind>(kind);
        std::ranges::copy(given.wavelengths, out.wavelengths);
        write_struct(report, out, "report");
        if (count == 0) return;
        for (const MaterialReport::Channel& channel : found.channels)
            energy = std::ranges::copy(channel.matrix.energy, energy).out;
    });
}

nicol_result nicol_file_convert(const char* in, const nicol_file_options* options, const char* out) {
    return guarded([&] {
        const std::filesystem::path from = read_path(in, "in");
        const std::filesystem::path to = read_path(out, "out");
        const FileOptions given = options_from(options);
        const FileKind kind = identify(from);
        if (is_light(kind))
            write_light_file(read_light_file(from, kind, given), given, to);
        else
            write_material_file(read_material_file(from, kind, given), given, to);
    });
}

nicol_result nicol_environment_write(nicol_environment environment, const nicol_file_options* options,
                                     const char* path) {
    return guarded([&] {
        const FileOptions given = options_from(options);
        write_light_file(light_file(*resolve(environment).content, given), given, read_path(path, "path"));
    });
}

nicol_result nicol_material_write(nicol_material material, const nicol_file_options* options,
                                  const char* path) {
    return guarded([&] {
        const FileOptions given = options_from(options);
        write_material_file(material_file(resolve(material).content, given), given, read_path(path, "path"));
    });
}

nicol_result nicol_psh_write_file(const char* path, uint32_t order, uint64_t vectors,
                                  const double* coefficients, uint64_t count) {
    return guarded([&] {
        const std::filesystem::path file = read_path(path, "path");
        const int highest = read_order(order, "order");
        if (vectors < 1 || vectors > NICOL_MAX_CHANNELS)
            refuse("vectors is " + std::to_string(vectors) + "; it must be 1 to " +
                   std::to_string(NICOL_MAX_CHANNELS));
        const auto values = read_array(coefficients, count, vectors, vector_size(highest), "coefficients");
        PshVector field(highest, static_cast<int>(vectors));
        std::ranges::copy(values, field.data().begin());
        write_psh_vector(file, field);
    });
}

NICOL_INITIALISER(nicol_file_options, NICOL_FILE_OPTIONS_INIT)
NICOL_INITIALISER(nicol_light_report, NICOL_LIGHT_REPORT_INIT)
NICOL_INITIALISER(nicol_material_report, NICOL_MATERIAL_REPORT_INIT)
