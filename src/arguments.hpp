// SPDX-License-Identifier: MIT
// Checks of arguments that throw Error(invalid_argument).
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "error.hpp"

namespace nicol {

/// Throws Error(invalid_argument).
[[noreturn]] inline void refuse(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message);
}

inline void require(bool condition, const std::string& message) {
    if (!condition) refuse(message);
}

inline void require_size(std::size_t have, std::size_t want, const char* what) {
    if (have != want)
        refuse(std::string(what) + " holds " + std::to_string(have) + " values, expected " +
               std::to_string(want));
}

inline void require_finite(std::span<const double> values, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            refuse(std::string(what) + " value " + std::to_string(i) + " is not finite");
}

}  // namespace nicol
