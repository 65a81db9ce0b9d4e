// SPDX-License-Identifier: MIT
// Decisions for all lanes of a part at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nicol {

/// Returns whether a comparison of two parts holds in every lane.
template <class Condition>
[[gnu::always_inline]] inline bool all_lanes(const Condition& condition) {
    std::array<std::uint64_t, sizeof(Condition) / sizeof(std::uint64_t)> words;
    __builtin_memcpy(words.data(), &condition, sizeof words);
    std::uint64_t all = ~std::uint64_t{};
    for (const std::uint64_t word : words) all &= word;
    return all == ~std::uint64_t{};
}

}  // namespace nicol
