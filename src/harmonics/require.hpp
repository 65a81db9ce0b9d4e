// SPDX-License-Identifier: MIT
// Argument checks shared by the folder.
#pragma once

#include <cmath>
#include <span>
#include <string>

#include "error.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

inline void require(bool condition, const std::string& message) {
    if (!condition) throw Error(ErrorCode::invalid_argument, message);
}

inline void require_order(int order) {
    if (order < 0 || order > kMaxOrder)
        throw Error(ErrorCode::invalid_argument,
                    "order is " + std::to_string(order) + ", expected 0 to " + std::to_string(kMaxOrder));
}

inline void require_size(std::size_t have, std::size_t want, const char* what) {
    if (have != want)
        throw Error(ErrorCode::invalid_argument, std::string(what) + " holds " + std::to_string(have) +
                                                     " values, expected " + std::to_string(want));
}

inline void require_finite(std::span<const double> values, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw Error(ErrorCode::invalid_argument,
                        std::string(what) + " value " + std::to_string(i) + " is not finite");
}

/// (-1)^k for any integer k.
constexpr double parity(int k) {
    return (k & 1) != 0 ? -1.0 : 1.0;
}

}  // namespace nicol
