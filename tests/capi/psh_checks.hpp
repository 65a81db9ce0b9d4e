// SPDX-License-Identifier: MIT
// Values that no argument may have, and outputs that must stay as they are.
#pragma once

#include <limits>

#include "psh.hpp"

namespace capi_test {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::uint64_t huge = UINT64_MAX;

/// An output that must stay as it is.
class Untouched {
public:
    explicit Untouched(std::size_t count) : values_(count, -7.5) {}
    ~Untouched() {
        for (const double x : values_) CHECK(x == -7.5);
    }
    Untouched(const Untouched&) = delete;
    Untouched& operator=(const Untouched&) = delete;
    double* data() { return values_.data(); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }

private:
    Doubles values_;
};

}  // namespace capi_test
