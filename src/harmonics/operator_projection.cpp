// SPDX-License-Identifier: MIT
// Projection of Mueller transform fields to coefficient matrices.
#include <cmath>
#include <numbers>

#include "harmonics/isotropic_lanes.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/spin_harmonics.hpp"
#include "harmonics/transform.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

std::vector<glm::dvec3> directions(const SphereGrid& grid) {
    std::vector<glm::dvec3> out;
    for (const double theta : grid.rows.theta)
        for (int c = 0; c < grid.columns; ++c) {
            const double phi = 2 * pi * c / grid.columns;
            out.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
        }
    return out;
}

void require_finite(const Mueller& m) {
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            require(std::isfinite(m(i, j)), "the Mueller field is not finite");
}

/// Returns M in the basis (s0, s3, w, conj w) on both sides, with w = s1 + i s2.
std::array<Complex, 16> in_complex_basis(const Mueller& m) {
    constexpr std::array<std::size_t, 2> scalar = {0, 3};
    std::array<Complex, 16> out;
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) out[4 * a + b] = m(scalar[a], scalar[b]);
        out[4 * a + 2] = 0.5 * Complex(m(scalar[a], 1), -m(scalar[a], 2));
        out[4 * a + 3] = std::conj(out[4 * a + 2]);
        out[8 + a] = Complex(m(1, scalar[a]), m(2, scalar[a]));
        out[12 + a] = std::conj(out[8 + a]);
    }
    // Isomorphic and conjugation part (Eq. 44).
    out[10] = 0.5 * Complex(m(1, 1) + m(2, 2), m(2, 1) - m(1, 2));
    out[11] = 0.5 * Complex(m(1, 1) - m(2, 2), m(2, 1) + m(1, 2));
    out[14] = std::conj(out[11]);
    out[15] = std::conj(out[10]);
    return out;
}

/// Values, at one latitude, of the harmonics of the four lanes.
class LaneHarmonics {
public:
    LaneHarmonics(int order, double sin_half, double cos_half)
        : scalar_(psh_count(order)), spin2_(psh_count(order)) {
        spin_harmonics(0, order, sin_half, cos_half, scalar_);
        spin_harmonics(2, order, sin_half, cos_half, spin2_);
    }
    [[nodiscard]] double operator()(std::size_t lane, int l, int m) const {
        return lane < 2 ? scalar_[psh_index(l, m)] : spin2_[psh_index(l, lane == 2 ? m : -m)];
    }

private:
    std::vector<double> scalar_;
    std::vector<double> spin2_;
};

std::vector<LaneHarmonics> lane_harmonics(int order, const LatitudeRows& rows) {
    std::vector<LaneHarmonics> out;
    for (std::size_t j = 0; j < rows.theta.size(); ++j)
        out.emplace_back(order, rows.sin_half[j], rows.cos_half[j]);
    return out;
}

}  // namespace

CoefficientMatrix project(const MuellerField& field, int order_out, const SphereGrid& out, int order_in,
                          const SphereGrid& in) {
    CoefficientMatrix matrix(order_out, order_in);
    PshTransform over_in(order_in, in.rows, in.columns);
    PshTransform over_out(order_out, out.rows, out.columns);
    const std::vector<glm::dvec3> from = directions(in);
    const std::vector<glm::dvec3> to = directions(out);
    const std::size_t n = matrix.columns();
    // The incoming side comes first. A row of the Mueller matrix is a Stokes vector field over the incoming
    // directions, and the wanted inner products are its coefficients.
    std::vector<double> partial(to.size() * 4 * n);
    std::vector<double> samples(4 * 4 * from.size());
    for (std::size_t o = 0; o < to.size(); ++o) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            const Mueller m = field(from[i], to[o]);
            require_finite(m);
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t q = 0; q < 4; ++q) samples[(p * from.size() + i) * 4 + q] = m(p, q);
        }
        for (std::size_t p = 0; p < 4; ++p)
            over_in.analyze(std::span(samples).subspan(p * 4 * from.size(), 4 * from.size()),
                            std::span(partial).subspan((o * 4 + p) * n, n));
    }
    std::vector<double> field_out(4 * to.size());
    std::vector<double> column(matrix.rows());
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < field_out.size(); ++k) field_out[k] = partial[k * n + j];
        over_out.analyze(field_out, column);
        for (std::size_t i = 0; i < column.size(); ++i) matrix(i, j) = column[i];
    }
    return matrix;
}

IsotropicMatrix project_isotropic(const IsotropicMuellerField& field, int order_out, const LatitudeRows& out,
                                  int order_in, const SphereGrid& in) {
    IsotropicMatrix matrix(order_out, order_in);
    const int degrees = std::min(order_out, order_in);
    require(in.columns >= 2 * degrees + 1, "columns is " + std::to_string(in.columns) +
                                               ", expected at least " + std::to_string(2 * degrees + 1));
    require(!out.theta.empty() && !in.rows.theta.empty(), "rows is empty");
    const auto y_in = lane_harmonics(order_in, in.rows);
    const auto y_out = lane_harmonics(order_out, out);
    const auto columns = static_cast<std::size_t>(in.columns);
    std::vector<Complex> turn(columns);
    for (std::size_t c = 0; c < columns; ++c)
        turn[c] = std::polar(1.0, 2 * pi * static_cast<double>(c) / in.columns);
    std::vector<IsotropicMatrix::Block> ring(columns);
    // Integral over the incoming side at one outgoing zenith angle: [m][l_in].
    std::vector<IsotropicMatrix::Block> row(psh_count(order_in));
    for (std::size_t o = 0; o < out.theta.size(); ++o) {
        std::ranges::fill(row, IsotropicMatrix::Block{});
        for (std::size_t i = 0; i < in.rows.theta.size(); ++i) {
            for (std::size_t c = 0; c < columns; ++c) {
                const Mueller m =
                    field(in.rows.theta[i], out.theta[o], 2 * pi * static_cast<double>(c) / in.columns);
                require_finite(m);
                ring[c] = in_complex_basis(m);
            }
            const double weight = in.rows.weight[i] * 2 * pi / in.columns;
            for (int m = 0; m <= degrees; ++m) {
                IsotropicMatrix::Block sum{};
                for (std::size_t c = 0; c < columns; ++c) {
                    const Complex e = turn[c * static_cast<std::size_t>(m) % columns];
                    for (std::size_t k = 0; k < 16; ++k) multiply_add(sum[k], ring[c][k], e);
                }
                for (int l = m; l <= order_in; ++l)
                    for (std::size_t k = 0; k < 16; ++k)
                        row[psh_index(l, m)][k] += weight * y_in[i](k % 4, l, m) * sum[k];
            }
        }
        const double weight = 2 * pi * out.weight[o];
        for (int m = 0; m <= degrees; ++m)
            for (int l = m; l <= order_out; ++l)
                for (int k = m; k <= order_in; ++k)
                    for (std::size_t e = 0; e < 16; ++e)
                        matrix.block(m, l, k)[e] += weight * y_out[o](e / 4, l, m) * row[psh_index(k, m)][e];
    }
    return matrix;
}

}  // namespace nicol
