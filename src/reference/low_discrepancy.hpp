// SPDX-License-Identifier: MIT
// Low-discrepancy points: Sobol's first two dimensions with Owen's scrambling.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace nicol {

/// Returns a well-mixed 64-bit function of two numbers.
[[nodiscard]] std::uint64_t mixed(std::uint64_t a, std::uint64_t b);

/// Points of one pixel. Each `stream` is a separate sequence of points in [0, 1)^2: one of its first 2^k
/// points lies in every box of area 2^-k whose sides are powers of 1/2. Streams of one index are independent
/// of each other, and so are streams of different seeds.
class LowDiscrepancy {
public:
    explicit LowDiscrepancy(std::uint64_t seed) : seed_(seed) {}

    [[nodiscard]] glm::dvec2 point(std::uint32_t index, std::uint32_t stream) const;

private:
    std::uint64_t seed_;
};

}  // namespace nicol
