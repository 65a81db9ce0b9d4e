// SPDX-License-Identifier: MIT
#include "harmonics/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "harmonics/require.hpp"
#include "harmonics/scaled.hpp"
#include "harmonics/spin_harmonics.hpp"
#include "harmonics/transform.hpp"

namespace nicol {
namespace {

/// Half-angle functions of theta and exp(i phi), computed without inverse functions and accurate next to both
/// poles; phi is 0 on the axis. Throws Error(invalid_argument) for a direction that is zero or not finite.
struct Polar {
    HalfAngle half;
    std::complex<double> phase;

    explicit Polar(const glm::dvec3& direction) {
        const double largest =
            std::fmax(std::abs(direction.x), std::fmax(std::abs(direction.y), std::abs(direction.z)));
        require(largest > 0 && std::isfinite(direction.x) && std::isfinite(direction.y) &&
                    std::isfinite(direction.z),
                "direction is zero or not finite");
        const double x = direction.x / largest;
        const double y = direction.y / largest;
        const double z = direction.z / largest;
        const double rho = std::hypot(x, y);
        const double length = std::hypot(rho, z);
        // The larger of the two comes from a square root, the smaller from their product sin(theta) / 2.
        const double large = std::sqrt((1 + std::abs(z) / length) / 2);
        const double small = rho / length / (2 * large);
        half = z >= 0 ? HalfAngle{small, large} : HalfAngle{large, small};
        phase = rho > 0 ? std::complex(x / rho, y / rho) : std::complex(1.0, 0.0);
    }
};

/// Sets z^m by index. Each power is a product of two powers of half its degree, so that errors grow with log
/// m.
void set_powers(std::complex<double> z, std::span<std::complex<double>> powers) {
    powers[0] = 1;
    if (powers.size() > 1) powers[1] = z;
    for (std::size_t m = 2; m < powers.size(); ++m) powers[m] = powers[m / 2] * powers[m - m / 2];
}

/// Values of the harmonics at one direction.
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
        set_powers(polar.phase, phase_);
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

/// Number of directions in one block.
constexpr std::size_t kBlock = 256;

/// Directions as rows of latitude with one point each, so that the Legendre step runs over them in vectors.
struct Block {
    LegendreTransform legendre;
    FourierRows fourier;
    std::vector<std::complex<double>> phase;  // [row][m], exp(i m phi)

    Block(int order, std::span<const glm::dvec3> directions, std::span<const double> weights)
        : legendre(order, rows(directions, weights)),
          fourier(order, static_cast<int>(directions.size())),
          phase(fourier.s0.size()) {
        for (std::size_t i = 0; i < directions.size(); ++i)
            set_powers(Polar(directions[i]).phase, {&phase[fourier.scalar_index(static_cast<int>(i), 0)],
                                                    static_cast<std::size_t>(order) + 1});
    }

    static LatitudeRows rows(std::span<const glm::dvec3> directions, std::span<const double> weights) {
        LatitudeRows out;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const Polar polar(directions[i]);
            out.theta.push_back(2 * std::atan2(polar.half.sin, polar.half.cos));
            out.sin_half.push_back(polar.half.sin);
            out.cos_half.push_back(polar.half.cos);
            out.weight.push_back(weights.empty() ? 0 : weights[i] / (2 * std::numbers::pi));
        }
        return out;
    }

    /// Returns the Fourier series of row i at its azimuth.
    [[nodiscard]] Stokes sum(std::size_t i) const {
        const int row = static_cast<int>(i);
        const std::complex<double>* e = &phase[fourier.scalar_index(row, 0)];
        const std::complex<double>* s0 = &fourier.s0[fourier.scalar_index(row, 0)];
        const std::complex<double>* s3 = &fourier.s3[fourier.scalar_index(row, 0)];
        const std::complex<double>* spin = &fourier.spin[fourier.spin_index(row, 0)];
        Stokes s(s0[0].real(), spin[0].real(), spin[0].imag(), s3[0].real());
        for (int m = 1; m <= fourier.order; ++m) {
            const double c = e[m].real();
            const double n = e[m].imag();
            s[0] += 2 * (s0[m].real() * c - s0[m].imag() * n);
            s[3] += 2 * (s3[m].real() * c - s3[m].imag() * n);
            s[1] += (spin[m].real() + spin[-m].real()) * c - (spin[m].imag() - spin[-m].imag()) * n;
            s[2] += (spin[m].imag() + spin[-m].imag()) * c + (spin[m].real() - spin[-m].real()) * n;
        }
        return s;
    }

    /// Sets the Fourier coefficients of row i to those of a point of unit weight.
    void spread(std::size_t i, const Stokes& s) {
        const int row = static_cast<int>(i);
        for (int m = 0; m <= fourier.order; ++m) {
            const std::complex<double> e = std::conj(phase[fourier.scalar_index(row, m)]);
            fourier.s0[fourier.scalar_index(row, m)] = s[0] * e;
            fourier.s3[fourier.scalar_index(row, m)] = s[3] * e;
            fourier.spin[fourier.spin_index(row, -m)] = std::complex(s[1], s[2]) * std::conj(e);
            fourier.spin[fourier.spin_index(row, m)] = std::complex(s[1], s[2]) * e;
        }
    }
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
    for (std::size_t first = 0; first < directions.size(); first += kBlock) {
        const auto some = directions.subspan(first, std::min(kBlock, directions.size() - first));
        Block block(field.order(), some, {});
        block.legendre.synthesize(coefficients, block.fourier);
        for (std::size_t i = 0; i < some.size(); ++i) out[first + i] = block.sum(i);
    }
}

void project_samples(int order, std::span<const glm::dvec3> directions, std::span<const Stokes> samples,
                     std::span<const double> weights, std::span<double> coefficients) {
    require_order(order);
    require_size(samples.size(), directions.size(), "samples");
    require_size(weights.size(), directions.size(), "weights");
    require_size(coefficients.size(), 4 * psh_count(order), "coefficients");
    require_finite(weights, "weights");
    std::ranges::fill(coefficients, 0.0);
    std::vector<double> part(coefficients.size());
    for (std::size_t first = 0; first < directions.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, directions.size() - first);
        Block block(order, directions.subspan(first, count), weights.subspan(first, count));
        for (std::size_t i = 0; i < count; ++i) {
            for (int p = 0; p < 4; ++p)
                require(std::isfinite(samples[first + i][p]),
                        "samples value " + std::to_string(first + i) + " is not finite");
            block.spread(i, samples[first + i]);
        }
        block.legendre.analyze(block.fourier, part);
        for (std::size_t i = 0; i < part.size(); ++i) coefficients[i] += part[i];
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
