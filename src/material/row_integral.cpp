// SPDX-License-Identifier: MIT
#include "material/row_integral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/spin_harmonics.hpp"
#include "material/lobe_quadrature.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Returns whether the part of M_pq that a pairing takes is even in the azimuth; else it is odd. Materials
// with mirror symmetry have no part for the second pairing.
constexpr bool is_even(std::size_t p, std::size_t q, std::size_t pairing) {
    return ((p < 2) == (q < 2)) == (pairing == 0);
}

}  // namespace

RowIntegral::RowIntegral(const Material& material, const LightLayout& layout)
    : material_(material.isotropic()),
      layout_(layout),
      pairings_(material.pairings()),
      waves_(static_cast<std::size_t>(layout.order()) + 1) {
    // Terms share nodes and evaluate_terms() if all have the same lobe width.
    const int terms = material.terms();
    bool equal_widths = true;
    for (int t = 1; t < terms; ++t)
        equal_widths = equal_widths && material_.lobe_width(t) == material_.lobe_width(0);
    if (equal_widths) groups_.emplace_back();
    for (int t = 0; t < terms; ++t) {
        if (!equal_widths) groups_.emplace_back();
        groups_.back().push_back(t);
    }
    const auto all = static_cast<std::size_t>(terms);
    muellers_.resize(all);
    moments_.resize(all * 16 * pairings_ * waves_);
    scalar_.resize(psh_count(layout.order()));
    spin2_.resize(psh_count(layout.order()));
    first_.resize(layout.row_size());
    second_.resize(layout.row_size());
    rows_.resize(all * 4 * pairings_ * layout.row_size());
}

std::span<const double> RowIntegral::integrate(double theta_out) {
    std::ranges::fill(rows_, 0.0);
    for (const std::vector<int>& terms : groups_) add_terms(theta_out, terms);
    return rows_;
}

void RowIntegral::place_azimuths(double narrow, double wide) {
    azimuths_.clear();
    cosines_.clear();
    sines_.clear();
    const auto place = [this](double c, double s, double weight) {
        azimuths_.push_back({c, s, weight});
        double cosine = 1;
        double sine = 0;
        for (std::size_t m = 0; m < waves_; ++m) {
            cosines_.push_back(cosine);
            sines_.push_back(sine);
            const double next = -(cosine * c - sine * s);
            sine = -(sine * c + cosine * s);
            cosine = next;
        }
    };
    // A single pairing needs one of two mirror images, with twice the weight.
    const double share = 2 / static_cast<double>(pairings_);
    for (const QuadratureNode& q : nodes_around(pi, 0, pi, narrow, wide)) {
        const double c = std::cos(q.x);
        const double s = std::sin(q.x);
        place(c, s, share * q.weight);
        if (pairings_ == 2) place(c, -s, share * q.weight);
    }
}

void RowIntegral::add_terms(double theta_out, std::span<const int> terms) {
    const double lobe = material_.lobe_width(terms.front());
    // Eight nodes per panel resolve about four half-waves.
    const double wide = std::min(pi / 4, 2 * pi / static_cast<double>(waves_));
    const glm::dvec3 viewer(std::sin(theta_out), 0, std::cos(theta_out));
    place_azimuths(std::min(1.0, lobe / std::max(lobe, viewer.x)), wide);
    for (const QuadratureNode& node : nodes_around(theta_out, 0, pi / 2, lobe, wide)) {
        take_moments(node.x, viewer, terms);
        // Propagation is opposite: theta_p = pi - theta, which exchanges sine and cosine of the half angle.
        const double sine = std::sin(node.x / 2);
        const double cosine = std::cos(node.x / 2);
        spin_harmonics(0, layout_.order(), cosine, sine, scalar_);
        if (layout_.kind() != LightKind::unpolarized)
            spin_harmonics(2, layout_.order(), cosine, sine, spin2_);
        zenith_functions(layout_, scalar_, spin2_, first_, second_);
        // The weight includes the factor cos(theta) of the integral.
        accumulate(std::sin(node.x) * std::cos(node.x) * node.weight, terms);
    }
}

// Computes moments over the whole circle: cosine moments of even parts, sine moments of odd parts.
void RowIntegral::take_moments(double theta, const glm::dvec3& viewer, std::span<const int> terms) {
    std::ranges::fill(moments_, 0.0);
    const auto columns = static_cast<std::size_t>(layout_.kind());
    const double sin_theta = std::sin(theta);
    const double cos_theta = std::cos(theta);
    const bool together = terms.size() == muellers_.size();
    for (std::size_t n = 0; n < azimuths_.size(); ++n) {
        const AzimuthNode& node = azimuths_[n];
        const glm::dvec3 light(sin_theta * node.cos_phi, sin_theta * node.sin_phi, cos_theta);
        if (together) {
            material_.evaluate_terms(light, viewer, muellers_);
        } else {
            muellers_[0] = material_.evaluate(terms.front(), light, viewer);
        }
        const double* cosines = &cosines_[n * waves_];
        const double* sines = &sines_[n * waves_];
        double* out = moments_.data();
        for (std::size_t t = 0; t < terms.size(); ++t) {
            for (std::size_t p = 0; p < 4; ++p) {
                for (std::size_t q = 0; q < 4; ++q) {
                    const double value = node.weight * muellers_[t](p, q);
                    for (std::size_t pairing = 0; pairing < pairings_; ++pairing, out += waves_) {
                        if (q >= columns || value == 0) continue;
                        const double* wave = is_even(p, q, pairing) ? cosines : sines;
                        for (std::size_t m = 0; m < waves_; ++m) out[m] += value * wave[m];
                    }
                }
            }
        }
    }
}

void RowIntegral::accumulate(double solid_angle, std::span<const int> terms) {
    std::size_t begin = 0;  // start of the run in a row
    for (const LightLayout::Run& run : layout_.runs()) {
        const double* first = &first_[begin];
        const double* second = &second_[begin];
        for (std::size_t t = 0; t < terms.size(); ++t) {
            const auto moment = [&](std::size_t p, std::size_t q, std::size_t pairing) {
                const std::size_t at = (16 * t + 4 * p + q) * pairings_ + pairing;
                return solid_angle * moments_[at * waves_ + static_cast<std::size_t>(run.m)];
            };
            for (std::size_t i = 0; i < 4 * pairings_; ++i) {
                const std::size_t p = i / pairings_;
                const std::size_t pairing = i % pairings_;
                // The moment is for the even functions of the run, or for the odd functions.
                const bool even = is_even(p, 0, pairing);
                double a = 0;
                double b = 0;
                if (run.part == LightKind::unpolarized) {
                    a = moment(p, 0, pairing);
                } else if (run.part == LightKind::full) {
                    a = moment(p, 3, pairing);
                } else {
                    const double sign = even ? 1 : static_cast<double>(run.sign);
                    a = sign * moment(p, 1, pairing);
                    b = (even ? sign : -sign) * moment(p, 2, pairing);
                }
                if (a == 0 && b == 0) continue;
                const std::size_t row = 4 * pairings_ * static_cast<std::size_t>(terms[t]) + i;
                double* out = &rows_[row * layout_.row_size() + begin];
                for (std::size_t j = 0; j < run.count; ++j) out[j] += a * first[j] + b * second[j];
            }
        }
        begin += run.count;
    }
}

}  // namespace nicol
