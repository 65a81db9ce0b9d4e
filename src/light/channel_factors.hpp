// SPDX-License-Identifier: MIT
// Factors of a light's channels.
#pragma once

#include <array>
#include <cstddef>

namespace nicol {

/// Factors of channels that a light's coefficients do not have. Channels that are multiples of each other
/// share coefficients, and differ in their factors.
struct ChannelFactors {
    static constexpr std::size_t kMost = 16;  ///< largest number of channels

    std::array<float, kMost> of{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

    /// Returns whether all factors are 1.
    [[nodiscard]] bool none() const { return *this == ChannelFactors(); }
    bool operator==(const ChannelFactors&) const = default;
};

}  // namespace nicol
