// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nicol/wigner.hpp"
#include "transfer/simd.hpp"

namespace nicol {
namespace {

constexpr std::size_t lanes = 16;
using Lanes = std::array<float, lanes>;

// One complex number a lane.
struct alignas(64) ComplexLanes {
    Lanes re;
    Lanes im;
};

// out_m = sum_n matrix[m][n] in_n for one order, all lanes at once.
NICOL_MULTIVERSION
void multiply_block(const float* matrix, std::size_t size, const ComplexLanes* in, ComplexLanes* out) {
    for (std::size_t m = 0; m < size; ++m) {
        Lanes re{};
        Lanes im{};
        for (std::size_t n = 0; n < size; ++n) {
            const float d = matrix[m * size + n];
            for (std::size_t i = 0; i < lanes; ++i) re[i] += d * in[n].re[i];
            for (std::size_t i = 0; i < lanes; ++i) im[i] += d * in[n].im[i];
        }
        out[m] = {re, im};
    }
}

NICOL_MULTIVERSION
void multiply_phase(ComplexLanes& value, const Lanes& cosine, const Lanes& sine) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const float re = value.re[i] * cosine[i] - value.im[i] * sine[i];
        value.im[i] = value.im[i] * cosine[i] + value.re[i] * sine[i];
        value.re[i] = re;
    }
}

// exp(i m angle) for m = 0..order.
struct Phases {
    std::vector<ComplexLanes> powers;

    explicit Phases(int order) : powers(static_cast<std::size_t>(order) + 1) {}

    void set(const std::array<double, lanes>& angle) {
        for (std::size_t m = 0; m < powers.size(); ++m) {
            for (std::size_t i = 0; i < lanes; ++i) {
                powers[m].re[i] = static_cast<float>(std::cos(static_cast<double>(m) * angle[i]));
                powers[m].im[i] = static_cast<float>(std::sin(static_cast<double>(m) * angle[i]));
            }
        }
    }

    void apply(int m, ComplexLanes& value) const {
        const ComplexLanes& power = powers[static_cast<std::size_t>(std::abs(m))];
        if (m >= 0) {
            multiply_phase(value, power.re, power.im);
        } else {
            Lanes negative;
            for (std::size_t i = 0; i < lanes; ++i) negative[i] = -power.im[i];
            multiply_phase(value, power.re, negative);
        }
    }
};

// s0 + i s3 (spin 0) or s1 + i s2 (spin 2) of one channel as coefficients over complex harmonics.
std::vector<std::complex<float>> complex_pair(std::span<const double> channel, int order, bool spin2) {
    std::vector<std::complex<float>> pair(psh_count(order));
    for (int l = 0; l <= order; ++l) {
        for (int m = -l; m <= l; ++m) {
            const std::size_t index = psh_index(l, m);
            if (spin2) {
                pair[index] = std::complex<double>(channel[4 * index + 1], channel[4 * index + 2]);
                continue;
            }
            const auto scalar = [&](std::size_t p) -> std::complex<double> {
                const double even = channel[4 * psh_index(l, std::abs(m)) + p];
                if (m == 0) return even;
                const double odd = channel[4 * psh_index(l, -std::abs(m)) + p];
                const std::complex<double> positive = std::complex<double>(even, -odd) / std::numbers::sqrt2;
                return m > 0 ? positive : (m % 2 == 0 ? 1.0 : -1.0) * std::conj(positive);
            };
            pair[index] = scalar(0) + std::complex<double>(0, 1) * scalar(3);
        }
    }
    return pair;
}

// (-i)^m z
std::complex<float> quarter_turned(std::complex<float> z, int m) {
    switch (((m % 4) + 4) % 4) {
        case 0:
            return z;
        case 1:
            return {z.imag(), -z.real()};
        case 2:
            return -z;
        default:
            return {-z.imag(), z.real()};
    }
}

}  // namespace

VertexLight::VertexLight(const LightLayout& layout, int channels, std::size_t vertices)
    : row_size_(layout.size()),
      channels_(channels),
      data_(vertices * static_cast<std::size_t>(channels) * 2 * layout.size()) {}

Relight::Relight(const LightLayout& layout) : layout_(layout) {
    for (const double d : wigner_d(layout.order(), -std::numbers::pi / 2))
        half_turn_.push_back(static_cast<float>(d));
    transposed_.resize(half_turn_.size());
    for (int l = 0; l <= layout.order(); ++l) {
        const auto size = static_cast<std::size_t>(2 * l + 1);
        const std::size_t start = wigner_offset(l);
        for (std::size_t m = 0; m < size; ++m) {
            for (std::size_t n = 0; n < size; ++n)
                transposed_[start + n * size + m] = half_turn_[start + m * size + n];
        }
    }
}

void Relight::run(const PshVector& light, std::span<const glm::vec3> normals, std::size_t first,
                  VertexLight& out) const {
    const int order = layout_.order();
    const std::size_t count = psh_count(order);
    const bool linear = layout_.kind() != LightKind::unpolarized;

    std::vector<std::vector<std::complex<float>>> pairs;  // [channel][spin 0, spin 2]
    for (int c = 0; c < out.channels(); ++c) {
        pairs.push_back(complex_pair(light.channel(c), order, false));
        pairs.push_back(linear ? complex_pair(light.channel(c), order, true)
                               : std::vector<std::complex<float>>());
    }

    Phases azimuth(order);
    Phases zenith(order);
    std::vector<ComplexLanes> work(count);
    std::vector<ComplexLanes> turned_scalar(count);
    std::vector<ComplexLanes> turned_spin2(count);

    const auto turn = [&](const std::vector<std::complex<float>>& pair, std::vector<ComplexLanes>& result) {
        for (int l = 0; l <= order; ++l) {
            const std::size_t start = psh_index(l, -l);
            const auto size = static_cast<std::size_t>(2 * l + 1);
            for (int m = -l; m <= l; ++m) {
                ComplexLanes& value = work[psh_index(l, m)];
                value.re.fill(pair[psh_index(l, m)].real());
                value.im.fill(pair[psh_index(l, m)].imag());
                azimuth.apply(m, value);
            }
            multiply_block(transposed_.data() + wigner_offset(l), size, &work[start], &result[start]);
            for (int k = -l; k <= l; ++k) zenith.apply(-k, result[psh_index(l, k)]);
            std::copy_n(&result[start], size, &work[start]);
            multiply_block(half_turn_.data() + wigner_offset(l), size, &work[start], &result[start]);
        }
    };

    for (std::size_t block = 0; block < normals.size(); block += lanes) {
        const std::size_t used = std::min(lanes, normals.size() - block);
        std::array<double, lanes> phi{};
        std::array<double, lanes> theta{};
        for (std::size_t i = 0; i < used; ++i) {
            const glm::vec3& n = normals[block + i];
            const double rho = std::hypot(static_cast<double>(n.x), static_cast<double>(n.y));
            // At a pole theta_phi_frame takes phi as 0, and so must this.
            phi[i] = (rho > 0 ? std::atan2(static_cast<double>(n.y), static_cast<double>(n.x)) : 0) +
                     std::numbers::pi / 2;
            theta[i] = std::atan2(rho, static_cast<double>(n.z));
        }
        azimuth.set(phi);
        zenith.set(theta);

        for (int c = 0; c < out.channels(); ++c) {
            turn(pairs[2 * static_cast<std::size_t>(c)], turned_scalar);
            if (linear) turn(pairs[2 * static_cast<std::size_t>(c) + 1], turned_spin2);
            for (std::size_t i = 0; i < used; ++i) {
                const std::span<float> packed = out.at(first + block + i, c);
                const auto value = [&](const std::vector<ComplexLanes>& field, int l, int m) {
                    const ComplexLanes& v = field[psh_index(l, m)];
                    return quarter_turned({v.re[i], v.im[i]}, m);
                };
                for (std::size_t j = 0; j < layout_.size(); ++j) {
                    const LightLayout::Entry& e = layout_.entries()[j];
                    std::complex<float> z;
                    if (e.part == LightKind::linear) {
                        z = value(turned_spin2, e.l, e.m);
                    } else {
                        // The fields s0 and s3 are real; take their parts out of s0 + i s3.
                        const std::complex<float> plus = value(turned_scalar, e.l, e.m);
                        const float sign = e.m % 2 == 0 ? 1.0F : -1.0F;
                        const std::complex<float> minus = sign * std::conj(value(turned_scalar, e.l, -e.m));
                        const float norm = e.m > 0 ? std::numbers::sqrt2_v<float> : 1.0F;
                        // s3 is (plus - minus) / 2i, and its entry is i times that.
                        z = e.part == LightKind::unpolarized ? norm * std::conj((plus + minus) / 2.0F)
                                                             : norm * (plus - minus) / 2.0F;
                    }
                    packed[j] = z.real();
                    packed[layout_.size() + j] = z.imag();
                }
            }
        }
    }
}

}  // namespace nicol
