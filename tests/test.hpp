// SPDX-License-Identifier: MIT
// Common header of the tests: the framework, standard headers, and checks of errors.
#pragma once

#define DOCTEST_CONFIG_VOID_CAST_EXPRESSIONS  // so that results may be ignored
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "error.hpp"

using std::numbers::pi;

/// Turns an expression into a function without arguments, for error_of() and check_error().
#define CALL(...) [&] { static_cast<void>(__VA_ARGS__); }

/// Returns the message of the nicol::Error with this code that `call` must throw, or an empty string if it
/// throws none.
template <class Call>
std::string error_of(Call&& call, nicol::ErrorCode code = nicol::ErrorCode::invalid_argument) {
    try {
        call();
    } catch (const nicol::Error& e) {
        CHECK_MESSAGE(e.code() == code, e.what());
        return e.what();
    }
    FAIL_CHECK("no error");
    return {};
}

/// Checks that `call` throws nicol::Error with this code and a message that contains every one of `parts`.
template <class Call, class... Parts>
void check_error(nicol::ErrorCode code, Call&& call, const Parts&... parts) {
    const std::string message = error_of(call, code);
    for (const std::string& part : std::vector<std::string>{parts...})
        CHECK_MESSAGE(message.find(part) != std::string::npos, message, " lacks ", part);
}

/// Returns values side by side, as doctest prints them.
template <class... Values>
std::string listed(const Values&... values) {
    std::string out;
    for (const doctest::String& value : {doctest::toString(values)...})
        out += (out.empty() ? "" : ", ") + std::string(value.c_str());
    return out;
}
struct CapturedText {
    std::string text;
    void operator()(std::ostream* out) const { *out << text; }
};
/// doctest's CAPTURE for several values and for structured bindings, which no lambda of Clang 14 can capture.
#define CAPTURES(...)                         \
    const auto DOCTEST_ANONYMOUS(captured_) = \
        doctest::detail::MakeContextScope(CapturedText{#__VA_ARGS__ " = " + listed(__VA_ARGS__)})
#undef CAPTURE
#define CAPTURE(value) CAPTURES(value)

/// Calls f with every combination of one value of each list.
template <class A, class B, class F>
void for_all(std::initializer_list<A> as, std::initializer_list<B> bs, const F& f) {
    for (const A& a : as)
        for (const B& b : bs) f(a, b);
}
template <class A, class B, class C, class F>
void for_all(std::initializer_list<A> as, std::initializer_list<B> bs, std::initializer_list<C> cs,
             const F& f) {
    for_all(as, bs, [&](const A& a, const B& b) {
        for (const C& c : cs) f(a, b, c);
    });
}

/// Returns the numbers of a range, an image, a coefficient vector or a matrix.
template <class T>
decltype(auto) numbers_in(const T& x) {
    if constexpr (std::ranges::range<const T>)
        return (x);
    else if constexpr (requires { x.data(); })
        return x.data();
    else
        return (x.data);
}
template <glm::length_t C, glm::length_t R, class T>
std::vector<T> numbers_in(const glm::mat<C, R, T>& m) {
    return {&m[0][0], &m[0][0] + C * R};
}

/// Returns the largest absolute value, or the largest difference of two equally long sequences. NaN counts as
/// infinite.
template <class T>
double largest(const T& x) {
    double most = 0;
    for (const auto value : numbers_in(x))
        most = std::isnan(value) ? HUGE_VAL : std::max(most, static_cast<double>(std::abs(value)));
    return most;
}
template <class A, class B>
double largest_difference(const A& a, const B& b) {
    const auto& x = numbers_in(a);
    const auto& y = numbers_in(b);
    REQUIRE(std::size(x) == std::size(y));
    std::vector<double> difference(std::size(x));
    for (std::size_t i = 0; i < difference.size(); ++i)
        difference[i] = static_cast<double>(x[i]) - static_cast<double>(y[i]);
    return largest(difference);
}

/// Checks that an expression throws nicol::Error(invalid_argument).
#define CHECK_INVALID(...) check_error(nicol::ErrorCode::invalid_argument, CALL(__VA_ARGS__))

/// Returns a file of NICOL_TEST_DATA, the folder of third-party data. Prints a message and returns an empty
/// path if the file is absent.
inline std::filesystem::path test_data(const std::string& name) {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path file = std::filesystem::path(folder != nullptr ? folder : "") / name;
    if (std::filesystem::exists(file)) return file;
    MESSAGE("skipped: NICOL_TEST_DATA has no " << name);
    return {};
}
