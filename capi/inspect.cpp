// SPDX-License-Identifier: MIT
// Files of light and materials: what they hold, and from one format to another.
#include <algorithm>

#include "handles.hpp"
#include "inspect_light.hpp"
#include "inspect_material.hpp"
#include "light/psh_file.hpp"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

std::filesystem::path read_path(const char* path, const char* name) {
    require(path, name);
    if (*path == '\0') refuse(std::string(name) + " is empty");
    return path;
}

// Also where the caller's struct is shorter than a header, so that nothing is read for nothing.
template <class T>
void require_report(const T* report) {
    require(report, "report");
    if (report->struct_size < sizeof report->struct_size)
        refuse("report->struct_size is not set; it must be sizeof(the struct)");
}

}  // namespace

nicol_result nicol_file_identify(const char* path, nicol_file_kind* kind) {
    return guarded([&] {
        require(kind, "kind");
        *kind = kind_of_input(read_path(path, "path"));
    });
}

nicol_result nicol_file_describe_light(const char* path, const nicol_file_options* options,
                                       nicol_light_report* report, double* energy, uint64_t count) {
    return guarded([&] {
        const std::filesystem::path file = read_path(path, "path");
        require_report(report);
        const FileOptions given = read_file_options(options);
        require_no_image_options(given, "a report");
        nicol_light_report out = NICOL_LIGHT_REPORT_INIT;
        out.kind = kind_of_input(file);
        if (!is_light(out.kind)) refuse(file.string() + ": is a material, not light");
        const LightSource light = read_light(file, out.kind, given);
        const auto orders = static_cast<std::size_t>(light.order(given)) + 1;
        const auto channels = static_cast<std::size_t>(light.channels());
        std::vector<double> found(energy_room(energy, count, 4 * channels * orders).size());
        report_light(light, given, out, found);
        write_struct(report, out, "report");
        std::ranges::copy(found, energy);
    });
}

nicol_result nicol_file_describe_material(const char* path, const nicol_file_options* options,
                                          nicol_material_report* report, double* energy, uint64_t count) {
    return guarded([&] {
        const std::filesystem::path file = read_path(path, "path");
        require_report(report);
        const FileOptions given = read_file_options(options);
        nicol_material_report out = NICOL_MATERIAL_REPORT_INIT;
        out.kind = kind_of_input(file);
        if (is_light(out.kind)) refuse(file.string() + ": is light, not a material");
        const MaterialSource source = read_material(file, out.kind, given);
        const auto orders = static_cast<std::size_t>(source.order(given)) + 1;
        const auto channels = static_cast<std::size_t>(source.material->channels());
        std::vector<double> found(energy_room(energy, count, channels * orders).size());
        report_material(source, given, out, found);
        write_struct(report, out, "report");
        std::ranges::copy(found, energy);
    });
}

nicol_result nicol_file_convert(const char* in, const nicol_file_options* options, const char* out) {
    return guarded([&] {
        const std::filesystem::path from = read_path(in, "in");
        const std::filesystem::path to = read_path(out, "out");
        const FileOptions given = read_file_options(options);
        const nicol_file_kind kind = kind_of_input(from);
        if (is_light(kind))
            write_light(read_light(from, kind, given), given, to);
        else
            write_material(read_material(from, kind, given), given, to);
    });
}

nicol_result nicol_environment_write(nicol_environment environment, const nicol_file_options* options,
                                     const char* path) {
    return guarded([&] {
        const FileOptions given = read_file_options(options);
        write_light(light_source(*resolve(environment).content, given), given, read_path(path, "path"));
    });
}

nicol_result nicol_material_write(nicol_material material, const nicol_file_options* options,
                                  const char* path) {
    return guarded([&] {
        const FileOptions given = read_file_options(options);
        write_material(material_source(resolve(material).content, given), given, read_path(path, "path"));
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
