// SPDX-License-Identifier: MIT
#include "specular/split_fit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "error.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/light_layout.hpp"
#include "harmonics/order_gains.hpp"
#include "harmonics/psh.hpp"
#include "material/matrix_rows.hpp"
#include "specular/high_order_factors.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
// Regularization relative to the diagonal; it keeps the factors of nearly equal taps small.
constexpr double kRidge = 1e-4;

// Replaces a symmetric positive definite matrix (row-major) by its Cholesky factor.
void factorize(std::vector<double>& a) {
    constexpr std::size_t n = kSplitUnknowns;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[j * n + j] -= a[j * n + k] * a[j * n + k];
        a[j * n + j] = std::sqrt(a[j * n + j]);
        for (std::size_t i = j + 1; i < n; ++i) {
            for (std::size_t k = 0; k < j; ++k) a[i * n + j] -= a[i * n + k] * a[j * n + k];
            a[i * n + j] /= a[j * n + j];
        }
    }
}

// Solves for four right-hand sides. a: result of factorize().
void solve(const std::vector<double>& a, std::array<SplitVector, 4>& b) {
    constexpr std::size_t n = kSplitUnknowns;
    for (SplitVector& x : b) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < i; ++k) x[i] -= a[i * n + k] * x[k];
            x[i] /= a[i * n + i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k) x[i] -= a[k * n + i] * x[k];
            x[i] /= a[i * n + i];
        }
    }
}

// Extends moments over half the circle of azimuths to the whole circle. Mirroring in the plane of incidence
// exchanges right and left and changes the sign of elements between (s0, s1) and (s2, s3).
void add_other_side(std::array<SplitVector, 4>& moments) {
    for (std::size_t p = 0; p < 4; ++p) {
        const SplitVector half = moments[p];
        for (std::size_t u = 0; u < kSplitUnknowns; ++u) {
            const std::size_t tap = u / 4;
            const std::size_t other = tap == 3 ? u + 4 : tap == 4 ? u - 4 : u;
            moments[p][u] += (p < 2) == (u % 4 < 2) ? half[other] : -half[other];
        }
    }
}

// Signs of the rotation by 90 degrees from theta-hat to phi-hat, which is the x axis of outgoing light's
// s-frame.
constexpr std::array<double, 4> kQuarterRotation{1, -1, -1, 1};

// Part of each incident component: s0, (s1, s2), s3. Taps of one part get no light of the other parts.
constexpr std::array<std::size_t, 4> kParts{0, 1, 1, 2};

}  // namespace

std::array<Tap, SplitStencil::kCount> SplitStencil::taps(double theta_out) const {
    const glm::dvec3 d(std::sin(theta_out), 0, -std::cos(theta_out));
    const glm::dvec3 x(0, 1, 0);
    const glm::dvec3 y = glm::cross(d, x);
    const double c = std::cos(spread);
    const double s = std::sin(spread);
    const auto tap = [](const glm::dvec3& direction, const glm::dvec3& x_axis, int lobe) {
        return Tap{Frame(x_axis, glm::cross(direction, x_axis), direction), lobe};
    };
    return {tap(d, x, central),
            tap(c * d + s * y, x, outer),
            tap(c * d - s * y, x, outer),
            tap(c * d + s * x, c * x - s * d, outer),
            tap(c * d - s * x, c * x + s * d, outer),
            tap({0, 0, -1}, x, static_cast<int>(kLobeWidths.size()))};
}

SplitBasis::SplitBasis(int l_low, int l_high) : l_low_(l_low), l_high_(l_high) {
    if (l_low < 0 || l_high <= l_low || l_high > kMaxOrder)
        throw Error(ErrorCode::invalid_argument,
                    "high orders from " + std::to_string(l_low) + " to " + std::to_string(l_high) +
                        "; they must ascend within 0 to " + std::to_string(kMaxOrder));
    std::vector<std::vector<double>> lobes;
    lobes.reserve(kLobeWidths.size() + 1);
    for (const double width : kLobeWidths) lobes.push_back(gaussian_gains(width, l_low + 1, l_high));
    lobes.push_back(cosine_gains(l_low + 1, l_high));
    for (const auto& lobe : lobes) {
        std::vector<double>& gain = gains_.emplace_back(lobe);
        for (std::size_t l = 0; l < gain.size(); ++l) gain[l] *= prior(static_cast<int>(l));
        kernels_.emplace_back(gain);
    }
    for (const auto& lobe : gains_) {
        for (const auto& other : lobes) {
            std::vector<double> gain = lobe;
            for (std::size_t l = 0; l < gain.size(); ++l) gain[l] *= other[l];
            products_.push_back(gain);
        }
    }
}

const std::vector<double>& SplitBasis::factor(const SplitStencil& stencil, double theta_out) const {
    const std::tuple place(theta_out, stencil.central, stencil.outer, stencil.base);
    {
        const std::scoped_lock lock(mutex_);
        const auto known = factors_.find(place);
        if (known != factors_.end()) return known->second;
    }
    const std::array<Tap, SplitStencil::kCount> taps = stencil.taps(theta_out);
    constexpr std::size_t n = kSplitUnknowns;
    std::vector<double> normal(n * n);
    for (std::size_t i = 0; i < n; i += 4) {
        for (std::size_t j = 0; j < n; j += 4) {
            const Tap& a = taps[i / 4];
            const Tap& b = taps[j / 4];
            const double cosine = glm::dot(a.frame[2], b.frame[2]);
            const TapResponse k = tap_response(a, zonal_sum(product(a.lobe, b.lobe), cosine), b.frame);
            normal[i * n + j] = k.scalar;
            if (i + 4 > n || j + 4 > n) continue;
            normal[(i + 1) * n + j + 1] = normal[(i + 2) * n + j + 2] = k.spin2.real();
            normal[(i + 2) * n + j + 1] = k.spin2.imag();
            normal[(i + 1) * n + j + 2] = -k.spin2.imag();
            normal[(i + 3) * n + j + 3] = k.scalar;
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        // The diagonal may be 0 for two reasons: a cosine has no odd orders, and spin 2 has no orders below
        // the second.
        double& diagonal = normal[i * n + i];
        diagonal = diagonal > 0 ? diagonal * (1 + kRidge) : 1;
    }
    if (!stencil.base) {
        for (std::size_t i = 0; i + 1 < n; ++i) normal[i * n + n - 1] = normal[(n - 1) * n + i] = 0;
    }
    factorize(normal);
    const std::scoped_lock lock(mutex_);
    return factors_.try_emplace(place, std::move(normal)).first->second;
}

SplitFit::SplitFit(const Material& material, const SplitBasis& basis, int channels, KnownMoments& known,
                   std::size_t columns)
    : material_(material.isotropic()),
      basis_(basis),
      channels_(channels),
      columns_(columns),
      known_(known),
      half_(material_.matrix(0) == nullptr && material_.mirror_symmetric()) {}

std::vector<std::vector<SplitFactors>> SplitFit::at(double theta_out,
                                                    std::span<const SplitStencil> stencils) const {
    // Stencils share taps, such as the base.
    std::vector<Tap> taps;
    std::vector<std::array<std::size_t, SplitStencil::kCount>> of_stencils;
    for (const SplitStencil& stencil : stencils) {
        auto& indices = of_stencils.emplace_back();
        const auto own = stencil.taps(theta_out);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto found = std::ranges::find_if(
                taps, [&](const Tap& tap) { return tap.lobe == own[i].lobe && tap.frame == own[i].frame; });
            indices[i] = static_cast<std::size_t>(found - taps.begin());
            if (found == taps.end()) taps.push_back(own[i]);
        }
    }
    const Moments moments =
        material_.matrix(0) != nullptr ? of_matrices(theta_out, taps) : integrated(theta_out, taps);

    std::vector<std::vector<SplitFactors>> out;
    for (std::size_t s = 0; s < stencils.size(); ++s) {
        std::array<const std::vector<TapRows>*, SplitStencil::kCount> projections{};
        for (std::size_t i = 0; i < projections.size(); ++i) projections[i] = &moments[of_stencils[s][i]];
        out.push_back(solved(stencils[s], theta_out, projections));
    }
    return out;
}

std::vector<SplitFactors> SplitFit::solved(
    const SplitStencil& stencil, double theta_out,
    const std::array<const std::vector<TapRows>*, SplitStencil::kCount>& projections) const {
    constexpr std::size_t n = kSplitUnknowns;
    const std::vector<double>& factor = basis_.factor(stencil, theta_out);
    std::vector<SplitFactors> out;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
        std::array<SplitVector, 4> moments{};
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t u = 0; u < n; ++u)
                moments[p][u] = kQuarterRotation[p] * (*projections[u / 4])[c][p][u % 4];
        if (half_) add_other_side(moments);
        if (!stencil.base)
            for (SplitVector& row : moments) row[n - 1] = 0;
        SplitFactors factors{moments, {}};
        solve(factor, factors.of);
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t u = 0; u < n; ++u)
                factors.energy[p][kParts[u % 4]] += factors.of[p][u] * moments[p][u];
        out.push_back(factors);
    }
    return out;
}

SplitFit::Moments SplitFit::integrated(double theta_out, std::span<const Tap> taps) const {
    const Moments of_terms = known_.at(material_, theta_out, taps, basis_.kernels(), columns_);
    Moments out(taps.size(), std::vector<TapRows>(static_cast<std::size_t>(channels_)));
    for (std::size_t i = 0; i < taps.size(); ++i)
        for (std::size_t c = 0; c < out[i].size(); ++c)
            for (std::size_t t = 0; t < of_terms[i].size(); ++t) {
                const double weight = material_.weight(static_cast<int>(t), static_cast<int>(c));
                for (std::size_t p = 0; p < 4; ++p)
                    for (std::size_t q = 0; q < 4; ++q) out[i][c][p][q] += weight * of_terms[i][t][p][q];
            }
    return out;
}

SplitFit::Moments SplitFit::of_matrices(double theta_out, std::span<const Tap> taps) const {
    Moments out(taps.size(), std::vector<TapRows>(static_cast<std::size_t>(channels_)));
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
        const IsotropicMatrix& matrix = *material_.matrix(static_cast<int>(c));
        const int order = std::min(basis_.l_high(), matrix.order_in());
        if (order <= basis_.l_low()) continue;
        const LightLayout layout(order, LightKind::full);
        const std::size_t pairings = material_.pairings();
        std::vector<double> rows(4 * pairings * layout.row_size());
        std::vector<double> numbers(layout.size());
        rows_from_matrix(matrix, theta_out, layout, pairings, rows);
        for (std::size_t p = 0; p < 4; ++p) {
            for (std::size_t i = 0; i < taps.size(); ++i) {
                const std::span<const double> gain = basis_.gains(taps[i].lobe);
                PshVector field(order, 1);
                std::ranges::fill(numbers, 0.0);
                const double* row = &rows[p * pairings * layout.row_size()];
                for (std::size_t pairing = 0; pairing < pairings; ++pairing) {
                    const bool even = (p < 2) == (pairing == 0);
                    for (const LightLayout::Run& run : layout.runs()) {
                        for (std::size_t k = 0; k < run.count; ++k) {
                            const auto l =
                                static_cast<std::size_t>(run.l) + k * static_cast<std::size_t>(run.step);
                            numbers[(even ? run.even : run.odd) + k] += gain[l] * *row++;
                        }
                    }
                }
                for (std::size_t j = 0; j < numbers.size(); ++j) {
                    for (const LightLayout::Term& term : layout.terms()[j]) {
                        field.channel(0)[term.coefficient] += term.factor * numbers[j];
                    }
                }
                const glm::dvec3 direction = taps[i].frame[2];
                const Stokes s = rotated(evaluate(field, 0, direction),
                                         angle_between(theta_phi_frame(direction), taps[i].frame));
                for (std::size_t q = 0; q < 4; ++q) out[i][c][p][q] = s[static_cast<int>(q)];
            }
        }
    }
    return out;
}

}  // namespace nicol
