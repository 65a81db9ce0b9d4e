// SPDX-License-Identifier: MIT
#include "visibility/visibility_harmonics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <string>

#include "error.hpp"
#include "harmonics/psh.hpp"
#include "polarization/stokes.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Sixteen propagation directions in the vertex's frame, and the weight of each.
struct Samples {
    Lanes x, y, z, weight;
};

// Number of bundles that are summed at once, so that each sum is loaded and stored once for all of them.
constexpr std::size_t kGroup = 4;

struct Group {
    LaneVector x[kGroup];
    LaneVector y[kGroup];
    LaneVector c[kGroup];  // weight times the real part of (x + i y)^m
    LaneVector s[kGroup];
};

[[gnu::always_inline]] inline void begin_group(const Samples* at, Group& g) {
    for (std::size_t k = 0; k < kGroup; ++k) {
        load(&at[k].x, g.x[k]);
        load(&at[k].y, g.y[k]);
        load(&at[k].weight, g.c[k]);
        g.s[k] = LaneVector{};
    }
}

[[gnu::always_inline]] inline void next_degree(Group& g) {
    for (std::size_t k = 0; k < kGroup; ++k) {
        const LaneVector rotated = g.c[k] * g.x[k] - g.s[k] * g.y[k];
        g.s[k] = g.s[k] * g.x[k] + g.c[k] * g.y[k];
        g.c[k] = rotated;
    }
}

[[gnu::always_inline]] inline void add_group(const LaneVector* q, const LaneVector* factor, Lanes* sum) {
    LaneVector total;
    load(sum, total);
    for (std::size_t k = 0; k < kGroup; ++k) total += q[k] * factor[k];
    store(sum, total);
}

// Adds weight Y_lm to sum[psh_index(l, m)] for even l + m. The harmonics are (x + i y)^m times a polynomial
// q_lm(z) with q_lm = (a z^2 + b) q_{l-2,m} - c q_{l-4,m}; `recurrence` holds a, b and c at 3 psh_index(l,
// m), and q_mm for l = m.
[[gnu::always_inline]] inline void add_even(const Samples* at, const float* recurrence, int order,
                                            Lanes* sum) {
    Group g;
    begin_group(at, g);
    LaneVector z2[kGroup];
    for (std::size_t k = 0; k < kGroup; ++k) {
        load(&at[k].z, z2[k]);
        z2[k] *= z2[k];
    }
    for (int m = 0; m <= order; ++m) {
        LaneVector before[kGroup] = {};
        LaneVector q[kGroup];
        for (LaneVector& one : q) one = LaneVector{} + recurrence[3 * (m * m + 2 * m)];
        for (int l = m; l <= order; l += 2) {
            add_group(q, g.c, sum + l * l + l + m);
            if (m > 0) add_group(q, g.s, sum + l * l + l - m);
            if (l + 2 > order) break;
            const float* next = recurrence + 3 * ((l + 2) * (l + 3) + m);
            for (std::size_t k = 0; k < kGroup; ++k) {
                const LaneVector up = (next[0] * z2[k] + next[1]) * q[k] - next[2] * before[k];
                before[k] = q[k];
                q[k] = up;
            }
        }
        next_degree(g);
    }
}

// Computes the sum over the lanes of each vector.
[[gnu::always_inline]] inline void fold(const Lanes* lanes, std::size_t count, float* out) {
    for (std::size_t i = 0; i < count; ++i) {
        LaneVector v;
        load(lanes + i, v);
        v += __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7);
        v += __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11);
        v += __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13);
        out[i] = v[0] + v[1];
    }
}

// Returns the factors of add_even(), from z q_l = r_{l+1} q_{l+1} + r_l q_{l-1}, applied twice.
std::vector<float> recurrence_factors(int order) {
    std::vector<float> out(3 * psh_count(order), 0.0F);
    double sectoral = 1 / std::sqrt(4 * pi);
    for (int m = 0; m <= order; ++m) {
        if (m > 0) sectoral *= -std::sqrt((2.0 * m + 1) / (2.0 * m));
        out[3 * psh_index(m, m)] = static_cast<float>(m > 0 ? std::numbers::sqrt2 * sectoral : sectoral);
        const auto r = [m](int l) {
            const double square = static_cast<double>(l) * l;
            return l <= m ? 0.0 : std::sqrt((square - m * m) / (4 * square - 1));
        };
        for (int l = m + 2; l <= order; l += 2) {
            const double a = 1 / (r(l) * r(l - 1));
            float* const factors = &out[3 * psh_index(l, m)];
            factors[0] = static_cast<float>(a);
            factors[1] = static_cast<float>(-a * (r(l - 1) * r(l - 1) + r(l - 2) * r(l - 2)));
            factors[2] = static_cast<float>(a * r(l - 2) * r(l - 3));
        }
    }
    return out;
}

static_assert(RayBundle::kRays == kLanes);

using DoubleVector [[gnu::vector_size(128), gnu::may_alias]] = double;
using ByteVector [[gnu::vector_size(kLanes), gnu::may_alias]] = std::int8_t;

// State of one vertex.
struct Vertex {
    std::array<float, 9> frame;  // axes x, y and z
    const std::uint64_t* seen;   // Visibility::at
    // Sums of the weights of the directions above the horizon (all), and of the visible directions among them
    // (part).
    alignas(128) std::array<double, kLanes> all;
    alignas(128) std::array<double, kLanes> part;
};

// Gathers the bundles with any direction above the horizon. Weights are positive for visible directions,
// negative for hidden ones and 0 below the horizon. Returns the number of bundles.
[[gnu::always_inline]] inline std::size_t gather_bundles(std::span<const RayBundle> bundles,
                                                         const Lanes* weights, Vertex& vertex,
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

// Gathers the visible directions above the horizon with the mean subtracted: the visible fraction of all
// directions above it. The caller adds the fraction exactly, so that the quadrature does not depend on the
// position of the horizon. Returns the fraction.
float gather(const DirectionSet& directions, std::span<const Lanes> weights, const Visibility& visibility,
             std::size_t index, const Frame& frame, std::vector<Samples>& samples) {
    Vertex vertex{.frame = {}, .seen = visibility.at(index).data(), .all = {}, .part = {}};
    for (std::size_t i = 0; i < 9; ++i) {
        vertex.frame[i] =
            static_cast<float>(frame[static_cast<glm::length_t>(i / 3)][static_cast<glm::length_t>(i % 3)]);
    }
    samples.resize(directions.bundles().size());
    samples.resize(dispatch<gather_bundles>(directions.bundles(), weights.data(), vertex, samples.data()));
    const double all = std::accumulate(vertex.all.begin(), vertex.all.end(), 0.0);
    const double part = std::accumulate(vertex.part.begin(), vertex.part.end(), 0.0);
    const auto fraction = static_cast<float>(all > 0 ? part / all : 0.0);
    for (Samples& here : samples) {
        for (float& weight : here.weight.value) weight *= weight > 0 ? 1 - fraction : fraction;
    }
    return fraction;
}

}  // namespace

VisibilityHarmonics::VisibilityHarmonics(const DirectionSet& directions, int order)
    : directions_(directions), order_(order) {
    if (order < 0 || order > kHighestOrder) {
        throw Error(ErrorCode::invalid_argument, "visibility of order " + std::to_string(order) +
                                                     "; it must lie in 0 to " +
                                                     std::to_string(kHighestOrder));
    }
    recurrence_ = recurrence_factors(order);
    // The last bundle repeats its last direction; the repetitions get the weight 0.
    weights_.resize(directions.bundles().size(), Lanes{});
    for (std::size_t i = 0; i < directions.size(); ++i) {
        weights_[i / kLanes][i % kLanes] = directions.weights()[i];
    }
}

void VisibilityHarmonics::project(const Visibility& visibility, std::size_t vertex, const glm::vec3& normal,
                                  std::span<float> out) const {
    const std::span<float> result = out.first(psh_count(order_));
    if (visibility.unoccluded(vertex)) {
        std::ranges::fill(result, 0.0F);
        result[0] = kUnoccluded;
        return;
    }
    std::vector<Samples> samples;
    const Frame frame = theta_phi_frame(glm::normalize(glm::dvec3(normal)));
    const float seen = gather(directions_, weights_, visibility, vertex, frame, samples);
    std::vector<Lanes> sum(result.size(), Lanes{});
    // The samples that fill the last group have the weight 0.
    samples.resize((samples.size() + kGroup - 1) / kGroup * kGroup, Samples{});
    for (std::size_t first = 0; first < samples.size(); first += kGroup) {
        dispatch<add_even>(&samples[first], recurrence_.data(), order_, sum.data());
    }
    dispatch<fold>(sum.data(), sum.size(), result.data());
    for (float& value : result) value *= 2;  // accounts for the mirror image below the horizon
    result[0] += seen * kUnoccluded;
}

}  // namespace nicol
