// SPDX-License-Identifier: MIT
#include "transfer/lane_transpose.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "transfer/lane_vector.hpp"
#include "transfer/simd.hpp"

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

// The last square overlaps the one before where the count is no multiple of its side.
NICOL_MULTIVERSION
void gather(const float* const* rows, std::size_t count, Lanes* lanes) {
    for (std::size_t at = 0; at < count; at += kLanes) {
        const std::size_t j = std::min(at, count - kLanes);
        LaneVector square[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) std::memcpy(&square[i], rows[i] + j, sizeof(LaneVector));
        transpose(square);
        for (std::size_t i = 0; i < kLanes; ++i) store(lanes + j + i, square[i]);
    }
}

NICOL_MULTIVERSION
void gather_between(const float* const* rows, std::size_t step, const float* fraction, std::size_t count,
                    Lanes* lanes) {
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

}  // namespace

void to_lanes(const std::array<const float*, kLanes>& rows, std::size_t count, Lanes* lanes) {
    if (count >= kLanes) {
        gather(rows.data(), count, lanes);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < count; ++j) lanes[j][i] = rows[i][j];
    }
}

void to_lanes_between(const std::array<const float*, kLanes>& rows, std::size_t step, const Lanes& fraction,
                      std::size_t count, Lanes* lanes) {
    if (count >= kLanes) {
        gather_between(rows.data(), step, fraction.value.data(), count, lanes);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < count; ++j)
            lanes[j][i] = rows[i][j] + fraction[i] * (rows[i][step + j] - rows[i][j]);
    }
}

}  // namespace nicol
