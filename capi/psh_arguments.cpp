// SPDX-License-Identifier: MIT
#include "psh_arguments.hpp"

#include <cmath>
#include <functional>
#include <limits>

namespace nicol::capi {
namespace {

void check_length(const double* values, std::uint64_t count, std::uint64_t vectors, std::uint64_t size,
                  const char* name) {
    constexpr std::uint64_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double);
    if (count > most) {
        refuse("the length of " + std::string(name) + " is " + std::to_string(count) +
               "; no memory holds more than " + std::to_string(most) + " doubles");
    }
    // Division is used, because the product may overflow.
    const bool fits = vectors == 0 || size == 0 ? count == 0 : count % size == 0 && count / size == vectors;
    if (!fits) {
        refuse("the length of " + std::string(name) + " is " + std::to_string(count) + "; it must be " +
               std::to_string(vectors) + " x " + std::to_string(size));
    }
    if (count > 0) require(values, name);
}

bool overlap(std::span<const double> a, std::span<const double> b) {
    const std::less<> before;
    return !a.empty() && !b.empty() && before(a.data(), b.data() + b.size()) &&
           before(b.data(), a.data() + a.size());
}

}  // namespace

int read_order(std::uint32_t order, const char* name, std::uint32_t highest) {
    if (order > highest) {
        refuse(std::string(name) + " is " + std::to_string(order) + "; it must be at most " +
               std::to_string(highest));
    }
    return static_cast<int>(order);
}

std::span<const double> read_array(const double* values, std::uint64_t count, std::uint64_t vectors,
                                   std::uint64_t size, const char* name) {
    check_length(values, count, vectors, size, name);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (!std::isfinite(values[i]))
            refuse(std::string(name) + "[" + std::to_string(i) + "] is not finite");
    }
    return {values, count};
}

std::span<double> write_array(double* values, std::uint64_t count, std::uint64_t vectors, std::uint64_t size,
                              const char* name) {
    check_length(values, count, vectors, size, name);
    return {values, count};
}

void require_apart(std::span<const double> in, std::span<const double> out, const char* what) {
    if (overlap(in, out)) refuse(std::string(what) + " must not overlap");
}

void require_same_or_apart(std::span<const double> in, std::span<const double> out, const char* what) {
    if (in.data() == out.data() && in.size() == out.size()) return;
    if (overlap(in, out)) refuse(std::string(what) + " must be the same memory or not overlap");
}

}  // namespace nicol::capi
