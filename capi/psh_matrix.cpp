// SPDX-License-Identifier: MIT
// Operators as dense coefficient matrices.
#include <algorithm>
#include <cmath>

#include "harmonics/operator.hpp"
#include "harmonics/product.hpp"
#include "initialiser.hpp"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

constexpr std::uint32_t kMaxSamples = 4096;

int read_matrix_order(std::uint32_t order, const char* name) {
    return read_order(order, name, NICOL_PSH_MAX_MATRIX_ORDER);
}

std::span<const double> read_matrix(const double* values, std::uint64_t count, int order_out, int order_in,
                                    const char* name) {
    return read_array(values, count, vector_size(order_out), vector_size(order_in), name);
}

std::span<double> write_matrix(double* values, std::uint64_t count, int order_out, int order_in,
                               const char* name) {
    return write_array(values, count, vector_size(order_out), vector_size(order_in), name);
}

CoefficientMatrix matrix_from(std::span<const double> values, int order_out, int order_in) {
    CoefficientMatrix m(order_out, order_in);
    std::ranges::copy(values, m.data().begin());
    return m;
}

int read_samples(std::uint32_t given, std::uint32_t least, std::uint32_t fallback, const char* name) {
    const std::uint32_t count = given == 0 ? fallback : given;
    if (count < least || count > kMaxSamples) {
        refuse("field->" + std::string(name) + " is " + std::to_string(count) + "; it must lie in " +
               std::to_string(least) + " to " + std::to_string(kMaxSamples));
    }
    return static_cast<int>(count);
}

Mueller value(const nicol_psh_mueller_field& field, const glm::dvec3& in, const glm::dvec3& out) {
    std::array<double, 16> m{};
    const double from[3] = {in.x, in.y, in.z};
    const double to[3] = {out.x, out.y, out.z};
    if (field.callback(field.user, from, to, m.data()) == 0)
        throw Error(ErrorCode::cancelled, "field->callback returned 0");
    if (!std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); })) {
        refuse("field->callback gave a Mueller matrix that is not finite for the directions (" +
               std::to_string(in.x) + ", " + std::to_string(in.y) + ", " + std::to_string(in.z) + ") to (" +
               std::to_string(out.x) + ", " + std::to_string(out.y) + ", " + std::to_string(out.z) + ")");
    }
    return Mueller(m);
}

CoefficientMatrix project_field(const nicol_psh_mueller_field& field, int order_out, int order_in) {
    const std::uint32_t o = field.order_out;
    const std::uint32_t i = field.order_in;
    const int rows_out = read_samples(field.rows_out, 1, 2 * o + 2, "rows_out");
    const int rows_in = read_samples(field.rows_in, 1, 2 * i + 2, "rows_in");
    if (field.isotropic != 0) {
        if (field.columns_out != 0)
            refuse("field->columns_out is set, but `out` of an isotropic field is not rotated");
        const int columns = read_samples(field.columns_in, 2 * std::min(o, i) + 1, 4 * i + 4, "columns_in");
        const auto at = [&](double theta_in, double theta_out, double phi) {
            return value(
                field,
                {std::sin(theta_in) * std::cos(phi), std::sin(theta_in) * std::sin(phi), std::cos(theta_in)},
                {std::sin(theta_out), 0, std::cos(theta_out)});
        };
        return project_isotropic(at, order_out, gauss_legendre_rows(rows_out), order_in,
                                 {gauss_legendre_rows(rows_in), columns})
            .dense();
    }
    const int columns_out = read_samples(field.columns_out, 2 * o + 1, 4 * o + 4, "columns_out");
    const int columns_in = read_samples(field.columns_in, 2 * i + 1, 4 * i + 4, "columns_in");
    const std::uint64_t work = static_cast<std::uint64_t>(rows_out) *
                               static_cast<std::uint64_t>(columns_out) * 4 * vector_size(order_in) *
                               sizeof(double);
    if (work > kMaxWorkBytes) {
        refuse("field->rows_out x field->columns_out is " + std::to_string(rows_out) + " x " +
               std::to_string(columns_out) + "; that takes " + std::to_string(work) +
               " bytes of work space, at most " + std::to_string(kMaxWorkBytes) + " are given");
    }
    const auto at = [&](const glm::dvec3& in, const glm::dvec3& out) { return value(field, in, out); };
    return nicol::project(at, order_out, {gauss_legendre_rows(rows_out), columns_out}, order_in,
                          {gauss_legendre_rows(rows_in), columns_in});
}

}  // namespace

nicol_result nicol_psh_shadow_matrix(uint32_t scalar_order, const double* scalar, uint64_t scalar_count,
                                     uint32_t order_out, uint32_t order_in, double* matrix,
                                     uint64_t matrix_count) {
    return guarded([&] {
        const int scalar_highest = read_order(scalar_order, "scalar_order", 2 * NICOL_PSH_MAX_MATRIX_ORDER);
        const int out = read_matrix_order(order_out, "order_out");
        const int in = read_matrix_order(order_in, "order_in");
        const auto factor = read_array(scalar, scalar_count, 1, psh_count(scalar_highest), "scalar");
        const auto to = write_matrix(matrix, matrix_count, out, in, "matrix");
        const CoefficientMatrix shadow = ShadowMatrix(scalar_highest, out, in).expand(factor);
        std::ranges::copy(shadow.data(), to.begin());
    });
}

nicol_result nicol_psh_project_matrix(const nicol_psh_mueller_field* field, double* matrix,
                                      uint64_t matrix_count) {
    return guarded([&] {
        const nicol_psh_mueller_field given =
            read_struct(field, nicol_psh_mueller_field NICOL_PSH_MUELLER_FIELD_INIT, "field");
        if (given.isotropic > 1)
            refuse("field->isotropic is " + std::to_string(given.isotropic) + "; it must be 0 or 1");
        if (given.callback == nullptr) refuse("field->callback is NULL");
        const int out = read_matrix_order(given.order_out, "field->order_out");
        const int in = read_matrix_order(given.order_in, "field->order_in");
        const auto to = write_matrix(matrix, matrix_count, out, in, "matrix");
        const CoefficientMatrix projected = project_field(given, out, in);
        std::ranges::copy(projected.data(), to.begin());
    });
}

nicol_result nicol_psh_apply_matrix(uint32_t order_out, uint32_t order_in, const double* matrix,
                                    uint64_t matrix_count, uint64_t vectors, const double* in,
                                    uint64_t in_count, double* out, uint64_t out_count) {
    return guarded([&] {
        const int highest_out = read_matrix_order(order_out, "order_out");
        const int highest_in = read_matrix_order(order_in, "order_in");
        const auto values = read_matrix(matrix, matrix_count, highest_out, highest_in, "matrix");
        const std::size_t size_in = vector_size(highest_in);
        const std::size_t size_out = vector_size(highest_out);
        const auto from = read_array(in, in_count, vectors, size_in, "in");
        const auto to = write_array(out, out_count, vectors, size_out, "out");
        require_apart(from, to, "in and out");
        require_apart(values, to, "matrix and out");
        // Each row is applied to all vectors, so the matrix is read once and not copied.
        for (std::size_t row = 0; row < size_out; ++row) {
            const double* m = values.data() + row * size_in;
            for (std::size_t v = 0; v < vectors; ++v) {
                const double* f = from.data() + v * size_in;
                double sum[4] = {0, 0, 0, 0};
                for (std::size_t k = 0; k < size_in; k += 4)
                    for (std::size_t p = 0; p < 4; ++p) sum[p] += m[k + p] * f[k + p];
                to[v * size_out + row] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
            }
        }
    });
}

nicol_result nicol_psh_compose_matrix(uint32_t order_out, uint32_t order_between, uint32_t order_in,
                                      const double* second, uint64_t second_count, const double* first,
                                      uint64_t first_count, double* matrix, uint64_t matrix_count) {
    return guarded([&] {
        const int out = read_matrix_order(order_out, "order_out");
        const int between = read_matrix_order(order_between, "order_between");
        const int in = read_matrix_order(order_in, "order_in");
        const auto a = read_matrix(second, second_count, out, between, "second");
        const auto b = read_matrix(first, first_count, between, in, "first");
        const auto to = write_matrix(matrix, matrix_count, out, in, "matrix");
        const CoefficientMatrix both = compose(matrix_from(a, out, between), matrix_from(b, between, in));
        std::ranges::copy(both.data(), to.begin());
    });
}

NICOL_INITIALISER(nicol_psh_mueller_field, NICOL_PSH_MUELLER_FIELD_INIT)
