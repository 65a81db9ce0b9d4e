// SPDX-License-Identifier: MIT
#include "nicol/evaluate.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "harmonics/direction.hpp"
#include "nicol/spin_harmonics.hpp"

namespace nicol {
namespace {

/// Work space for one direction after another.
class Point {
public:
    explicit Point(int order)
        : order_(order),
          scalar_(psh_count(order)),
          spin2_(psh_count(order)),
          phase_(static_cast<std::size_t>(order) + 1) {}

    void move_to(const glm::dvec3& direction) {
        const Polar polar(direction);
        spin_harmonics(0, order_, polar.half.sin, polar.half.cos, scalar_);
        spin_harmonics(2, order_, polar.half.sin, polar.half.cos, spin2_);
        phase_[0] = 1;
        if (order_ > 0) phase_[1] = polar.phase;
        for (std::size_t m = 2; m < phase_.size(); ++m) phase_[m] = phase_[m / 2] * phase_[m - m / 2];
    }

    [[nodiscard]] Stokes sum(std::span<const double> f) const {
        Stokes s(0);
        for (int m = 0; m <= order_; ++m) {
            // Sums over l of one degree first: the phase is then applied once.
            double even[2] = {0, 0};
            double odd[2] = {0, 0};
            double plus[2] = {0, 0};
            double minus[2] = {0, 0};
            for (int l = m; l <= order_; ++l) {
                const std::size_t i = psh_index(l, m);
                const std::size_t j = psh_index(l, -m);
                even[0] += scalar_[i] * f[4 * i];
                even[1] += scalar_[i] * f[4 * i + 3];
                odd[0] += scalar_[i] * f[4 * j];
                odd[1] += scalar_[i] * f[4 * j + 3];
                plus[0] += spin2_[i] * f[4 * i + 1];
                plus[1] += spin2_[i] * f[4 * i + 2];
                minus[0] += spin2_[j] * f[4 * j + 1];
                minus[1] += spin2_[j] * f[4 * j + 2];
            }
            const double c = phase_[static_cast<std::size_t>(m)].real();
            const double n = phase_[static_cast<std::size_t>(m)].imag();
            if (m == 0) {
                s += Stokes(even[0], plus[0], plus[1], even[1]);
            } else {
                s[0] += std::numbers::sqrt2 * (c * even[0] + n * odd[0]);
                s[3] += std::numbers::sqrt2 * (c * even[1] + n * odd[1]);
                s[1] += c * (plus[0] + minus[0]) - n * (plus[1] - minus[1]);
                s[2] += c * (plus[1] + minus[1]) + n * (plus[0] - minus[0]);
            }
        }
        return s;
    }

    void values(std::span<double> scalar, std::span<std::complex<double>> spin2) const {
        for (int l = 0; l <= order_; ++l)
            for (int m = 0; m <= l; ++m) {
                const std::complex<double> e = phase_[static_cast<std::size_t>(m)];
                const std::size_t i = psh_index(l, m);
                const std::size_t j = psh_index(l, -m);
                spin2[j] = spin2_[j] * std::conj(e);
                spin2[i] = spin2_[i] * e;
                scalar[j] = std::numbers::sqrt2 * scalar_[i] * e.imag();
                scalar[i] = m == 0 ? scalar_[i] : std::numbers::sqrt2 * scalar_[i] * e.real();
            }
    }

private:
    int order_;
    std::vector<double> scalar_;
    std::vector<double> spin2_;
    std::vector<std::complex<double>> phase_;
};

}  // namespace

Stokes evaluate(const PshVector& field, int channel, const glm::dvec3& direction) {
    Stokes out;
    evaluate(field, channel, {&direction, 1}, {&out, 1});
    return out;
}

void evaluate(const PshVector& field, int channel, std::span<const glm::dvec3> directions,
              std::span<Stokes> out) {
    require_size(out.size(), directions.size(), "out");
    const auto coefficients = field.channel(channel);
    require_finite(coefficients, "field");
    Point point(field.order());
    for (std::size_t i = 0; i < directions.size(); ++i) {
        point.move_to(directions[i]);
        out[i] = point.sum(coefficients);
    }
}

void harmonics_at(int order, const glm::dvec3& direction, std::span<double> scalar,
                  std::span<std::complex<double>> spin2) {
    require_order(order);
    require_size(scalar.size(), psh_count(order), "scalar");
    require_size(spin2.size(), psh_count(order), "spin2");
    Point point(order);
    point.move_to(direction);
    point.values(scalar, spin2);
}

}  // namespace nicol
