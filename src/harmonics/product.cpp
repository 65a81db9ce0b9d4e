// SPDX-License-Identifier: MIT
// Products of a scalar field and a Stokes vector field, by triple products and by a grid.
#include "harmonics/product.hpp"

#include <algorithm>
#include <numbers>

#include "harmonics/require.hpp"
#include "harmonics/spin_harmonics.hpp"
#include "harmonics/wigner3j.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;

/// Returns the number of rows that integrates the product of all three fields exactly; grid_columns() returns
/// the number of columns.
int grid_rows(int scalar_order, int field_order, int order_out) {
    for (const int order : {scalar_order, field_order, order_out}) require_order(order);
    return (scalar_order + field_order + order_out) / 2 + 1;
}
int grid_columns(int scalar_order, int field_order, int order_out) {
    return std::max(scalar_order + field_order + order_out,
                    2 * std::max({scalar_order, field_order, order_out})) +
           1;
}

}  // namespace

ShadowMatrix::ShadowMatrix(int scalar_order, int order_out, int order_in)
    : scalar_order_(scalar_order), order_out_(order_out), order_in_(order_in) {
    require(scalar_order >= 0 && scalar_order <= 2 * CoefficientMatrix::kMaxDenseOrder,
            "scalar_order is " + std::to_string(scalar_order) + ", expected 0 to " +
                std::to_string(2 * CoefficientMatrix::kMaxDenseOrder));
    (void)CoefficientMatrix(order_out, order_in);  // refuses orders out of range
    for (int lo = 0; lo <= order_out; ++lo)
        for (int mo = -lo; mo <= lo; ++mo)
            for (int li = 0; li <= order_in; ++li)
                for (int mi = -li; mi <= li; ++mi) {
                    // Exchanging the first two columns changes both symbols by the same sign.
                    const Wigner3jRun degrees = wigner_3j_run(lo, li, -mo, mi);
                    const Wigner3jRun plain = wigner_3j_run(lo, li, 0, 0);
                    const bool has_spin = lo >= 2 && li >= 2;
                    const Wigner3jRun spin = has_spin ? wigner_3j_run(lo, li, 2, -2) : plain;
                    Run run{degrees.first_l1, spin0_.size(), 0};
                    for (int l = run.first; l <= std::min(lo + li, scalar_order); ++l, ++run.count) {
                        const double scale = parity(mo) *
                                             std::sqrt((2.0 * lo + 1) * (2.0 * l + 1) * (2.0 * li + 1) /
                                                       (4 * std::numbers::pi)) *
                                             degrees.at(l);
                        spin0_.push_back(scale * plain.at(l));
                        spin2_.push_back(has_spin ? scale * spin.at(l) : 0);
                    }
                    runs_.push_back(run);
                }
}

CoefficientMatrix ShadowMatrix::expand(std::span<const double> scalar) const {
    require_size(scalar.size(), psh_count(scalar_order_), "scalar");
    nicol::require_finite(scalar, "scalar");
    const std::size_t n_out = psh_count(order_out_);
    const std::size_t n_in = psh_count(order_in_);
    std::vector<Complex> v(scalar.begin(), scalar.end());
    complex_from_real(std::vector<Complex>(v), v);
    CoefficientMatrix out(order_out_, order_in_);
    std::vector<Complex> scalar_block(n_in * n_out);  // [in][out], over complex harmonics
    std::size_t k = 0;
    for (int lo = 0; lo <= order_out_; ++lo)
        for (int mo = -lo; mo <= lo; ++mo)
            for (int li = 0; li <= order_in_; ++li)
                for (int mi = -li; mi <= li; ++mi, ++k) {
                    const Run& run = runs_[k];
                    Complex sum0 = 0;
                    Complex sum2 = 0;
                    for (int i = 0; i < run.count; ++i) {
                        const Complex value = v[psh_index(run.first + i, mo - mi)];
                        sum0 += value * spin0_[run.offset + static_cast<std::size_t>(i)];
                        sum2 += value * spin2_[run.offset + static_cast<std::size_t>(i)];
                    }
                    const std::size_t row = psh_index(lo, mo);
                    const std::size_t column = psh_index(li, mi);
                    scalar_block[column * n_out + row] = sum0;
                    out(4 * row + 1, 4 * column + 1) = out(4 * row + 2, 4 * column + 2) = sum2.real();
                    out(4 * row + 2, 4 * column + 1) = sum2.imag();
                    out(4 * row + 1, 4 * column + 2) = -sum2.imag();
                }
    // Both sides of the scalar block are converted to real harmonics: each real input is at most two complex
    // inputs.
    std::vector<Complex> unit(n_in);
    std::vector<Complex> mixed(n_in);
    std::vector<Complex> result(n_out);
    std::vector<Complex> real(n_out);
    for (int l = 0; l <= order_in_; ++l)
        for (int m = -l; m <= l; ++m) {
            unit[psh_index(l, m)] = 1;
            complex_from_real(unit, mixed);
            unit[psh_index(l, m)] = 0;
            const std::size_t a = psh_index(l, m);
            const std::size_t b = psh_index(l, -m);
            for (std::size_t i = 0; i < n_out; ++i)
                result[i] = mixed[a] * scalar_block[a * n_out + i] +
                            (m != 0 ? mixed[b] * scalar_block[b * n_out + i] : Complex());
            real_from_complex(result, real);
            for (std::size_t i = 0; i < n_out; ++i)
                out(4 * i, 4 * a) = out(4 * i + 3, 4 * a + 3) = real[i].real();
        }
    return out;
}

PshProduct::PshProduct(int scalar_order, int field_order, int order_out)
    : scalar_transform_(scalar_order, gauss_legendre_rows(grid_rows(scalar_order, field_order, order_out)),
                        grid_columns(scalar_order, field_order, order_out)),
      field_transform_(field_order, scalar_transform_.rows(), scalar_transform_.columns()),
      out_transform_(order_out, scalar_transform_.rows(), scalar_transform_.columns()),
      scalar_coefficients_(4 * psh_count(scalar_order)),
      scalar_samples_(4 * static_cast<std::size_t>(scalar_transform_.rows().count()) *
                      static_cast<std::size_t>(scalar_transform_.columns())),
      field_samples_(scalar_samples_.size()) {}

void PshProduct::multiply(std::span<const double> scalar, std::span<const double> field,
                          std::span<double> out) {
    require_size(4 * scalar.size(), scalar_coefficients_.size(), "four times scalar");
    for (std::size_t i = 0; i < scalar.size(); ++i) scalar_coefficients_[4 * i] = scalar[i];
    scalar_transform_.synthesize(scalar_coefficients_, scalar_samples_);
    field_transform_.synthesize(field, field_samples_);
    for (std::size_t i = 0; i < field_samples_.size(); i += 4)
        for (std::size_t p = 0; p < 4; ++p) field_samples_[i + p] *= scalar_samples_[i];
    out_transform_.analyze(field_samples_, out);
}

}  // namespace nicol
