// SPDX-License-Identifier: MIT
#include "transfer/visibility_harmonics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <string>

#include "nicol/error.hpp"
#include "nicol/psh.hpp"
#include "nicol/stokes.hpp"
#include "transfer/lane_vector.hpp"
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
// With `even`, only those of even l + m are summed.
NICOL_MULTIVERSION
void add(const Samples& at, const float* climb, int order, bool even, Lanes* sum) {
    LaneVector x;
    LaneVector y;
    LaneVector z;
    LaneVector c;
    LaneVector s{};
    load(&at.x, x);
    load(&at.y, y);
    load(&at.z, z);
    load(&at.weight, c);
    for (int m = 0; m <= order; ++m) {
        LaneVector before{};
        LaneVector q = LaneVector{} + climb[2 * (m * m + 2 * m)];
        for (int l = m; l <= order; ++l) {
            if (!even || (l + m) % 2 == 0) {
                Lanes* const cosine = sum + l * l + l + m;
                LaneVector total;
                load(cosine, total);
                store(cosine, total + q * c);
                if (m > 0) {
                    Lanes* const sine = sum + l * l + l - m;
                    load(sine, total);
                    store(sine, total + q * s);
                }
            }
            if (l == order) break;
            const float* next = climb + 2 * ((l + 1) * (l + 2) + m);
            const LaneVector up = next[0] * z * q - next[1] * before;
            before = q;
            q = up;
        }
        const LaneVector turned = c * x - s * y;
        s = s * x + c * y;
        c = turned;
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

static_assert(RayBundle::kRays == kLanes);

using DoubleVector [[gnu::vector_size(128), gnu::may_alias]] = double;
using ByteVector [[gnu::vector_size(kLanes), gnu::may_alias]] = std::int8_t;

// One vertex.
struct Vertex {
    std::array<float, 9> frame;  // x, y and z
    const std::uint64_t* seen;   // Visibility::at
    // Weights of the directions above the horizon, and of those seen.
    alignas(128) std::array<double, kLanes> all;
    alignas(128) std::array<double, kLanes> part;
};

// The bundles of which any direction is above the horizon, with weights that are positive for what is seen,
// negative for what is not and 0 below. Returns how many.
NICOL_MULTIVERSION
std::size_t look_around(std::span<const RayBundle> bundles, const Lanes* weights, Vertex& vertex,
                        Samples* samples) {
    constexpr IntVector lane{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const std::array<float, 9> f = vertex.frame;
    DoubleVector all{};
    DoubleVector part{};
    std::size_t count = 0;
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        LaneVector x;
        LaneVector y;
        LaneVector z;
        LaneVector weight;
        load(bundles[b].x.data(), x);
        load(bundles[b].y.data(), y);
        load(bundles[b].z.data(), z);
        load(weights + b, weight);
        const LaneVector height = x * f[6] + y * f[7] + z * f[8];
        const IntVector up = height > 0.0F;
        const ByteVector bytes = __builtin_convertvector(up, ByteVector);
        const auto any = std::bit_cast<std::array<std::uint64_t, 2>>(bytes);
        if ((any[0] | any[1]) == 0) continue;
        const auto bits = static_cast<std::int32_t>(vertex.seen[b / 4] >> (16 * (b % 4)) & 0xFFFF);
        const IntVector visible = ((bits >> lane) & 1) != 0;
        const LaneVector above = up ? weight : LaneVector{};
        const LaneVector seen = visible ? above : LaneVector{};
        all += __builtin_convertvector(above, DoubleVector);
        part += __builtin_convertvector(seen, DoubleVector);
        Samples& here = samples[count++];
        store(&here.x, -(x * f[0] + y * f[1] + z * f[2]));
        store(&here.y, -(x * f[3] + y * f[4] + z * f[5]));
        store(&here.z, -height);
        store(&here.weight, visible ? above : -above);
    }
    *reinterpret_cast<DoubleVector*>(vertex.all.data()) = all;
    *reinterpret_cast<DoubleVector*>(vertex.part.data()) = part;
    return count;
}

// The directions above the horizon that the vertex sees count what they weigh, the others nothing, less the
// fraction `seen` of the whole that is added exactly: so quadrature need not know where the horizon is.
// Returns the fraction.
float gather(const DirectionSet& directions, std::span<const Lanes> weights, const Visibility& visibility,
             std::size_t index, const Frame& frame, std::vector<Samples>& samples) {
    Vertex vertex{.frame = {}, .seen = visibility.at(index).data(), .all = {}, .part = {}};
    for (std::size_t i = 0; i < 9; ++i) {
        vertex.frame[i] =
            static_cast<float>(frame[static_cast<glm::length_t>(i / 3)][static_cast<glm::length_t>(i % 3)]);
    }
    samples.resize(directions.bundles().size());
    samples.resize(look_around(directions.bundles(), weights.data(), vertex, samples.data()));
    const double all = std::accumulate(vertex.all.begin(), vertex.all.end(), 0.0);
    const double part = std::accumulate(vertex.part.begin(), vertex.part.end(), 0.0);
    const auto fraction = static_cast<float>(all > 0 ? part / all : 0.0);
    for (Samples& here : samples) {
        for (float& weight : here.weight.value) weight *= weight > 0 ? 1 - fraction : fraction;
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
    // The last bundle repeats its last direction, which must not count again.
    weights_.resize(directions.bundles().size(), Lanes{});
    for (std::size_t i = 0; i < directions.size(); ++i) {
        weights_[i / kLanes][i % kLanes] = directions.weights()[i];
    }
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
    const float seen = gather(directions_, weights_, visibility, vertex, frame, samples);
    std::vector<Lanes> sum(psh_count(order_), Lanes{});
    const bool mirrored = extension_ == HorizonExtension::mirrored;
    for (const Samples& here : samples) add(here, climb_.data(), order_, mirrored, sum.data());

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
