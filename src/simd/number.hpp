// SPDX-License-Identifier: MIT
// Constants and conditions of formulas that are written once for single numbers and for vectors of lanes.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

namespace nicol {

namespace detail {

template <class Number>
struct Scalar {
    using Type = std::remove_cvref_t<decltype(std::declval<Number&>()[0])>;
};
template <std::floating_point Number>
struct Scalar<Number> {
    using Type = Number;
};

}  // namespace detail

/// Type of one lane of Number; Number itself if that is float or double.
template <class Number>
using ScalarOf = typename detail::Scalar<Number>::Type;

/// `value` in the precision of Number. Literals that single precision holds exactly, such as 0.5F, do not
/// need this function.
template <class Number>
[[nodiscard]] consteval ScalarOf<Number> constant(double value) {
    return static_cast<ScalarOf<Number>>(value);
}

/// A threshold that depends on the range or the rounding of Number's precision.
template <class Number>
[[nodiscard]] consteval ScalarOf<Number> threshold(float in_single, double in_double) {
    if constexpr (std::is_same_v<ScalarOf<Number>, double>) {
        return in_double;
    } else {
        return in_single;
    }
}

/// Whether a condition is known to hold. False for lanes, which do not branch.
template <class Condition>
[[gnu::always_inline]] constexpr bool known(const Condition& condition) {
    if constexpr (std::is_same_v<Condition, bool>) {
        return condition;
    } else {
        return false;
    }
}

}  // namespace nicol
