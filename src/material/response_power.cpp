// SPDX-License-Identifier: MIT
#include "material/response_power.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "material/matrix_rows.hpp"
#include "material/response_table.hpp"
#include "material/row_integral.hpp"
#include "material/shared_terms.hpp"

namespace nicol {
namespace {

std::size_t part_of(LightKind kind) {
    return kind == LightKind::unpolarized ? 0 : kind == LightKind::linear ? 1 : 2;
}

// Returns the rows [channel][p][pairing][j] at an outgoing zenith angle. terms: rows of the material's terms
// there, computed if empty.
std::vector<double> rows_at(const Material& material, const LightLayout& layout, int channels, double theta,
                            std::vector<double>& terms) {
    const std::size_t set = 4 * material.pairings() * layout.row_size();
    std::vector<double> rows(set * static_cast<std::size_t>(channels));
    const auto of_channel = [&](int c) {
        return std::span(rows).subspan(set * static_cast<std::size_t>(c), set);
    };
    if (material.matrix(0) != nullptr) {
        for (int c = 0; c < channels; ++c)
            rows_from_matrix(*material.matrix(c), theta, layout, material.pairings(), of_channel(c));
        return rows;
    }
    if (terms.empty()) {
        RowIntegral integral(material, layout);
        const std::span<const double> rows_of_terms = integral.integrate(theta);
        terms.assign(rows_of_terms.begin(), rows_of_terms.end());
    }
    for (int c = 0; c < channels; ++c) {
        const std::span<double> out = of_channel(c);
        for (int t = 0; t < material.terms(); ++t) {
            const double weight = material.weight(t, c);
            const std::span<const double> term =
                std::span(terms).subspan(set * static_cast<std::size_t>(t), set);
            for (std::size_t i = 0; i < set; ++i) out[i] += weight * term[i];
        }
    }
    return rows;
}

}  // namespace

ResponsePower::ResponsePower(const Material& material, int order, LightKind kind, int channels,
                             KnownTerms& known)
    : of_(static_cast<std::size_t>(ResponseTable::channels_for(material, channels))) {
    for (Channel& channel : of_)
        for (auto& output : channel) output.fill(Spectrum(static_cast<std::size_t>(order) + 1));
    const LightLayout layout(order, kind);
    std::array<std::vector<double>, kAngles> rows, own;
    const std::string key = terms_key(material);
    std::array<std::vector<double>, kAngles>& terms = key.empty() ? own : known[key];
    tbb::parallel_for(std::size_t{0}, kAngles, [&](std::size_t k) {
        const double cosine = std::sqrt((static_cast<double>(k) + 0.5) / kAngles);
        rows[k] = rows_at(material, layout, this->channels(), std::acos(cosine), terms[k]);
    });
    for (const std::vector<double>& angle : rows) {
        const double* row = angle.data();
        for (Channel& channel : of_) {
            for (std::size_t i = 0; i < 4 * material.pairings(); ++i, row += layout.row_size()) {
                const std::size_t p = i / material.pairings();
                if (p == 3) continue;
                const double* value = row;
                for (const LightLayout::Run& run : layout.runs()) {
                    Spectrum& spectrum = channel[p == 0 ? 0 : 1][part_of(run.part)];
                    for (std::size_t k = 0; k < run.count; ++k, ++value) {
                        const auto l =
                            static_cast<std::size_t>(run.l) + k * static_cast<std::size_t>(run.step);
                        spectrum[l] += *value * *value / kAngles;
                    }
                }
            }
        }
    }
}

}  // namespace nicol
