// SPDX-License-Identifier: MIT
// Checks of orders, and signs of degrees.
#pragma once

#include <string>

#include "arguments.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

inline void require_order(int order) {
    if (order < 0 || order > kMaxOrder)
        refuse("order is " + std::to_string(order) + ", expected 0 to " + std::to_string(kMaxOrder));
}

/// Returns (-1)^k for any integer k.
constexpr double parity(int k) {
    return (k & 1) != 0 ? -1.0 : 1.0;
}

}  // namespace nicol
