// SPDX-License-Identifier: MIT
#include "inspect_material.hpp"

#include <algorithm>
#include <string>

#include "material/material_projection.hpp"
#include "material/measured.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/response_cache.hpp"
#include "material/tensor_file.hpp"

namespace nicol::capi {
namespace {

using std::filesystem::path;

constexpr int default_order = 16;

void require_no_light_options(const FileOptions& options) {
    require_no_image_options(options, "a material");
    if (options.rotation) refuse("rotation is for light; a material stands in its surface's frame");
    if (options.band_limited) refuse("NICOL_FILE_BAND_LIMITED is for images to read, not for a material");
    if (options.order.value_or(0) > NICOL_PSH_MAX_MATRIX_ORDER)
        refuse("options->order is " + std::to_string(*options.order) +
               "; for a material it must be at most " + std::to_string(NICOL_PSH_MAX_MATRIX_ORDER));
}

std::vector<IsotropicMatrix> project(const MaterialSource& source, const FileOptions& options) {
    std::vector<IsotropicMatrix> out;
    for (int c = 0; c < source.material->channels(); ++c) {
        out.push_back(project_material(*source.material, c, source.order(options)));
        if (!source.material->matrix(c) && options.scale != 1) {
            IsotropicMatrix& matrix = out.back();
            for (int m = 0; m <= matrix.order_in(); ++m)
                for (int l = m; l <= matrix.order_out(); ++l)
                    for (int k = m; k <= matrix.order_in(); ++k)
                        for (auto& value : matrix.block(m, l, k)) value *= options.scale;
        }
    }
    return out;
}

void write_table(const MaterialSource& source, const FileOptions& options, const path& folder) {
    if (options.scale != 1 && !source.material->matrix(0))
        refuse(
            "a table of the cache holds the material as it is; scale it as .npz, and take the table of that");
    if (source.material->content_key().empty())
        throw Error(ErrorCode::unsupported, "a material given by a callback cannot be kept in a cache");
    // The cache goes on without a file; here the file is what is asked for.
    std::string failure;
    const auto notice = [&failure](const std::string& text) {
        if (!text.ends_with("the table is made anew")) failure = text;
    };
    (void)load_or_build(*source.material, LightLayout(source.order(options), LightKind::full),
                        source.material->channels(), folder, notice);
    if (!failure.empty()) throw Error(ErrorCode::write_failed, failure);
}

}  // namespace

int MaterialSource::order(const FileOptions& options) const {
    if (options.order) return *options.order;
    return material->matrix(0) ? material->matrix(0)->order_in() : default_order;
}

MaterialSource material_source(MaterialPtr material, const FileOptions& options) {
    require_no_light_options(options);
    if (!options.wavelengths.empty()) refuse("wavelengths can be chosen from measured materials only");
    MaterialSource out;
    out.material = std::move(material);
    return out;
}

MaterialSource read_material(const path& file, nicol_file_kind kind, const FileOptions& options) {
    require_no_light_options(options);
    MaterialSource out;
    if (kind == NICOL_FILE_MATERIAL_MEASURED) {
        TensorFile tensors(file);
        const TensorFile::Field& field =
            tensors.field("wvls", {1, 2}, {TensorFile::Type::u16, TensorFile::Type::f32});
        out.material = load_measured(file, {.wavelengths = options.wavelengths});
        out.measured_wavelengths = tensors.values(field, field.count);
        return out;
    }
    if (!options.wavelengths.empty())
        refuse(file.string() + ": wavelengths can be chosen from measured materials only");
    std::vector<IsotropicMatrix> matrices;
    if (kind == NICOL_FILE_MATERIAL_TABLE) {
        const StoredResponse table = read_response_table(file);
        if (table.table.channels() > NICOL_MAX_CHANNELS)
            throw Error(ErrorCode::unsupported,
                        file.string() + ": has " + std::to_string(table.table.channels()) +
                            " channels; it must have at most " + std::to_string(NICOL_MAX_CHANNELS));
        if (table.layout.order() > NICOL_PSH_MAX_MATRIX_ORDER)
            throw Error(ErrorCode::unsupported,
                        file.string() + ": has order " + std::to_string(table.layout.order()) +
                            "; it must be at most " + std::to_string(NICOL_PSH_MAX_MATRIX_ORDER));
        out.light = table.layout.kind();
        matrices = matrices_of(table);
    } else {
        matrices = read_psh_matrix(file);
    }
    out.file_order = matrices.front().order_in();
    out.material = psh_matrix_material(std::move(matrices), {options.scale});
    return out;
}

void write_material(const MaterialSource& source, const FileOptions& options, const path& file) {
    if (source.light != LightKind::full)
        throw Error(ErrorCode::unsupported,
                    "the table was made for light without all Stokes components; it is no whole material");
    std::error_code error;
    if (std::filesystem::is_directory(file, error) || !file.has_filename()) {
        write_table(source, options, file);
    } else if (file.extension() == ".npz") {
        write_psh_matrix(file, project(source, options));
    } else {
        refuse(file.string() +
               ": a material is written as .npz or into a cache folder (an existing one, or a name that ends "
               "in '/')");
    }
}

void report_material(const MaterialSource& source, const FileOptions& options, nicol_material_report& report,
                     std::span<double> energy) {
    const std::vector<IsotropicMatrix> matrices = project(source, options);
    report.channels = static_cast<std::uint32_t>(matrices.size());
    report.order = static_cast<std::uint32_t>(source.order(options));
    report.file_order = static_cast<std::uint32_t>(source.file_order);
    report.stokes_columns = static_cast<std::uint32_t>(source.light);
    report.measured_wavelengths = static_cast<std::uint32_t>(source.measured_wavelengths.size());
    if (!source.measured_wavelengths.empty()) {
        report.measured_range[0] = source.measured_wavelengths.front();
        report.measured_range[1] = source.measured_wavelengths.back();
    }
    std::ranges::copy(options.wavelengths, report.wavelengths);
    for (std::size_t c = 0; c < matrices.size(); ++c) {
        const MatrixNumbers numbers = describe_matrix(matrices[c]);
        report.albedo[c] = numbers.albedo;
        report.largest_albedo[c] = numbers.largest_albedo;
        std::ranges::copy(numbers.norms, report.norms + 9 * c);
        report.asymmetry[c] = numbers.asymmetry;
        const MuellerNumbers mueller = describe_mueller(*source.material, static_cast<int>(c));
        report.unphysical[c] = mueller.unphysical;
        report.excess[c] = mueller.excess;
        if (!energy.empty())
            std::ranges::copy(numbers.energy,
                              energy.begin() + static_cast<std::ptrdiff_t>(c * numbers.energy.size()));
    }
}

}  // namespace nicol::capi
