// SPDX-License-Identifier: MIT
#include "material/row_integral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harmonics/spin_harmonics.hpp"
#include "material/lobe_quadrature.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Returns whether the part of M_pq that a pairing takes is even in the azimuth; else it is odd. Materials
// with mirror symmetry have no part for the second pairing.
constexpr bool is_even(std::size_t p, std::size_t q, std::size_t pairing) {
    return ((p < 2) == (q < 2)) == (pairing == 0);
}

// Sums of values times waves that share one pass over the waves.
constexpr std::size_t kTogether = 4;

struct WaveSums {
    std::array<const float*, kTogether> values;  // [node]
    std::array<Lanes*, kTogether> sums;          // [block]
};

// Computes sums[block] = sum over nodes of values[node] * waves[node][block].
[[gnu::always_inline]] inline void sum_waves(const WaveSums& of, const Lanes* waves, std::size_t nodes,
                                             std::size_t blocks) {
    for (std::size_t block = 0; block < blocks; ++block) {
        LaneVector sums[kTogether]{};
        for (std::size_t n = 0; n < nodes; ++n) {
            LaneVector wave;
            load(waves + n * blocks + block, wave);
            for (std::size_t i = 0; i < kTogether; ++i) sums[i] += of.values[i][n] * wave;
        }
        for (std::size_t i = 0; i < kTogether; ++i) store(of.sums[i] + block, sums[i]);
    }
}

}  // namespace

RowIntegral::RowIntegral(const Material& material, const LightLayout& layout)
    : material_(material.isotropic()),
      layout_(layout),
      terms_(static_cast<std::size_t>(material.terms())),
      pairings_(material.pairings()),
      columns_(static_cast<std::size_t>(layout.kind())),
      blocks_((static_cast<std::size_t>(layout.order()) + kLanes) / kLanes),
      lobe_(narrowest_lobe(material_)),
      muellers_(terms_),
      empty_(16 * terms_),
      moments_(16 * terms_ * pairings_ * blocks_),
      scalar_(psh_count(layout.order())),
      spin2_(psh_count(layout.order())),
      first_(layout.row_size()),
      second_(layout.row_size()),
      rows_(4 * terms_ * pairings_ * layout.row_size()) {}

std::span<const double> RowIntegral::integrate(double theta_out) {
    std::ranges::fill(rows_, 0.0);
    // Eight nodes per panel resolve a wave and a half to six digits.
    const double wide = std::min(pi / 4, 3 * pi / (layout_.order() + 1));
    const glm::dvec3 viewer(std::sin(theta_out), 0, std::cos(theta_out));
    const LobePanels narrow = lobe_panels(theta_out, lobe_);
    place_azimuths(narrow.azimuth, wide);
    for (const QuadratureNode& node : nodes_around(theta_out, 0, pi / 2, narrow.zenith, wide)) {
        evaluate_circle(node.x, viewer);
        take_moments();
        // Propagation is opposite: theta_p = pi - theta, which exchanges sine and cosine of the half angle.
        const double sine = std::sin(node.x / 2);
        const double cosine = std::cos(node.x / 2);
        spin_harmonics(0, layout_.order(), cosine, sine, scalar_);
        // A depolarizing material has no use for the harmonics of spin 2.
        if (has_spin()) spin_harmonics(2, layout_.order(), cosine, sine, spin2_);
        zenith_functions(layout_, scalar_, spin2_, first_, second_);
        // The weight includes the factor cos(theta) of the integral.
        accumulate(std::sin(node.x) * std::cos(node.x) * node.weight);
    }
    return rows_;
}

void RowIntegral::place_azimuths(double narrow, double wide) {
    azimuths_.clear();
    cosines_.clear();
    sines_.clear();
    const auto place = [this](double c, double s, double weight) {
        azimuths_.push_back({static_cast<float>(c), static_cast<float>(s), static_cast<float>(weight)});
        double cosine = 1;
        double sine = 0;
        for (std::size_t block = 0; block < blocks_; ++block) {
            Lanes& cosines = cosines_.emplace_back();
            Lanes& sines = sines_.emplace_back();
            for (std::size_t i = 0; i < kLanes; ++i) {
                cosines[i] = static_cast<float>(cosine);
                sines[i] = static_cast<float>(sine);
                const double next = -(cosine * c - sine * s);
                sine = -(sine * c + cosine * s);
                cosine = next;
            }
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
    values_.resize(16 * terms_ * azimuths_.size());
}

// Evaluates the material for light from all azimuths at one zenith angle.
void RowIntegral::evaluate_circle(double theta, const glm::dvec3& viewer) {
    const auto sin_theta = static_cast<float>(std::sin(theta));
    const auto cos_theta = static_cast<float>(std::cos(theta));
    const std::size_t nodes = azimuths_.size();
    empty_.assign(empty_.size(), true);
    LaneVectors to_viewer;
    for (std::size_t i = 0; i < kLanes; ++i) put(to_viewer, i, glm::vec3(viewer));
    for (std::size_t begin = 0; begin < nodes; begin += kLanes) {
        const std::size_t size = std::min(kLanes, nodes - begin);
        LaneVectors light;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const AzimuthNode& node = azimuths_[begin + std::min(i, size - 1)];
            put(light, i, {sin_theta * node.cos_phi, sin_theta * node.sin_phi, cos_theta});
        }
        material_.evaluate_lanes(light, to_viewer, columns_ == 1 ? 1 : 4, muellers_);
        for (std::size_t e = 0; e < empty_.size(); ++e) {
            if (e % 4 >= columns_) continue;
            const Lanes& element = muellers_[e / 16].m[e % 16];
            float* out = &values_[e * nodes + begin];
            bool empty = true;
            for (std::size_t i = 0; i < size; ++i) {
                out[i] = azimuths_[begin + i].weight * element[i];
                empty = empty && out[i] == 0;
            }
            if (!empty) empty_[e] = false;
        }
    }
}

// Computes moments over the whole circle: cosine moments of even parts, sine moments of odd parts.
void RowIntegral::take_moments() {
    const std::size_t nodes = azimuths_.size();
    for (const bool even : {true, false}) {
        const Lanes* waves = even ? cosines_.data() : sines_.data();
        WaveSums some{};
        std::size_t count = 0;
        const auto sum = [&] {
            if (count == 0) return;
            for (std::size_t i = count; i < kTogether; ++i) {
                some.values[i] = some.values[0];
                some.sums[i] = some.sums[0];
            }
            dispatch<sum_waves>(some, waves, nodes, blocks_);
            count = 0;
        };
        for (std::size_t e = 0; e < empty_.size(); ++e) {
            for (std::size_t pairing = 0; pairing < pairings_; ++pairing) {
                if (empty_[e] || is_even(e / 4 % 4, e % 4, pairing) != even) continue;
                some.values[count] = &values_[e * nodes];
                some.sums[count] = &moments_[(e * pairings_ + pairing) * blocks_];
                if (++count == kTogether) sum();
            }
        }
        sum();
    }
}

bool RowIntegral::has_spin() const {
    for (std::size_t e = 0; e < empty_.size(); ++e)
        if (!empty_[e] && (e % 4 == 1 || e % 4 == 2)) return true;
    return false;
}

void RowIntegral::accumulate(double solid_angle) {
    std::size_t begin = 0;  // start of the run in a row
    for (const LightLayout::Run& run : layout_.runs()) {
        const double* first = &first_[begin];
        const double* second = &second_[begin];
        const auto block = static_cast<std::size_t>(run.m) / kLanes;
        const auto lane = static_cast<std::size_t>(run.m) % kLanes;
        for (std::size_t row = 0; row < 4 * terms_ * pairings_; ++row) {
            const std::size_t p = row / pairings_ % 4;
            const std::size_t pairing = row % pairings_;
            const auto moment = [&](std::size_t q) {
                const std::size_t e = row / pairings_ * 4 + q;
                if (empty_[e]) return 0.0;
                const Lanes& waves = moments_[(e * pairings_ + pairing) * blocks_ + block];
                return solid_angle * static_cast<double>(waves[lane]);
            };
            // The moment is for the even functions of the run, or for the odd functions.
            const bool even = is_even(p, 0, pairing);
            double a = 0;
            double b = 0;
            if (run.part == LightKind::unpolarized) {
                a = moment(0);
            } else if (run.part == LightKind::full) {
                a = moment(3);
            } else {
                const double sign = even ? 1 : static_cast<double>(run.sign);
                a = sign * moment(1);
                b = (even ? sign : -sign) * moment(2);
            }
            if (a == 0 && b == 0) continue;
            double* out = &rows_[row * layout_.row_size() + begin];
            for (std::size_t j = 0; j < run.count; ++j) out[j] += a * first[j] + b * second[j];
        }
        begin += run.count;
    }
}

}  // namespace nicol
