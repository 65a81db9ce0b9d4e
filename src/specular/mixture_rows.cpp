// SPDX-License-Identifier: MIT
#include "specular/mixture_rows.hpp"

#include <algorithm>
#include <cstring>

#include "simd/dispatch.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Row of a layer at one point, interpolated between two rows of a table.
struct Term {
    const float* low;
    const float* high;
    std::size_t size;
    std::array<float, 3> weights;
};

// Selected channels (one, or three that share rows) and selected numbers of each.
struct Part {
    std::size_t channel;  // the first channel
    std::size_t first_number, numbers;
};

// Adds the terms' numbers from j on.
template <std::size_t Count>
[[gnu::always_inline]] inline void add_terms(std::span<const Term> terms, float fraction, std::size_t j,
                                             LaneVector* sums) {
    for (const Term& term : terms) {
        if (term.size <= j) continue;
        LaneVector low;
        LaneVector high;
        std::memcpy(&low, term.low + j, sizeof low);
        std::memcpy(&high, term.high + j, sizeof high);
        low += fraction * (high - low);
        for (std::size_t c = 0; c < Count; ++c) sums[c] += term.weights[c] * low;
    }
}

// Adds all terms of one point. common: terms with one weight for all channels. The last vector overlaps the
// one before if the count of numbers is no multiple of the vector's size.
template <std::size_t Count>
[[gnu::always_inline]] inline void add_point(std::span<const Term> common, std::span<const Term> own,
                                             float fraction, const Part& of, float* out) {
    for (std::size_t at = 0; at < of.numbers; at += kLanes) {
        const std::size_t j = std::min(at, of.numbers - kLanes);
        LaneVector same{};
        add_terms<1>(common, fraction, of.first_number + j, &same);
        LaneVector sums[Count];
        for (LaneVector& sum : sums) sum = same;
        if constexpr (Count > 1) add_terms<Count>(own, fraction, of.first_number + j, sums);
        for (std::size_t c = 0; c < Count; ++c)
            std::memcpy(out + c * of.numbers + j, &sums[c], sizeof(LaneVector));
    }
}

// Adds all layers. out: [point][channel][number]. terms: space for two terms per layer.
template <std::size_t Count>
[[gnu::always_inline]] inline void add_layers(std::span<const MixtureRow> layers, const Lanes& fraction,
                                              const Part& of, std::span<Term> terms, float* out) {
    const std::span<Term> common = terms.first(layers.size());
    const std::span<Term> own = terms.last(layers.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
        std::size_t commons = 0;
        std::size_t owns = 0;
        for (const MixtureRow& layer : layers) {
            const LayerWeights& weights = *layer.weights;
            if ((weights.points >> i & 1) == 0) continue;
            const float* const row = layer.rows[i] + of.channel * layer.channel_step;
            Term& term = Count == 1 || weights.equal ? common[commons++] : own[owns++];
            term.low = row;
            term.high = row + layer.step;
            term.size = layer.size;
            for (std::size_t c = 0; c < Count; ++c) term.weights[c] = weights.of(of.channel + c).value[i];
        }
        add_point<Count>(common.first(commons), own.first(owns), fraction.value[i], of,
                         out + i * Count * of.numbers);
    }
}

// Adds all layers of one channel, for rows that are shorter than a vector.
void add_short(std::span<const MixtureRow> layers, const Lanes& fraction, const Part& of, float* out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = of.first_number; j < of.first_number + of.numbers; ++j, ++out) {
            *out = 0;
            for (const MixtureRow& layer : layers) {
                if (layer.size <= j || (layer.weights->points >> i & 1) == 0) continue;
                const float* const at = layer.rows[i] + of.channel * layer.channel_step + j;
                *out += layer.weights->of(of.channel)[i] * (at[0] + fraction[i] * (at[layer.step] - at[0]));
            }
        }
    }
}

}  // namespace

void MixtureRows::begin(std::size_t size, std::size_t channels) {
    size_ = size;
    channels_ = channels;
    alike_ = shared_ = true;
    layers_.clear();
    sums_.resize(std::max(sums_.size(), channels * size));
}

void MixtureRows::add(const MixtureRow& layer) {
    layers_.push_back(layer);
    alike_ = alike_ && layer.alike();
    shared_ = shared_ && layer.channel_step == 0;
}

void MixtureRows::sum(const Lanes& fraction, std::size_t first, std::size_t count) {
    const std::span<const MixtureRow> layers(layers_);
    const std::size_t channels = alike_ ? 1 : channels_;
    const std::size_t together = channels == 3 && shared_ && count >= kLanes ? 3 : 1;
    const std::span<Term> terms = work_space<MixtureRows, Term>(2 * layers.size());
    const std::span<float> rows = work_space<MixtureRows, float>(together * count * kLanes);
    for (std::size_t c = 0; c < channels; c += together) {
        const Part of{c, first, count};
        if (together == 3)
            dispatch<add_layers<3>>(layers, fraction, of, terms, rows.data());
        else if (count >= kLanes)
            dispatch<add_layers<1>>(layers, fraction, of, terms, rows.data());
        else
            add_short(layers, fraction, of, rows.data());
        for (std::size_t k = 0; k < together; ++k) {
            std::array<const float*, kLanes> points;
            for (std::size_t i = 0; i < kLanes; ++i) points[i] = rows.data() + (i * together + k) * count;
            to_lanes(points, count, sums_.data() + (c + k) * size_ + first);
        }
    }
}

}  // namespace nicol
