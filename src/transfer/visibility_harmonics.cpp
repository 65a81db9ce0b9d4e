// SPDX-License-Identifier: MIT
#include "transfer/visibility_harmonics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "nicol/error.hpp"
#include "nicol/psh.hpp"
#include "nicol/stokes.hpp"
#include "transfer/lanes.hpp"
#include "transfer/simd.hpp"

namespace nicol {
namespace {

constexpr double pi = std::numbers::pi;

// Sixteen directions in the vertex's frame (of propagation), and what each counts.
struct Samples {
    Lanes x, y, z, weight;
};

// Legendre polynomials at 0.
std::vector<double> legendre_at_zero(int count) {
    std::vector<double> p(static_cast<std::size_t>(count), 0.0);
    p[0] = 1;
    for (std::size_t l = 2; l < p.size(); l += 2) {
        p[l] = -p[l - 2] * static_cast<double>(l - 1) / static_cast<double>(l);
    }
    return p;
}

// Light that propagates down, z < 0: the integral of Y_l0 over that half.
std::vector<float> lower_half(int order) {
    std::vector<float> out(psh_count(order), 0.0F);
    const std::vector<double> p = legendre_at_zero(order + 2);
    for (int l = 0; l <= order; ++l) {
        const auto k = static_cast<std::size_t>(l);
        const double upper = l == 0 ? 1.0 : (p[k - 1] - p[k + 1]) / (2 * l + 1);
        out[psh_index(l, 0)] =
            static_cast<float>((l % 2 == 0 ? 2 : -2) * pi * std::sqrt((2 * l + 1) / (4 * pi)) * upper);
    }
    return out;
}

// sum[psh_index(l, m)] += weight Y_lm. The harmonics are (x + i y)^m times a polynomial q_lm(z), with
// q_lm = a z q_{l-1,m} - b q_{l-2,m}; `climb` holds a and b at 2 psh_index(l, m), and q_mm for l = m.
NICOL_MULTIVERSION
void add(const Samples& at, const float* climb, int order, Lanes* sum) {
    Lanes c = at.weight;
    Lanes s{};
    for (int m = 0; m <= order; ++m) {
        Lanes before{};
        Lanes q;
        q.value.fill(climb[2 * (m * m + 2 * m)]);
        for (int l = m; l <= order; ++l) {
            Lanes& cosine = sum[l * l + l + m];
            for (std::size_t i = 0; i < kLanes; ++i) cosine.value[i] += q.value[i] * c.value[i];
            if (m > 0) {
                Lanes& sine = sum[l * l + l - m];
                for (std::size_t i = 0; i < kLanes; ++i) sine.value[i] += q.value[i] * s.value[i];
            }
            if (l == order) break;
            const float* next = climb + 2 * ((l + 1) * (l + 2) + m);
            const float a = next[0];
            const float b = next[1];
            for (std::size_t i = 0; i < kLanes; ++i) {
                const float up = a * at.z.value[i] * q.value[i] - b * before.value[i];
                before.value[i] = q.value[i];
                q.value[i] = up;
            }
        }
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float turned = c.value[i] * at.x.value[i] - s.value[i] * at.y.value[i];
            s.value[i] = s.value[i] * at.x.value[i] + c.value[i] * at.y.value[i];
            c.value[i] = turned;
        }
    }
}

std::vector<float> climbing_factors(int order) {
    std::vector<float> out(2 * psh_count(order), 0.0F);
    double sectoral = 1 / std::sqrt(4 * pi);
    for (int m = 0; m <= order; ++m) {
        if (m > 0) sectoral *= -std::sqrt((2.0 * m + 1) / (2.0 * m));
        out[2 * psh_index(m, m)] = static_cast<float>(m > 0 ? std::numbers::sqrt2 * sectoral : sectoral);
        for (int l = m + 1; l <= order; ++l) {
            const double square = static_cast<double>(l) * l;
            const double before = static_cast<double>(l - 1) * (l - 1);
            const double a = std::sqrt((4 * square - 1) / (square - m * m));
            out[2 * psh_index(l, m)] = static_cast<float>(a);
            if (l > m + 1) {
                out[2 * psh_index(l, m) + 1] =
                    static_cast<float>(a * std::sqrt((before - m * m) / (4 * before - 1)));
            }
        }
    }
    return out;
}

// The directions above the horizon that the vertex sees count what they weigh, the others nothing, less the
// fraction `seen` of the whole that is added exactly: so quadrature need not know where the horizon is.
// Returns the fraction.
float gather(const DirectionSet& directions, const Visibility& visibility, std::size_t vertex,
             const Frame& frame, std::vector<Samples>& samples) {
    const glm::vec3 x(frame[0]);
    const glm::vec3 y(frame[1]);
    const glm::vec3 z(frame[2]);
    double all = 0;
    double seen = 0;
    std::size_t count = 0;
    samples.clear();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const glm::vec3& towards = directions.directions()[i];
        const float height = glm::dot(towards, z);
        if (!(height > 0)) continue;
        const std::size_t lane = count % kLanes;
        if (lane == 0) samples.emplace_back();
        Samples& here = samples.back();
        const float weight = directions.weights()[i];
        here.x[lane] = -glm::dot(towards, x);
        here.y[lane] = -glm::dot(towards, y);
        here.z[lane] = -height;
        here.weight[lane] = visibility.seen(vertex, i) ? weight : -weight;
        all += static_cast<double>(weight);
        if (visibility.seen(vertex, i)) seen += static_cast<double>(weight);
        ++count;
    }
    const auto fraction = static_cast<float>(all > 0 ? seen / all : 0.0);
    for (Samples& here : samples) {
        for (float& weight : here.weight.value) {
            weight = weight > 0 ? weight * (1 - fraction) : -std::abs(weight) * fraction;
        }
    }
    return fraction;
}

}  // namespace

VisibilityHarmonics::VisibilityHarmonics(const DirectionSet& directions, int order,
                                         HorizonExtension extension)
    : directions_(directions), order_(order), extension_(extension) {
    if (order < 0 || order > kHighestOrder) {
        throw Error(ErrorCode::invalid_argument, "visibility of order " + std::to_string(order) +
                                                     "; it must lie in 0 to " +
                                                     std::to_string(kHighestOrder));
    }
    climb_ = climbing_factors(order);
    if (extension == HorizonExtension::dark) {
        everything_ = lower_half(order);
    } else {
        everything_.assign(psh_count(order), 0.0F);
        everything_[0] = static_cast<float>(std::sqrt(4 * pi));
    }
}

void VisibilityHarmonics::project(const Visibility& visibility, std::size_t vertex, const glm::vec3& normal,
                                  std::span<float> out) const {
    if (visibility.unoccluded(vertex)) {
        std::ranges::copy(everything_, out.begin());
        return;
    }
    std::vector<Samples> samples;
    const Frame frame = theta_phi_frame(glm::normalize(glm::dvec3(normal)));
    const float seen = gather(directions_, visibility, vertex, frame, samples);
    std::vector<Lanes> sum(psh_count(order_), Lanes{});
    for (const Samples& here : samples) add(here, climb_.data(), order_, sum.data());

    const bool mirrored = extension_ == HorizonExtension::mirrored;
    for (int l = 0; l <= order_; ++l) {
        for (int m = -l; m <= l; ++m) {
            const std::size_t k = psh_index(l, m);
            float coefficient = seen * everything_[k];
            if (!mirrored || (l + m) % 2 == 0) {
                float total = 0;
                for (const float lane : sum[k].value) total += lane;
                coefficient += mirrored ? 2 * total : total;
            }
            out[k] = coefficient;
        }
    }
}

}  // namespace nicol
