// SPDX-License-Identifier: MIT
#include "simd/lane_transpose.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Exchanges the off-diagonal squares of side Step in every square of twice that side.
template <int Step, int... K>
[[gnu::always_inline]] inline void exchange(LaneVector* rows, std::integer_sequence<int, K...>) {
    for (int i = 0; i < static_cast<int>(kLanes); ++i) {
        if ((i & Step) != 0) continue;
        const LaneVector a = rows[i];
        const LaneVector b = rows[i + Step];
        rows[i] =
            __builtin_shufflevector(a, b, ((K & Step) != 0 ? static_cast<int>(kLanes) + K - Step : K)...);
        rows[i + Step] =
            __builtin_shufflevector(a, b, ((K & Step) != 0 ? static_cast<int>(kLanes) + K : K + Step)...);
    }
}

[[gnu::always_inline]] inline void transpose(LaneVector* rows) {
    constexpr std::make_integer_sequence<int, kLanes> all;
    exchange<8>(rows, all);
    exchange<4>(rows, all);
    exchange<2>(rows, all);
    exchange<1>(rows, all);
}

// Transposes squares of kLanes columns. The last square overlaps the one before if the count is no multiple
// of its side.
[[gnu::always_inline]] inline void gather(const float* const* rows, std::size_t count, Lanes* lanes) {
    for (std::size_t at = 0; at < count; at += kLanes) {
        const std::size_t j = std::min(at, count - kLanes);
        LaneVector square[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) std::memcpy(&square[i], rows[i] + j, sizeof(LaneVector));
        transpose(square);
        for (std::size_t i = 0; i < kLanes; ++i) store(lanes + j + i, square[i]);
    }
}

[[gnu::always_inline]] inline void gather_between(const float* const* rows, std::size_t step,
                                                  const float* fraction, std::size_t count, Lanes* lanes) {
    for (std::size_t at = 0; at < count; at += kLanes) {
        const std::size_t j = std::min(at, count - kLanes);
        LaneVector square[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            LaneVector low;
            LaneVector high;
            std::memcpy(&low, rows[i] + j, sizeof low);
            std::memcpy(&high, rows[i] + step + j, sizeof high);
            square[i] = low + fraction[i] * (high - low);
        }
        transpose(square);
        for (std::size_t i = 0; i < kLanes; ++i) store(lanes + j + i, square[i]);
    }
}

// Adds three weighted rows. `rows` and `weights` hold kLanes entries of the first summand, then of the
// second, then of the third.
[[gnu::always_inline]] inline void gather_weighted(const float* const* rows, const float* weights,
                                                   std::size_t count, Lanes* lanes) {
    for (std::size_t at = 0; at < count; at += kLanes) {
        const std::size_t j = std::min(at, count - kLanes);
        LaneVector square[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            LaneVector sum = {};
            for (std::size_t k = 0; k < 3 * kLanes; k += kLanes) {
                LaneVector row;
                std::memcpy(&row, rows[k + i] + j, sizeof row);
                sum += weights[k + i] * row;
            }
            square[i] = sum;
        }
        transpose(square);
        for (std::size_t i = 0; i < kLanes; ++i) store(lanes + j + i, square[i]);
    }
}

[[gnu::always_inline]] inline void take(const float* from, Lanes* lanes) {
    LaneVector fours[4];
    for (std::size_t k = 0; k < 4; ++k) std::memcpy(&fours[k], from + k * kLanes, sizeof fours[k]);
    LaneVector pairs[2][2];  // two components of eight vectors
    for (int k = 0; k < 2; ++k) {
        const LaneVector& a = fours[2 * k];
        const LaneVector& b = fours[2 * k + 1];
        pairs[0][k] = __builtin_shufflevector(a, b, 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
        pairs[1][k] =
            __builtin_shufflevector(a, b, 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
    }
    for (int p = 0; p < 2; ++p) {
        const LaneVector& a = pairs[p][0];
        const LaneVector& b = pairs[p][1];
        store(lanes + 2 * p,
              __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23));
        store(lanes + 2 * p + 1,
              __builtin_shufflevector(a, b, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31));
    }
}

using FourFloats [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(4)]] = float;

template <bool Add>
[[gnu::always_inline]] inline void give_fours(const Lanes* lanes, const std::uint8_t* show, std::size_t count,
                                              float* out) {
    LaneVector p[4];
    for (int k = 0; k < 4; ++k) p[k] = *reinterpret_cast<const LaneVector*>(lanes + k);
    LaneVector pairs[2][2];
    for (int k = 0; k < 2; ++k) {
        const LaneVector& a = p[2 * k];
        const LaneVector& b = p[2 * k + 1];
        pairs[k][0] = __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
        pairs[k][1] =
            __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
    }
    LaneVector fours[4];
    for (int k = 0; k < 2; ++k) {
        fours[2 * k] = __builtin_shufflevector(pairs[0][k], pairs[1][k], 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20,
                                               21, 6, 7, 22, 23);
        fours[2 * k + 1] = __builtin_shufflevector(pairs[0][k], pairs[1][k], 8, 9, 24, 25, 10, 11, 26, 27, 12,
                                                   13, 28, 29, 14, 15, 30, 31);
    }
    const auto* from = reinterpret_cast<const FourFloats*>(fours);
    auto* to = reinterpret_cast<FourFloats*>(out);
    for (std::size_t i = 0; i < count; ++i) {
        if (show[i] == 0) continue;
        if constexpr (Add) {
            to[i] += from[i];
        } else {
            to[i] = from[i];
        }
    }
}

[[gnu::always_inline]] inline void put(const Lanes* lanes, const std::uint8_t* show, std::size_t count,
                                       float* out) {
    give_fours<false>(lanes, show, count, out);
}

[[gnu::always_inline]] inline void add(const Lanes* lanes, const std::uint8_t* show, std::size_t count,
                                       float* out) {
    give_fours<true>(lanes, show, count, out);
}

}  // namespace

void take_fours(const glm::vec4* from, Lanes* lanes) {
    dispatch<take>(&from->x, lanes);
}

void put_fours(const Lanes* lanes, const std::uint8_t* show, std::size_t count, glm::vec4* out) {
    dispatch<put>(lanes, show, count, &out->x);
}

void add_fours(const Lanes* lanes, const std::uint8_t* show, std::size_t count, glm::vec4* out) {
    dispatch<add>(lanes, show, count, &out->x);
}

void add_fours(const Lanes* lanes, std::size_t count, glm::vec4* out) {
    static constexpr std::array<std::uint8_t, kLanes> all = [] {
        std::array<std::uint8_t, kLanes> ones{};
        ones.fill(1);
        return ones;
    }();
    add_fours(lanes, all.data(), count, out);
}

void to_lanes(const std::array<const float*, kLanes>& rows, std::size_t count, Lanes* lanes) {
    if (count >= kLanes) {
        dispatch<gather>(rows.data(), count, lanes);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < count; ++j) lanes[j][i] = rows[i][j];
    }
}

void to_lanes_between(const std::array<const float*, kLanes>& rows, std::size_t step, const Lanes& fraction,
                      std::size_t count, Lanes* lanes) {
    if (count >= kLanes) {
        dispatch<gather_between>(rows.data(), step, fraction.value.data(), count, lanes);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < count; ++j)
            lanes[j][i] = rows[i][j] + fraction[i] * (rows[i][step + j] - rows[i][j]);
    }
}

void to_lanes_weighted(const std::array<std::array<const float*, kLanes>, 3>& rows,
                       const std::array<Lanes, 3>& weights, std::size_t count, Lanes* lanes) {
    if (count >= kLanes) {
        dispatch<gather_weighted>(rows.front().data(), weights.front().value.data(), count, lanes);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            lanes[j][i] =
                weights[0][i] * rows[0][i][j] + weights[1][i] * rows[1][i][j] + weights[2][i] * rows[2][i][j];
        }
    }
}

}  // namespace nicol
