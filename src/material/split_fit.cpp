// SPDX-License-Identifier: MIT
#include "material/split_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "material/high_order_factors.hpp"
#include "material/high_order_gains.hpp"
#include "material/lobe_quadrature.hpp"
#include "material/matrix_rows.hpp"
#include "nicol/evaluate.hpp"
#include "nicol/light_layout.hpp"

namespace nicol {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t kLobes = kLobeWidths.size() + 1;
constexpr int kTableSteps = 4096;
// Keeps factors of nearly equal probes small, relative to the diagonal.
constexpr double kRidge = 1e-4;

// (2 l + 1) / (4 pi) times d^l_00 and d^l_22, by l from 0 to order.
std::vector<ZonalKernel::Value> zonal_harmonics(std::size_t order, double cosine) {
    std::vector<ZonalKernel::Value> out(order + 1);
    double p = 1;
    double p_before = 0;
    double d = 0;
    double d_before = 0;
    for (std::size_t i = 0; i <= order; ++i) {
        const auto l = static_cast<double>(i);
        if (i == 2) d = (1 + cosine) * (1 + cosine) / 4;
        const double scale = (2 * l + 1) / (4 * pi);
        out[i] = {scale * p, scale * d};
        const double next = ((2 * l + 1) * cosine * p - l * p_before) / (l + 1);
        p_before = p;
        p = next;
        if (i < 2) continue;
        const double next_d =
            ((2 * l + 1) * (l * (l + 1) * cosine - 4) * d - (l + 1) * (l * l - 4) * d_before) /
            (l * ((l + 1) * (l + 1) - 4));
        d_before = d;
        d = next_d;
    }
    return out;
}

// exp(2 i c) for the angle c that turns `from` into `to` after it went along the great circle to there.
std::complex<double> transport(const Frame& from, const Frame& to) {
    const glm::dvec3 along = to[2] - from[2] * glm::dot(to[2], from[2]);
    const glm::dvec3 arrived = to[2] * glm::dot(to[2], from[2]) - from[2];
    std::complex<double> start(glm::dot(along, from[0]), glm::dot(along, from[1]));
    std::complex<double> end(glm::dot(arrived, to[0]), glm::dot(arrived, to[1]));
    if (std::norm(start) < 1e-16) {  // no circle: nearly the same place
        start = {glm::dot(to[0], from[0]), glm::dot(to[0], from[1])};
        end = 1;
    }
    const std::complex<double> turn = start * std::conj(end);
    const double size = std::norm(turn);
    return size > 0 ? turn * turn / size : 1.0;
}

// The probe's components, as rows over those at `at`: what a kernel makes of light from there.
Mueller seen_from(const Probe& probe, const ZonalKernel& kernel, const Frame& at) {
    const glm::dvec3 difference = probe.frame[2] - at[2];
    const ZonalKernel::Value k = kernel.at(glm::dot(difference, difference));
    const std::complex<double> turn = k.spin2 * transport(at, probe.frame);
    Mueller m;
    m(0, 0) = m(3, 3) = k.spin0;
    m(1, 1) = m(2, 2) = turn.real();
    m(1, 2) = turn.imag();
    m(2, 1) = -turn.imag();
    return m;
}

// a x = b for symmetric positive definite a (row-major, destroyed) and four right-hand sides.
void solve(std::vector<double>& a, std::array<SplitVector, 4>& b) {
    constexpr std::size_t n = kSplitUnknowns;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[j * n + j] -= a[j * n + k] * a[j * n + k];
        a[j * n + j] = std::sqrt(a[j * n + j]);
        for (std::size_t i = j + 1; i < n; ++i) {
            for (std::size_t k = 0; k < j; ++k) a[i * n + j] -= a[i * n + k] * a[j * n + k];
            a[i * n + j] /= a[j * n + j];
        }
    }
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

std::size_t probe_of(std::size_t unknown) {
    return unknown / 4;
}

// The s-frame x of outgoing light is phi-hat: a quarter turn from theta-hat.
constexpr std::array<double, 4> quarter_turn{1, -1, -1, 1};

}  // namespace

ZonalKernel::ZonalKernel(const std::vector<double>& gain) {
    for (int i = 0; i <= kTableSteps; ++i) {
        const double distance = 2.0 * i / kTableSteps;
        Value sum{0, 0};
        const std::vector<Value> harmonics = zonal_harmonics(gain.size() - 1, 1 - distance * distance / 2);
        for (std::size_t l = 0; l < gain.size(); ++l) {
            sum.spin0 += gain[l] * harmonics[l].spin0;
            sum.spin2 += gain[l] * harmonics[l].spin2;
        }
        table_.push_back(sum);
    }
}

ZonalKernel::Value ZonalKernel::at(double distance2) const {
    const double x = std::sqrt(std::min(distance2, 4.0)) / 2 * kTableSteps;
    const std::size_t i = std::min(static_cast<std::size_t>(x), table_.size() - 2);
    const double f = x - static_cast<double>(i);
    return {table_[i].spin0 + f * (table_[i + 1].spin0 - table_[i].spin0),
            table_[i].spin2 + f * (table_[i + 1].spin2 - table_[i].spin2)};
}

std::array<Probe, SplitProbes::kCount> SplitProbes::at(double theta_out) const {
    const glm::dvec3 d(std::sin(theta_out), 0, -std::cos(theta_out));
    const glm::dvec3 x(0, 1, 0);
    const glm::dvec3 y = glm::cross(d, x);
    const double c = std::cos(spread);
    const double s = std::sin(spread);
    const auto probe = [](const glm::dvec3& direction, const glm::dvec3& x_axis, int lobe) {
        return Probe{Frame(x_axis, glm::cross(direction, x_axis), direction), lobe};
    };
    return {probe(d, x, centre),
            probe(c * d + s * y, x, around),
            probe(c * d - s * y, x, around),
            probe(c * d + s * x, c * x - s * d, around),
            probe(c * d - s * x, c * x + s * d, around),
            probe({0, 0, -1}, x, static_cast<int>(kLobeWidths.size()))};
}

SplitFit::SplitFit(const Material& material, int l_low, int l_high, int channels)
    : material_(material), l_low_(l_low), l_high_(l_high), channels_(channels) {
    std::vector<std::vector<double>> lobes;
    for (const double width : kLobeWidths) lobes.push_back(gaussian_gains(width, l_low + 1, l_high));
    lobes.push_back(cosine_gains(l_low + 1, l_high));
    const auto prior = [](std::size_t l) { return l == 0 ? 0.0 : 1 / static_cast<double>(l * (l + 1)); };
    for (const auto& lobe : lobes) {
        std::vector<double>& gain = gains_.emplace_back(lobe);
        for (std::size_t l = 0; l < gain.size(); ++l) gain[l] *= prior(l);
        kernels_.emplace_back(gain);
    }
    for (const auto& lobe : gains_) {
        for (const auto& other : lobes) {
            std::vector<double> gain = lobe;
            for (std::size_t l = 0; l < gain.size(); ++l) gain[l] *= other[l];
            products_.emplace_back(gain);
        }
    }
}

std::vector<SplitFactors> SplitFit::at(double theta_out, const SplitProbes& probes) const {
    const auto at = probes.at(theta_out);
    constexpr std::size_t n = kSplitUnknowns;
    std::vector<double> normal(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const Probe& a = at[probe_of(i)];
            const Probe& b = at[probe_of(j)];
            const auto lobes = static_cast<std::size_t>(a.lobe) * kLobes + static_cast<std::size_t>(b.lobe);
            normal[i * n + j] = seen_from(a, products_[lobes], b.frame)(i % 4, j % 4);
        }
        normal[i * n + i] *= 1 + kRidge;
    }
    std::vector<Moments> of_terms = moments(theta_out, at);
    std::vector<SplitFactors> out;
    const bool by_matrix = material_.matrix(0) != nullptr;
    std::vector<Moments> of_channels(static_cast<std::size_t>(channels_));
    for (std::size_t c = 0; c < of_channels.size(); ++c) {
        for (std::size_t t = 0; t < of_terms.size(); ++t) {
            const double weight =
                by_matrix ? (t == c ? 1.0 : 0.0) : material_.weight(static_cast<int>(t), static_cast<int>(c));
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t u = 0; u < n; ++u)
                    of_channels[c][p][u] += weight * quarter_turn[p] * of_terms[t][p][u];
        }
        SplitFactors factors{of_channels[c], {}};
        std::vector<double> matrix = normal;
        solve(matrix, factors.of);
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t u = 0; u < n; ++u) factors.energy[p] += factors.of[p][u] * of_channels[c][p][u];
        out.push_back(factors);
    }
    return out;
}

std::vector<SplitFit::Moments> SplitFit::moments(double theta_out,
                                                 const std::array<Probe, SplitProbes::kCount>& probes) const {
    return material_.matrix(0) != nullptr ? of_matrices(theta_out, probes) : integrated(theta_out, probes);
}

std::vector<SplitFit::Moments> SplitFit::integrated(
    double theta_out, const std::array<Probe, SplitProbes::kCount>& probes) const {
    const auto terms = static_cast<std::size_t>(material_.terms());
    double lobe = 0.25;
    for (std::size_t t = 0; t < terms; ++t) lobe = std::min(lobe, material_.lobe_width(static_cast<int>(t)));
    const glm::dvec3 viewer(std::sin(theta_out), 0, std::cos(theta_out));
    const double narrow = std::min(1.0, lobe / std::max(lobe, viewer.x));
    const std::vector<QuadratureNode> azimuths = nodes_around(pi, 0, pi, narrow, pi / 8);

    std::vector<Moments> out(terms);
    std::vector<Mueller> muellers(terms);
    for (const QuadratureNode& zenith : nodes_around(theta_out, 0, pi / 2, lobe, pi / 8)) {
        const double sin_theta = std::sin(zenith.x);
        const double cos_theta = std::cos(zenith.x);
        for (const QuadratureNode& azimuth : azimuths) {
            const double weight = zenith.weight * azimuth.weight * sin_theta * cos_theta;
            glm::dvec3 light(sin_theta * std::cos(azimuth.x), sin_theta * std::sin(azimuth.x), cos_theta);
            material_.evaluate_terms(light, viewer, muellers);
            for (const double side : {1.0, -1.0}) {
                // The elements that mirroring in the plane of incidence changes.
                light.y *= side;
                const Frame frame = theta_phi_frame(-light);
                for (std::size_t i = 0; i < probes.size(); ++i) {
                    const Mueller k =
                        seen_from(probes[i], kernels_[static_cast<std::size_t>(probes[i].lobe)], frame);
                    const std::size_t count = i + 1 == probes.size() ? 1 : 4;
                    for (std::size_t t = 0; t < terms; ++t) {
                        for (std::size_t p = 0; p < 4; ++p) {
                            for (std::size_t q = 0; q < count; ++q) {
                                double sum = 0;
                                for (std::size_t e = 0; e < 4; ++e) {
                                    const double sign = (p < 2) == (e < 2) ? 1 : side;
                                    sum += sign * muellers[t](p, e) * k(q, e);
                                }
                                out[t][p][4 * i + q] += weight * sum;
                            }
                        }
                    }
                }
            }
        }
    }
    return out;
}

std::vector<SplitFit::Moments> SplitFit::of_matrices(
    double theta_out, const std::array<Probe, SplitProbes::kCount>& probes) const {
    std::vector<Moments> out(static_cast<std::size_t>(channels_));
    for (std::size_t c = 0; c < out.size(); ++c) {
        const IsotropicMatrix& matrix = *material_.matrix(static_cast<int>(c));
        const int order = std::min(l_high_, matrix.order_in());
        if (order <= l_low_) continue;
        const LightLayout layout(order, LightKind::full);
        std::vector<double> rows(4 * layout.size());
        rows_from_matrix(matrix, theta_out, layout, rows);
        for (std::size_t p = 0; p < 4; ++p) {
            for (std::size_t i = 0; i < probes.size(); ++i) {
                const std::vector<double>& gain = gains_[static_cast<std::size_t>(probes[i].lobe)];
                PshVector field(order, 1);
                for (std::size_t j = 0; j < layout.size(); ++j) {
                    const LightLayout::Entry& e = layout.entries()[j];
                    const double value = gain[static_cast<std::size_t>(e.l)] * rows[p * layout.size() + j];
                    if (e.part == LightKind::linear) {
                        field.at(0, e.l, e.m, p < 2 ? 1 : 2) = value;
                    } else if (e.part == LightKind::unpolarized) {
                        if (p < 2) field.at(0, e.l, e.m, 0) = value;
                        if (p >= 2 && e.m > 0) field.at(0, e.l, -e.m, 0) = value;
                    } else {
                        if (p < 2 && e.m > 0) field.at(0, e.l, -e.m, 3) = value;
                        if (p >= 2) field.at(0, e.l, e.m, 3) = value;
                    }
                }
                const glm::dvec3 direction = probes[i].frame[2];
                const Stokes s = turned(evaluate(field, 0, direction),
                                        angle_between(theta_phi_frame(direction), probes[i].frame));
                const std::size_t count = i + 1 == probes.size() ? 1 : 4;
                for (std::size_t q = 0; q < count; ++q) out[c][p][4 * i + q] = s[static_cast<int>(q)];
            }
        }
    }
    return out;
}

}  // namespace nicol
