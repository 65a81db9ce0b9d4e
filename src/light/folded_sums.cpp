// SPDX-License-Identifier: MIT
// Discrete Fourier sums of rows that are folded twice about their mirror axes and then summed degree by
// degree.
#include "light/folded_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "harmonics/low_degrees.hpp"

namespace nicol {
namespace {

constexpr std::size_t kBlock = 64;

/// Vector of four doubles in two halves, because every processor has vectors of two.
struct Four {
    using Half = double __attribute__((vector_size(16)));
    Half low, high;

    Four operator+(const Four& o) const { return {low + o.low, high + o.high}; }
    Four operator-(const Four& o) const { return {low - o.low, high - o.high}; }
};

inline Four pixel(const FourRows& rows, std::size_t column) {
    const std::size_t at = column * rows.stride;
    return {Four::Half{double{rows.first[0][at]}, double{rows.first[1][at]}},
            Four::Half{double{rows.first[2][at]}, double{rows.first[3][at]}}};
}

inline void store(double* to, const Four& v) {
    std::memcpy(to, &v.low, sizeof v.low);
    std::memcpy(to + 2, &v.high, sizeof v.high);
}

}  // namespace

FoldedSums::FoldedSums(int order, int columns)
    : order_(order),
      columns_(static_cast<std::size_t>(columns)),
      folded_(16 * kBlock),
      sums_(8 * (static_cast<std::size_t>(order) + 1)) {
    const std::size_t quarter = columns_ / 4;
    for (std::size_t first = 0; first < quarter; first += kBlock)
        for (int m = 0; m <= order; ++m)
            for (std::size_t c = first; c < std::min(first + kBlock, quarter); ++c) {
                // The angle is counted in half columns, so that it is reduced exactly.
                const long long step = m * (2 * static_cast<long long>(c) + 1) % (2LL * columns);
                const double angle = std::numbers::pi * static_cast<double>(step) / columns;
                table_.push_back(std::cos(angle));
                table_.push_back(std::sin(angle));
            }
}

void FoldedSums::fold(const FourRows& rows, std::size_t first, std::size_t count) {
    double* even_cosine = folded_.data();
    double* odd_cosine = even_cosine + 4 * count;
    double* even_sine = odd_cosine + 4 * count;
    double* odd_sine = even_sine + 4 * count;
    for (std::size_t i = 0; i < count; ++i) {
        // Pixels at the angles a, pi - a, pi + a and 2 pi - a.
        const std::size_t at = first + i;
        const Four a = pixel(rows, at);
        const Four b = pixel(rows, columns_ / 2 - 1 - at);
        const Four c = pixel(rows, columns_ / 2 + at);
        const Four d = pixel(rows, columns_ - 1 - at);
        store(even_cosine + 4 * i, (a + d) + (b + c));
        store(odd_cosine + 4 * i, (a + d) - (b + c));
        store(even_sine + 4 * i, (a - d) - (b - c));
        store(odd_sine + 4 * i, (a - d) + (b - c));
    }
}

std::span<const double> FoldedSums::operator()(const FourRows& rows) {
    std::ranges::fill(sums_, 0.0);
    const double* table = table_.data();
    for (std::size_t first = 0; first < columns_ / 4; first += kBlock) {
        const std::size_t count = std::min(kBlock, columns_ / 4 - first);
        fold(rows, first, count);
        add_low_degrees(folded_.data(), static_cast<int>(count), table, order_ + 1, sums_.data());
        table += 2 * count * (static_cast<std::size_t>(order_) + 1);
    }
    return sums_;
}

}  // namespace nicol
