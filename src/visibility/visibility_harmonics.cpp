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

// Bundles that are summed at once: a sum is loaded and stored once for all.
constexpr std::size_t group = 4;

struct Group {
    LaneVector x[group];
    LaneVector y[group];
    LaneVector c[group];  // weight times the real part of (x + i y)^m
    LaneVector s[group];
};

[[gnu::always_inline]] inline void begin_group(const Samples* at, Group& g) {
    for (std::size_t k = 0; k < group; ++k) {
        load(&at[k].x, g.x[k]);
        load(&at[k].y, g.y[k]);
        load(&at[k].weight, g.c[k]);
        g.s[k] = LaneVector{};
    }
}

[[gnu::always_inline]] inline void raise_group(Group& g) {
    for (std::size_t k = 0; k < group; ++k) {
        const LaneVector rotated = g.c[k] * g.x[k] - g.s[k] * g.y[k];
        g.s[k] = g.s[k] * g.x[k] + g.c[k] * g.y[k];
        g.c[k] = rotated;
    }
}

[[gnu::always_inline]] inline void add_group(const LaneVector* q, const LaneVector* factor, Lanes* sum) {
    LaneVector total;
    load(sum, total);
    for (std::size_t k = 0; k < group; ++k) total += q[k] * factor[k];
    store(sum, total);
}

// sum[psh_index(l, m)] += weight Y_lm. The harmonics are (x + i y)^m times a polynomial q_lm(z), with
// q_lm = a z q_{l-1,m} - b q_{l-2,m}; `climb` holds a and b at 2 psh_index(l, m), and q_mm for l = m.
[[gnu::always_inline]] inline void add(const Samples* at, const float* climb, int order, Lanes* sum) {
    Group g;
    begin_group(at, g);
    for (int m = 0; m <= order; ++m) {
        LaneVector before[group] = {};
        LaneVector q[group];
        for (LaneVector& one : q) one = LaneVector{} + climb[2 * (m * m + 2 * m)];
        for (int l = m; l <= order; ++l) {
            add_group(q, g.c, sum + l * l + l + m);
            if (m > 0) add_group(q, g.s, sum + l * l + l - m);
            if (l == order) break;
            const float* next = climb + 2 * ((l + 1) * (l + 2) + m);
            for (std::size_t k = 0; k < group; ++k) {
                LaneVector z;
                load(&at[k].z, z);
                const LaneVector up = next[0] * z * q[k] - next[1] * before[k];
                before[k] = q[k];
                q[k] = up;
            }
        }
        raise_group(g);
    }
}

// The same for even l + m alone: q_lm = (a z^2 + b) q_{l-2,m} - c q_{l-4,m}; `leap` holds a, b and c at
// 3 psh_index(l, m), and q_mm for l = m.
[[gnu::always_inline]] inline void add_even(const Samples* at, const float* leap, int order, Lanes* sum) {
    Group g;
    begin_group(at, g);
    LaneVector z2[group];
    for (std::size_t k = 0; k < group; ++k) {
        load(&at[k].z, z2[k]);
        z2[k] *= z2[k];
    }
    for (int m = 0; m <= order; ++m) {
        LaneVector before[group] = {};
        LaneVector q[group];
        for (LaneVector& one : q) one = LaneVector{} + leap[3 * (m * m + 2 * m)];
        for (int l = m; l <= order; l += 2) {
            add_group(q, g.c, sum + l * l + l + m);
            if (m > 0) add_group(q, g.s, sum + l * l + l - m);
            if (l + 2 > order) break;
            const float* next = leap + 3 * ((l + 2) * (l + 3) + m);
            for (std::size_t k = 0; k < group; ++k) {
                const LaneVector up = (next[0] * z2[k] + next[1]) * q[k] - next[2] * before[k];
                before[k] = q[k];
                q[k] = up;
            }
        }
        raise_group(g);
    }
}

// The sums of the lanes.
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

// Of z q_l = r_{l+1} q_{l+1} + r_l q_{l-1}, applied twice.
std::vector<float> leaping_factors(int order, const std::vector<float>& climb) {
    std::vector<float> out(3 * psh_count(order), 0.0F);
    for (int m = 0; m <= order; ++m) {
        out[3 * psh_index(m, m)] = climb[2 * psh_index(m, m)];
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
[[gnu::always_inline]] inline std::size_t look_around(std::span<const RayBundle> bundles,
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
    samples.resize(dispatch<look_around>(directions.bundles(), weights.data(), vertex, samples.data()));
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
    leap_ = leaping_factors(order, climb_);
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
    // What is added to fill the last group weighs nothing.
    samples.resize((samples.size() + group - 1) / group * group, Samples{});
    for (std::size_t first = 0; first < samples.size(); first += group) {
        if (mirrored) {
            dispatch<add_even>(&samples[first], leap_.data(), order_, sum.data());
        } else {
            dispatch<add>(&samples[first], climb_.data(), order_, sum.data());
        }
    }
    dispatch<fold>(sum.data(), sum.size(), out.data());

    for (int l = 0; l <= order_; ++l) {
        for (int m = -l; m <= l; ++m) {
            const std::size_t k = psh_index(l, m);
            // What is left out of mirrored visibility is 0 in the sums.
            out[k] = seen * everything_[k] + (mirrored ? 2 * out[k] : out[k]);
        }
    }
}

}  // namespace nicol
