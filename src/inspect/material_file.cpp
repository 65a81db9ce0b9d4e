// SPDX-License-Identifier: MIT
#include "inspect/material_file.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "arguments.hpp"
#include "error.hpp"
#include "image/stokes_image.hpp"
#include "material/material_projection.hpp"
#include "material/matrix_rows.hpp"
#include "material/measured.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/response_cache.hpp"
#include "material/tensor_file.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

constexpr int kMaterialOrder = 16;

void require_no_light_options(const FileOptions& options) {
    require_no_image_options(options, "a material");
    if (options.rotation) refuse("rotation is for light; a material stands in its surface's frame");
    if (options.band_limited) refuse("NICOL_FILE_BAND_LIMITED is for images to read, not for a material");
    if (options.order.value_or(0) > CoefficientMatrix::kMaxDenseOrder)
        refuse("options->order is " + std::to_string(*options.order) +
               "; for a material it must be at most " + std::to_string(CoefficientMatrix::kMaxDenseOrder));
}

std::vector<IsotropicMatrix> project(const MaterialFile& file, const FileOptions& options) {
    std::vector<IsotropicMatrix> out;
    for (int c = 0; c < file.material->channels(); ++c) {
        out.push_back(project_material(*file.material, c, file.order(options)));
        if (!file.material->matrix(c) && options.scale != 1) {
            for (int m = 0; m <= out.back().order_in(); ++m)
                for (IsotropicMatrix::Block& block : out.back().blocks(m))
                    for (auto& value : block) value *= options.scale;
        }
    }
    return out;
}

void write_table(const MaterialFile& file, const FileOptions& options, const path& folder) {
    if (options.scale != 1 && !file.material->matrix(0))
        refuse(
            "a table of the cache holds the material as it is; scale it as .npz, and take the table of that");
    if (file.material->content_key().empty())
        throw Error(ErrorCode::unsupported, "a material given by a callback cannot be kept in a cache");
    store_response_table(*file.material, LightLayout(file.order(options), LightKind::full),
                         file.material->channels(), folder);
}

// Returns, for each pair of a row of `layout`, the index of the equal pair in a row of `full`, the full
// layout of the order.
std::vector<std::size_t> pairs_in_full(const LightLayout& layout, const LightLayout& full) {
    std::vector<std::size_t> out;
    std::size_t pair = 0;
    auto run = layout.runs().begin();
    for (const LightLayout::Run& candidate : full.runs()) {
        const bool same = run != layout.runs().end() && run->part == candidate.part &&
                          run->m == candidate.m && run->l == candidate.l && run->sign == candidate.sign;
        for (std::size_t i = 0; same && i < candidate.count; ++i) out.push_back(pair + i);
        if (same) ++run;
        pair += candidate.count;
    }
    return out;
}

// Returns the matrices of a table's channels, restricted to light that leaves upwards (Eq. 40). Columns that
// the table does not have are zero.
std::vector<IsotropicMatrix> matrices_of(const StoredResponse& stored) {
    const int order = stored.layout.order();
    const LightLayout all(order, LightKind::full);
    const int channels = stored.table.channels();
    std::vector<IsotropicMatrix> out(static_cast<std::size_t>(channels), IsotropicMatrix(order, order));
    const std::vector<std::size_t> pairs = pairs_in_full(stored.layout, all);
    const std::size_t pairings = stored.table.pairings();
    std::vector<double> rows(4 * pairings * all.row_size());
    constexpr int last = ResponseTable::kAngles - 1;
    constexpr double step = std::numbers::pi / 2 / last;
    for (int angle = 0; angle <= last; ++angle) {
        // Weights of Simpson's rule over the zenith angle.
        const double simpson = step / 3 * (angle == 0 || angle == last ? 1 : angle % 2 == 1 ? 4 : 2);
        const double theta = angle * step;
        for (int c = 0; c < channels; ++c) {
            const std::span<const float> from = stored.table.rows(angle, c);
            for (std::size_t row = 0; row < 4 * pairings; ++row)
                for (std::size_t j = 0; j < pairs.size(); ++j)
                    rows[row * all.row_size() + pairs[j]] = static_cast<double>(from[row * pairs.size() + j]);
            add_circle(out[static_cast<std::size_t>(c)], theta, simpson * std::sin(theta), all, pairings,
                       rows);
        }
    }
    return out;
}

}  // namespace

int MaterialFile::order(const FileOptions& options) const {
    if (options.order) return *options.order;
    return material->matrix(0) ? material->matrix(0)->order_in() : kMaterialOrder;
}

MaterialFile material_file(MaterialPtr material, const FileOptions& options) {
    require_no_light_options(options);
    if (!options.wavelengths.empty()) refuse("wavelengths can be chosen from measured materials only");
    MaterialFile out;
    out.material = std::move(material);
    return out;
}

MaterialFile read_material_file(const path& file, FileKind kind, const FileOptions& options) {
    require_no_light_options(options);
    MaterialFile out;
    if (kind == FileKind::material_measured) {
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
    if (kind == FileKind::material_table) {
        const StoredResponse table = read_response_table(file);
        if (table.table.channels() > kMaxFileChannels)
            throw Error(ErrorCode::unsupported,
                        file.string() + ": has " + std::to_string(table.table.channels()) +
                            " channels; it must have at most " + std::to_string(kMaxFileChannels));
        if (table.layout.order() > CoefficientMatrix::kMaxDenseOrder)
            throw Error(ErrorCode::unsupported,
                        file.string() + ": has order " + std::to_string(table.layout.order()) +
                            "; it must be at most " + std::to_string(CoefficientMatrix::kMaxDenseOrder));
        out.light = table.layout.kind();
        matrices = matrices_of(table);
    } else {
        matrices = read_psh_matrix(file);
    }
    out.file_order = matrices.front().order_in();
    out.material = psh_matrix_material(std::move(matrices), {options.scale});
    return out;
}

void write_material_file(const MaterialFile& file, const FileOptions& options, const path& to) {
    if (file.light != LightKind::full)
        throw Error(ErrorCode::unsupported,
                    "the table was made for light without all Stokes components; it is no whole material");
    std::error_code error;
    if (std::filesystem::is_directory(to, error) || !to.has_filename()) {
        write_table(file, options, to);
    } else if (to.extension() == ".npz") {
        write_psh_matrix(to, project(file, options));
    } else {
        refuse(to.string() +
               ": a material is written as .npz or into a cache folder (an existing one, or a name that ends "
               "in '/')");
    }
}

MaterialReport describe(const MaterialFile& file, const FileOptions& options) {
    MaterialReport report{.order = file.order(options),
                          .file_order = file.file_order,
                          .light = file.light,
                          .measured_wavelengths = file.measured_wavelengths,
                          .channels = {}};
    for (const IsotropicMatrix& matrix : project(file, options)) {
        const auto channel = static_cast<int>(report.channels.size());
        report.channels.push_back({describe(matrix), describe(*file.material, channel)});
    }
    return report;
}

}  // namespace nicol
