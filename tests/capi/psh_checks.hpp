// SPDX-License-Identifier: MIT
// An argument of the mathematics, wrong in every way: the code, the argument's name, and outputs untouched.
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

/// call(values, count) must refuse NULL, wrong lengths and, of an input, values that are not finite.
template <class Call>
void check_input(std::size_t count, const char* name, Call call) {
    CAPTURE(name);
    const Doubles good(count);
    FAILS(call(nullptr, count), NICOL_ERROR_INVALID_ARGUMENT, std::string(name) + " is NULL");
    for (const std::uint64_t wrong : {std::uint64_t{0}, std::uint64_t{count - 1}, std::uint64_t{count + 1},
                                      std::uint64_t{2 * count}, huge, huge / 8 + 1})
        FAILS(call(good.data(), wrong), NICOL_ERROR_INVALID_ARGUMENT, std::string("length of ") + name);
    for (const double wrong : {not_a_number, infinity, -infinity})
        for (const std::size_t at : {std::size_t{0}, count / 2, count - 1}) {
            Doubles bad = good;
            bad[at] = wrong;
            FAILS(call(bad.data(), count), NICOL_ERROR_INVALID_ARGUMENT,
                  std::string(name) + "[" + std::to_string(at) + "]");
        }
}

template <class Call>
void check_output(std::size_t count, const char* name, Call call) {
    CAPTURE(name);
    Untouched out(count);
    FAILS(call(nullptr, count), NICOL_ERROR_INVALID_ARGUMENT, std::string(name) + " is NULL");
    for (const std::uint64_t wrong : {std::uint64_t{0}, std::uint64_t{count - 1}, std::uint64_t{count + 1},
                                      std::uint64_t{2 * count}, huge})
        FAILS(call(out.data(), wrong), NICOL_ERROR_INVALID_ARGUMENT, std::string("length of ") + name);
}

template <class Call>
void check_order(std::uint32_t highest, const char* name, Call call) {
    CAPTURE(name);
    for (const std::uint32_t wrong : {highest + 1, 65535U, 65536U, 0x80000000U, UINT32_MAX})
        FAILS(call(wrong), NICOL_ERROR_INVALID_ARGUMENT, std::string(name) + " is " + std::to_string(wrong));
}

}  // namespace capi_test
