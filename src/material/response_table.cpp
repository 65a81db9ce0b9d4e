// SPDX-License-Identifier: MIT
#include "nicol/response_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "material/lobe_quadrature.hpp"
#include "nicol/error.hpp"
#include "nicol/spin_harmonics.hpp"

namespace nicol {
namespace {

constexpr double pi = std::numbers::pi;

struct AzimuthNode {
    double cos_phi;  // of the direction towards the light
    double sin_phi;
    double weight;
    std::vector<double> cosines;  // cos(m phi_p), m = 0..order, phi_p = phi + pi of the propagation
    std::vector<double> sines;
};

std::vector<AzimuthNode> azimuth_nodes(int order, double narrow, double wide) {
    std::vector<AzimuthNode> nodes;
    for (const QuadratureNode& q : nodes_around(pi, 0, pi, narrow, wide)) {
        AzimuthNode node{std::cos(q.x), std::sin(q.x), q.weight, {}, {}};
        for (int m = 0; m <= order; ++m) {
            node.cosines.push_back(std::cos(m * (q.x + pi)));
            node.sines.push_back(std::sin(m * (q.x + pi)));
        }
        nodes.push_back(std::move(node));
    }
    return nodes;
}

// Whether M_pq is even in the azimuth, for materials with mirror symmetry; else it is odd.
constexpr bool is_even(std::size_t p, std::size_t q) {
    return (p < 2) == (q < 2);
}

// All rows of one term at one outgoing angle.
class RowIntegral {
public:
    RowIntegral(const Material& material, int term, const LightLayout& layout)
        : material_(material),
          term_(term),
          layout_(layout),
          order_(static_cast<std::size_t>(layout.order())) {
        moments_.resize(16 * (order_ + 1));
        scalar_.resize(psh_count(layout.order()));
        spin2_.resize(psh_count(layout.order()));
        rows_.resize(4 * layout.size());
    }

    const std::vector<double>& integrate(double theta_out) {
        std::fill(rows_.begin(), rows_.end(), 0.0);
        const double lobe = material_.lobe_width(term_);
        // Eight nodes a panel follow about four half-waves.
        const double wide = std::min(pi / 4, 2 * pi / static_cast<double>(order_ + 1));
        const glm::dvec3 viewer(std::sin(theta_out), 0, std::cos(theta_out));
        const auto azimuths =
            azimuth_nodes(static_cast<int>(order_), std::min(1.0, lobe / std::max(lobe, viewer.x)), wide);
        for (const QuadratureNode& node : nodes_around(theta_out, 0, pi / 2, lobe, wide)) {
            take_moments(node.x, viewer, azimuths);
            const double solid_angle = std::sin(node.x) * std::cos(node.x) * node.weight;  // and the cosine
            // Propagation is opposite: theta_p = pi - theta, so the half-angle functions change places.
            spin_harmonics(0, layout_.order(), std::cos(node.x / 2), std::sin(node.x / 2), scalar_);
            if (layout_.kind() != LightKind::unpolarized) {
                spin_harmonics(2, layout_.order(), std::cos(node.x / 2), std::sin(node.x / 2), spin2_);
            }
            accumulate(solid_angle);
        }
        return rows_;
    }

private:
    double& moment(std::size_t p, std::size_t q, std::size_t m) {
        return moments_[(4 * p + q) * (order_ + 1) + m];
    }

    // Cosine moments of the even elements, sine moments of the odd ones, over the whole circle.
    void take_moments(double theta, const glm::dvec3& viewer, const std::vector<AzimuthNode>& azimuths) {
        std::fill(moments_.begin(), moments_.end(), 0.0);
        const auto columns = static_cast<std::size_t>(layout_.kind());
        for (const AzimuthNode& node : azimuths) {
            const glm::dvec3 light(std::sin(theta) * node.cos_phi, std::sin(theta) * node.sin_phi,
                                   std::cos(theta));
            const Mueller mueller = material_.evaluate(term_, light, viewer);
            for (std::size_t p = 0; p < 4; ++p) {
                for (std::size_t q = 0; q < columns; ++q) {
                    const double value = 2 * node.weight * mueller(p, q);
                    if (value == 0) continue;
                    const std::vector<double>& wave = is_even(p, q) ? node.cosines : node.sines;
                    double* out = &moment(p, q, 0);
                    for (std::size_t m = 0; m <= order_; ++m) out[m] += value * wave[m];
                }
            }
        }
    }

    void accumulate(double solid_angle) {
        for (std::size_t j = 0; j < layout_.size(); ++j) {
            const LightLayout::Entry& e = layout_.entries()[j];
            const auto m = static_cast<std::size_t>(std::abs(e.m));
            const double sign = e.m < 0 ? -1 : 1;
            const std::size_t index = psh_index(e.l, e.m);
            const double real_norm = e.m > 0 ? std::numbers::sqrt2 : 1;
            for (std::size_t p = 0; p < 4; ++p) {
                double value = 0;
                if (e.part == LightKind::unpolarized) {
                    value = real_norm * scalar_[index] * moment(p, 0, m);
                } else if (e.part == LightKind::full) {
                    value = real_norm * scalar_[index] * moment(p, 3, m);
                } else if (p < 2) {
                    // f1 = Re, f2 = Im of z 2Y e^{im phi}: the part of Re z.
                    value = spin2_[index] * (moment(p, 1, m) + sign * moment(p, 2, m));
                } else {
                    value = spin2_[index] * (moment(p, 2, m) - sign * moment(p, 1, m));
                }
                rows_[p * layout_.size() + j] += solid_angle * value;
            }
        }
    }

    const Material& material_;
    int term_;
    const LightLayout& layout_;
    std::size_t order_;
    std::vector<double> moments_;  // [p][q][m]
    std::vector<double> scalar_;
    std::vector<double> spin2_;
    std::vector<double> rows_;  // [p][j]
};

constexpr int stride = 4;
constexpr int integrated = (ResponseTable::kAngles - 1) / stride + 1;

// Fills the angles between those that were integrated: cubics through the four nearest.
void interpolate_between(std::vector<float>& data, std::size_t row) {
    for (int cell = 0; cell + 1 < integrated; ++cell) {
        const int first = std::clamp(cell - 1, 0, integrated - 4);
        for (int step = 1; step < stride; ++step) {
            const double x = cell - first + static_cast<double>(step) / stride;
            std::array<double, 4> weight{};
            for (int i = 0; i < 4; ++i) {
                double lagrange = 1;
                for (int k = 0; k < 4; ++k) lagrange *= k == i ? 1.0 : (x - k) / (i - k);
                weight[static_cast<std::size_t>(i)] = lagrange;
            }
            float* out = data.data() + static_cast<std::size_t>(cell * stride + step) * row;
            for (std::size_t j = 0; j < row; ++j) {
                double sum = 0;
                for (std::size_t i = 0; i < 4; ++i) {
                    sum += weight[i] * static_cast<double>(
                                           data[(static_cast<std::size_t>(first) + i) * stride * row + j]);
                }
                out[j] = static_cast<float>(sum);
            }
        }
    }
}

bool is_grey(const Material& material, int channels) {
    for (int term = 0; term < material.terms(); ++term) {
        for (int c = 1; c < channels; ++c) {
            if (material.weight(term, c) != material.weight(term, 0)) return false;
        }
    }
    return true;
}

}  // namespace

ResponseTable::ResponseTable(const Material& material, const LightLayout& layout, int channels)
    : row_size_(layout.size()), channels_(channels) {
    if (channels < 1 || (material.channels() != 1 && material.channels() != channels)) {
        throw Error(ErrorCode::invalid_argument, "a material of " + std::to_string(material.channels()) +
                                                     " channels cannot serve a scene of " +
                                                     std::to_string(channels) +
                                                     "; it must have 1 or as many");
    }
    if (material.channels() == 1 || is_grey(material, channels)) channels_ = 1;
    const auto table_channels = static_cast<std::size_t>(channels_);
    data_.assign(kAngles * table_channels * 4 * row_size_, 0.0F);

    tbb::parallel_for(tbb::blocked_range<int>(0, integrated), [&](const tbb::blocked_range<int>& range) {
        for (int term = 0; term < material.terms(); ++term) {
            RowIntegral integral(material, term, layout);
            for (int i = range.begin(); i < range.end(); ++i) {
                const int angle = i * stride;
                // At 90 degrees the rows have a limit but the formulas of most materials are 0/0.
                const double theta = std::min(angle * (pi / 2) / (kAngles - 1), pi / 2 - 1e-6);
                const std::vector<double>& rows = integral.integrate(theta);
                float* out = data_.data() + static_cast<std::size_t>(angle) * table_channels * rows.size();
                for (int c = 0; c < channels_; ++c, out += rows.size()) {
                    const double weight = material.weight(term, c);
                    for (std::size_t i = 0; i < rows.size(); ++i)
                        out[i] += static_cast<float>(weight * rows[i]);
                }
            }
        }
    });

    interpolate_between(data_, 4 * row_size_ * table_channels);

    for (std::size_t i = 0; i < data_.size(); ++i) {
        if (data_[i] != 0) makes_[i / row_size_ % 4] = true;
    }
}

}  // namespace nicol
