// SPDX-License-Identifier: MIT
#include "specular/high_order_factors.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "material/adaptive_rows.hpp"
#include "material/response_table.hpp"
#include "specular/split_fit.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
// Fraction of the s0 energy that is negligible: two percent in amplitude.
constexpr double kNegligible = 4e-4;
// Error of interpolated factors, relative to the largest factor.
constexpr float kInterpolated = 1e-3F;
constexpr auto kAngleCount = static_cast<std::size_t>(HighOrderFactors::kAngles);

double zenith(std::size_t angle) {
    // The factors have a limit at 90 degrees, but the formulas of most materials are 0/0 there.
    return std::min(std::acos(static_cast<double>(angle) / (kAngleCount - 1)), pi / 2 - 1e-3);
}

// Returns the elements of a pairing in their stored order, from the factors of each tap.
std::array<double, HighOrderFactors::kElements> elements_of(const SplitFactors& factors,
                                                            std::size_t pairing) {
    const auto f = [&](std::size_t tap, std::size_t row, std::size_t column) {
        return factors.of[pairing == 0 ? row : row ^ 2U][4 * tap + column];
    };
    const auto even = [&](std::size_t tap, std::size_t row, std::size_t column) {
        return tap < 3 ? f(tap, row, column) : (f(3, row, column) + f(4, row, column)) / 2;
    };
    const auto odd = [&](std::size_t row, std::size_t column) {
        return (f(3, row, column) - f(4, row, column)) / 2;
    };
    std::array<double, HighOrderFactors::kElements> out{};
    std::size_t i = 0;
    for (std::size_t tap = 0; tap < 4; ++tap) {
        out[i++] = even(tap, 0, 0);
        out[i++] = even(tap, 1, 0);
    }
    out[i++] = odd(2, 0);
    out[i++] = odd(3, 0);
    out[i++] = f(5, 0, 0);
    out[i++] = f(5, 1, 0);
    constexpr std::size_t rest[6][2] = {{0, 1}, {1, 1}, {2, 2}, {3, 2}, {2, 3}, {3, 3}};
    for (std::size_t tap = 0; tap < 4; ++tap)
        for (const auto& [row, column] : rest) out[i++] = even(tap, row, column);
    constexpr std::size_t odd_rest[6][2] = {{0, 2}, {1, 2}, {2, 1}, {3, 1}, {0, 3}, {1, 3}};
    for (const auto& [row, column] : odd_rest) out[i++] = odd(row, column);
    return out;
}

// Energy of the response to unpolarized light that the taps represent, by channel, for s0, s1 and s2.
using Energy = std::vector<std::array<double, 3>>;

// Returns the energies [stencil].
std::vector<Energy> caught(const SplitFit& fit, const std::vector<SplitStencil>& stencils) {
    // Angles are weighted by their projected area on a sphere.
    constexpr std::size_t samples = 6;
    std::array<std::vector<std::vector<SplitFactors>>, samples> factors;
    tbb::parallel_for(std::size_t{0}, samples, [&](std::size_t k) {
        const double cosine = std::sqrt((static_cast<double>(k) + 0.5) / samples);
        factors[k] = fit.at(std::acos(cosine), stencils);
    });
    std::vector<Energy> sum(stencils.size());
    for (const auto& of_angle : factors)
        for (std::size_t s = 0; s < stencils.size(); ++s) {
            sum[s].resize(of_angle[s].size());
            for (std::size_t c = 0; c < sum[s].size(); ++c)
                for (std::size_t p = 0; p < 3; ++p)
                    for (const double energy : of_angle[s][c].energy[p]) sum[s][c][p] += energy;
        }
    return sum;
}

// Returns the lobes and spread that represent the most energy. Each Stokes component counts relative to the
// largest energy of that component among all candidates.
SplitStencil best_stencil(const SplitFit& fit) {
    std::vector<SplitStencil> candidates;
    for (int outer = 1; outer < static_cast<int>(kLobeWidths.size()); ++outer)
        for (int central = 0; central <= outer; ++central)
            candidates.push_back({central, outer, kLobeWidths[static_cast<std::size_t>(outer)]});
    const std::vector<Energy> energy = caught(fit, candidates);
    std::array<double, 3> most{};
    const auto total = [](const Energy& e, std::size_t p) {
        double sum = 0;
        for (const auto& channel : e) sum += channel[p];
        return sum;
    };
    for (const Energy& e : energy)
        for (std::size_t p = 0; p < 3; ++p) most[p] = std::max(most[p], total(e, p));
    const auto score = [&](const Energy& e) {
        double sum = 0;
        for (std::size_t p = 0; p < 3; ++p) sum += most[p] > 0 ? total(e, p) / most[p] : 0;
        return sum;
    };
    const auto best = static_cast<std::size_t>(std::ranges::max_element(energy, {}, score) - energy.begin());

    // A metal does not need the tap at -n, which represents diffuse bases.
    SplitStencil stencil = candidates[best];
    stencil.base = false;
    const Energy without = caught(fit, {stencil}).front();
    for (std::size_t c = 0; c < without.size(); ++c)
        stencil.base = stencil.base || without[c][0] < (1 - kNegligible) * energy[best][c][0];
    return stencil;
}

}  // namespace

HighOrderFactors HighOrderFactors::mirror() {
    HighOrderFactors out;
    out.data_.resize(kElements * kAngleCount);
    for (std::size_t angle = 0; angle < kAngleCount; ++angle) {
        float* f = &out.data_[angle * kElements];
        f[0] = f[kUnpolarized + 1] = 1;
        f[kUnpolarized + 2] = f[kUnpolarized + 5] = -1;
    }
    return out;
}

std::optional<HighOrderFactors> HighOrderFactors::stored(int channels, std::size_t pairings, int central_lobe,
                                                         int outer_lobe, bool has_base,
                                                         std::vector<float> data) {
    constexpr int lobes = static_cast<int>(kLobeWidths.size());
    const bool fits =
        channels >= 1 && (pairings == 1 || pairings == 2) && central_lobe >= 0 &&
        central_lobe <= outer_lobe && outer_lobe < lobes &&
        data.size() == pairings * kElements * kAngleCount * static_cast<std::size_t>(channels) &&
        std::ranges::all_of(data, [](float value) { return std::isfinite(value); });
    if (!fits) return std::nullopt;
    HighOrderFactors out;
    out.channels_ = channels;
    out.pairings_ = pairings;
    out.central_lobe_ = central_lobe;
    out.outer_lobe_ = outer_lobe;
    out.spread_ = kLobeWidths[static_cast<std::size_t>(outer_lobe)];
    out.has_base_ = has_base;
    out.data_ = std::move(data);
    return out;
}

HighOrderFactors::HighOrderFactors(const Material& material, const SplitBasis& basis, int channels,
                                   KnownMoments* known)
    : channels_(ResponseTable::channels_for(material, channels)), pairings_(material.pairings()) {
    KnownMoments own;
    const SplitFit fit(material, basis, channels_, known != nullptr ? *known : own);
    const SplitStencil stencil = best_stencil(fit);
    central_lobe_ = stencil.central;
    outer_lobe_ = stencil.outer;
    spread_ = stencil.spread;
    has_base_ = stencil.base;
    const auto count = static_cast<std::size_t>(channels_);
    data_.resize(pairings_ * kElements * kAngleCount * count);
    const AngleTable table{
        .data = data_, .last = kAngles - 1, .widest_step = 16, .least_step = 1, .tolerance = kInterpolated};
    fill_adaptively(table, [&](std::span<const int> angles) {
        tbb::parallel_for(std::size_t{0}, angles.size(), [&](std::size_t i) {
            const auto factors =
                fit.at(zenith(static_cast<std::size_t>(angles[i])), std::span(&stencil, 1)).front();
            float* to = table.row(angles[i]).data();
            for (std::size_t c = 0; c < count; ++c)
                for (std::size_t pairing = 0; pairing < pairings_; ++pairing)
                    for (const double element : elements_of(factors[c], pairing))
                        *to++ = static_cast<float>(element);
        });
    });
}

std::vector<float> HighOrderFactors::texels(int first_channel, int count, bool polarized) const {
    const auto elements = static_cast<std::size_t>(polarized ? kElements : kUnpolarized);
    std::vector<float> out(4 * pairings_ * elements * kAngleCount);
    for (std::size_t angle = 0; angle < kAngleCount; ++angle) {
        for (int i = 0; i < count; ++i) {
            const float* from = row(angle, channels_ == 1 ? 0 : static_cast<std::size_t>(first_channel + i));
            for (std::size_t pairing = 0; pairing < pairings_; ++pairing) {
                for (std::size_t e = 0; e < elements; ++e) {
                    const std::size_t line = pairing * elements + e;
                    out[4 * (line * kAngleCount + angle) + static_cast<std::size_t>(i)] =
                        from[pairing * kElements + e];
                }
            }
        }
    }
    return out;
}

}  // namespace nicol
