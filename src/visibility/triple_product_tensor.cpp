// SPDX-License-Identifier: MIT
#include "visibility/triple_product_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/mirror_harmonics.hpp"
#include "simd/dispatch.hpp"
#include "visibility/shadow_matrix_lanes.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

using Harmonic = LightLayout::Harmonic;

// Returns the integral over phi of three factors, each cos m phi for m >= 0 or sin |m| phi.
double phi_integral(int a, int b, int c) {
    const int sines = (a < 0 ? 1 : 0) + (b < 0 ? 1 : 0) + (c < 0 ? 1 : 0);
    if (sines % 2 != 0) return 0;
    // cos cos = (cos(a - b) + cos(a + b)) / 2 and so on. Equal frequencies integrate to pi, or to 2 pi for
    // frequency 0; different frequencies integrate to 0.
    const auto meet = [](int k, int m) { return k != m ? 0.0 : k == 0 ? 2 * pi : pi; };
    const int x = std::abs(a);
    const int y = std::abs(b);
    const int z = std::abs(c);
    const int difference = std::abs(x - y);
    if (sines == 0) return (meet(difference, z) + meet(x + y, z)) / 2;
    if (c >= 0) return (meet(difference, z) - meet(x + y, z)) / 2;  // sin sin cos
    // One sine of a and b with the sine of c: sin x cos y = (sin(x + y) + sin(x - y)) / 2.
    const int signed_difference = a < 0 ? x - y : y - x;
    const double other = signed_difference > 0   ? meet(difference, z)
                         : signed_difference < 0 ? -meet(difference, z)
                                                 : 0.0;
    return (meet(x + y, z) + other) / 2;
}

[[gnu::always_inline]] inline void sum_terms(const std::uint32_t* first, std::size_t elements,
                                             const std::uint32_t* coefficient, const float* value,
                                             const Lanes* visibility, Lanes* matrix) {
    for (std::size_t e = 0; e < elements; ++e) {
        Lanes sum{};
        for (std::uint32_t t = first[e]; t < first[e + 1]; ++t) {
            const Lanes& v = visibility[coefficient[t]];
            const float factor = value[t];
            for (std::size_t i = 0; i < kLanes; ++i) sum.value[i] += factor * v.value[i];
        }
        matrix[e] = sum;
    }
}

const std::vector<Harmonic>& harmonics_of(const LightLayout& layout, TripleProductTensor::Group group) {
    if (group == TripleProductTensor::Group::spin) return layout.spin();
    return group == TripleProductTensor::Group::even ? layout.even() : layout.odd();
}

// Returns the integral of <a, b> times the visibility harmonic c.
double triple(const UpperRows& rows, const SeparatedHarmonic& a, const SeparatedHarmonic& b,
              const SeparatedHarmonic& c) {
    const double first = phi_integral(a.m, b.m, c.m);
    const double second =
        a.second.empty() ? 0.0 : phi_integral(other_trigonometric(a.m), other_trigonometric(b.m), c.m);
    if (first == 0 && second == 0) return 0;
    double sum = 0;
    for (std::size_t j = 0; j < rows.count(); ++j) {
        double dot = first * a.first[j] * b.first[j];
        if (second != 0) dot += second * a.second[j] * b.second[j];
        sum += rows.weight(j) * dot * c.first[j];
    }
    return sum;
}

}  // namespace

TripleProductTensor::TripleProductTensor(Group group, const LightLayout& layout, int visibility_order) {
    const std::vector<Harmonic>& harmonics = harmonics_of(layout, group);
    size_ = harmonics.size();
    const UpperRows grid((2 * highest_order(harmonics) + visibility_order) / 2 + 1);
    const auto separate = group == Group::spin ? separate_spins : separate_scalars;
    const std::vector<SeparatedHarmonic> factors = separate(harmonics, grid);
    std::vector<Harmonic> all;
    for (int l = 0; l <= visibility_order; ++l) {
        for (int m = -l; m <= l; ++m) all.push_back({l, m});
    }
    const std::vector<SeparatedHarmonic> visibility = separate_scalars(all, grid);

    for (const auto& [row, column] : shadow_elements(size_)) {
        first_.push_back(static_cast<std::uint32_t>(value_.size()));
        const Harmonic& x = harmonics[row];
        const Harmonic& y = harmonics[column];
        for (std::size_t c = 0; c < all.size(); ++c) {
            const Harmonic& z = all[c];
            const int degree = std::abs(z.m);
            const bool meets =
                degree == std::abs(x.m) + std::abs(y.m) || degree == std::abs(std::abs(x.m) - std::abs(y.m));
            if (!meets || (z.l + z.m) % 2 != 0 || z.l < std::abs(x.l - y.l) || z.l > x.l + y.l) continue;
            const double value = triple(grid, factors[row], factors[column], visibility[c]);
            if (std::abs(value) < 1e-13) continue;
            coefficient_.push_back(static_cast<std::uint32_t>(c));
            value_.push_back(static_cast<float>(value));
        }
    }
    first_.push_back(static_cast<std::uint32_t>(value_.size()));
}

void TripleProductTensor::make(const Lanes* visibility, Lanes* matrix) const {
    dispatch<sum_terms>(first_.data(), elements(), coefficient_.data(), value_.data(), visibility, matrix);
}

}  // namespace nicol
