// SPDX-License-Identifier: MIT
#include "material/response_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "error.hpp"
#include "harmonics/spin_harmonics.hpp"
#include "material/adaptive_rows.hpp"
#include "material/matrix_rows.hpp"
#include "material/row_integral.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
constexpr int kLast = ResponseTable::kAngles - 1;
// Steps between the angles that are always integrated, and between the closest that are.
constexpr int kWidestStep = 32;
constexpr int kStep = 2;
// Error of an interpolated row, relative to the table's largest number, up to which the row is not
// integrated.
constexpr float kInterpolated = 1e-4F;

bool is_grey(const Material& material, int channels) {
    if (material.matrix(0) != nullptr) return false;
    for (int term = 0; term < material.terms(); ++term) {
        for (int c = 1; c < channels; ++c) {
            if (material.weight(term, c) != material.weight(term, 0)) return false;
        }
    }
    return true;
}

}  // namespace

int ResponseTable::channels_for(const Material& material, int channels) {
    if (channels < 1 || (material.channels() != 1 && material.channels() != channels)) {
        throw Error(ErrorCode::invalid_argument, "a material of " + std::to_string(material.channels()) +
                                                     " channels cannot serve a scene of " +
                                                     std::to_string(channels) +
                                                     "; it must have 1 or as many");
    }
    return material.channels() == 1 || is_grey(material, channels) ? 1 : channels;
}

ResponseTable::ResponseTable(const Material& material, const LightLayout& layout, int channels,
                             KnownRows* known)
    : pairings_(material.pairings()),
      row_size_(pairings_ * layout.row_size()),
      channels_(channels_for(material, channels)),
      angles_(kAngles) {
    data_.resize(kAngles * 4 * row_size_ * static_cast<std::size_t>(channels_));
    if (material.matrix(0) != nullptr) {
        rows_of_matrices(material, layout);
    } else {
        integrate(material, layout, known);
    }
    find_makes();
}

ResponseTable::ResponseTable(const LightLayout& layout, int channels, std::size_t pairings,
                             std::vector<float> data)
    : ResponseTable(layout, channels, pairings, kAngles, std::move(data)) {}

ResponseTable::ResponseTable(const LightLayout& layout, int channels, std::size_t pairings, int angles,
                             std::vector<float> data)
    : pairings_(pairings),
      row_size_(pairings * layout.row_size()),
      channels_(channels),
      angles_(angles),
      data_(std::move(data)) {
    if (channels < 1 ||
        data_.size() != static_cast<std::size_t>(angles) * 4 * row_size_ * static_cast<std::size_t>(channels))
        throw Error(ErrorCode::invalid_argument,
                    "the data of a response table has " + std::to_string(data_.size()) +
                        " numbers, which is not what its layout and channels need");
    find_makes();
}

ResponseTable ResponseTable::of_outgoing_light(const LightLayout& layout) {
    const std::size_t n = layout.row_size();
    std::vector<double> scalar(psh_count(layout.order()));
    std::vector<double> spin2(psh_count(layout.order()));
    std::vector<double> first(n);
    std::vector<double> second(n);
    std::vector<float> data(kOutgoingAngles * 4 * n);
    for (int angle = 0; angle < kOutgoingAngles; ++angle) {
        const double theta = angle * (pi / 2) / (kOutgoingAngles - 1);
        spin_harmonics(0, layout.order(), theta, scalar);
        spin_harmonics(2, layout.order(), theta, spin2);
        zenith_functions(layout, scalar, spin2, first, second);
        float* s0 = &data[static_cast<std::size_t>(angle) * 4 * n];
        std::size_t j = 0;
        for (const LightLayout::Run& run : layout.runs()) {
            for (const std::size_t end = j + run.count; j < end; ++j) {
                const auto value = static_cast<float>(first[j]);
                if (run.part == LightKind::unpolarized) s0[j] = value;
                if (run.part == LightKind::full) s0[3 * n + j] = value;
                if (run.part != LightKind::linear) continue;
                s0[n + j] = value;
                s0[2 * n + j] = -run.sign * static_cast<float>(second[j]);
            }
        }
    }
    return {layout, 1, 1, kOutgoingAngles, std::move(data)};
}

void ResponseTable::find_makes() {
    for (std::size_t row = 0; (row + 1) * row_size_ <= data_.size(); ++row) {
        bool& makes = makes_[row % 4];
        const auto values = std::span(data_).subspan(row * row_size_, row_size_);
        makes = makes || std::ranges::any_of(values, [](float value) { return value != 0; });
    }
}

void ResponseTable::integrate(const Material& material, const LightLayout& layout, KnownRows* known) {
    const AngleTable table{.data = data_,
                           .last = kLast,
                           .widest_step = kWidestStep,
                           .least_step = kStep,
                           .tolerance = kInterpolated};
    fill_adaptively(table,
                    [&](std::span<const int> angles) { integrate(material, layout, known, table, angles); });
}

void ResponseTable::integrate(const Material& material, const LightLayout& layout, KnownRows* known,
                              const AngleTable& table, std::span<const int> angles) const {
    const std::size_t set = 4 * row_size_;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, angles.size()), [&](const auto& range) {
        RowIntegral integral(material, layout);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            // Most materials' formulas are 0/0 at 90 degrees, although the rows have a limit there.
            const double theta = std::min(angles[i] * (pi / 2) / kLast, pi / 2 - 1e-6);
            std::vector<double>* const kept =
                known == nullptr ? nullptr : &(*known)[static_cast<std::size_t>(angles[i])];
            const bool is_known = kept != nullptr && !kept->empty();
            const std::span<const double> of_terms = is_known ? *kept : integral.integrate(theta);
            if (kept != nullptr && !is_known) kept->assign(of_terms.begin(), of_terms.end());
            const double* rows = of_terms.data();
            std::ranges::fill(table.row(angles[i]), 0.0F);
            for (int term = 0; term < material.terms(); ++term, rows += set) {
                float* out = table.row(angles[i]).data();
                for (int c = 0; c < channels_; ++c, out += set) {
                    const double weight = material.weight(term, c);
                    if (weight == 0) continue;
                    for (std::size_t j = 0; j < set; ++j) out[j] += static_cast<float>(weight * rows[j]);
                }
            }
        }
    });
}

void ResponseTable::rows_of_matrices(const Material& material, const LightLayout& layout) {
    tbb::parallel_for(tbb::blocked_range<int>(0, kAngles), [&](const tbb::blocked_range<int>& range) {
        std::vector<double> rows(4 * row_size_);
        for (int angle = range.begin(); angle < range.end(); ++angle) {
            for (int c = 0; c < channels_; ++c) {
                rows_from_matrix(*material.matrix(c), angle * (pi / 2) / (kAngles - 1), layout, pairings_,
                                 rows);
                const auto at = static_cast<std::size_t>(angle * channels_ + c) * rows.size();
                for (std::size_t j = 0; j < rows.size(); ++j) data_[at + j] = static_cast<float>(rows[j]);
            }
        }
    });
}

}  // namespace nicol
