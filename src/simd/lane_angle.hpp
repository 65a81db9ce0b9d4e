// SPDX-License-Identifier: MIT
// Functions of angles, accurate to a few roundings, for loops over lanes.
#pragma once

#include <cmath>
#include <numbers>

namespace nicol {

/// Ratio above which arctangent_rest() leaves pi/4 out: tan(pi/8).
inline constexpr float kEighth = 0.41421356F;

/// Computes atan(ratio) for a ratio of 0 to 1, minus pi/4 if the ratio is above kEighth. Number: float, or a
/// vector of it.
template <class Number>
[[gnu::always_inline]] inline void arctangent_rest(const Number& ratio, Number& angle) {
    // The polynomial in t^2 approximates atan(t) / t within 2e-8 up to tan(pi/8).
    const Number t = ratio > kEighth ? (ratio - 1.0F) / (ratio + 1.0F) : ratio;
    const Number z = t * t;
    angle = t * (0.99999998F + z * (-0.33332786F + z * (0.19974082F + z * (-0.13848490F + z * 0.07976292F))));
}

/// Computes atan(rise / run) over pi/2 for numbers that are not negative; 1 if both are 0. Number: float, or
/// a vector of it.
template <class Number>
[[gnu::always_inline]] inline void quarter_turns(const Number& rise, const Number& run, Number& turns) {
    const auto steep = rise >= run;
    const Number large = steep ? rise : run;
    const Number ratio = (steep ? run : rise) / (large > 0.0F ? large : Number{} + 1.0F);
    arctangent_rest(ratio, turns);
    turns *= 2 / std::numbers::pi_v<float>;
    turns += ratio > kEighth ? Number{} + 0.5F : Number{};
    turns = steep ? 1.0F - turns : turns;
}

/// Computes the cosine and sine of 2 pi turns, for turns of 0 to 1.
[[gnu::always_inline]] inline void turn(float turns, float& cosine, float& sine) {
    const float half = turns - 0.5F;
    const float a = (0.25F - std::abs(half)) * (2 * std::numbers::pi_v<float>);  // -pi/2 to pi/2
    const float z = a * a;
    // Taylor series with errors below 6e-8 and 5e-7.
    cosine =
        -a * (1 + z * (-1 / 6.0F +
                       z * (1 / 120.0F + z * (-1 / 5040.0F + z * (1 / 362880.0F - z * (1 / 39916800.0F))))));
    const float away =
        1 + z * (-1 / 2.0F + z * (1 / 24.0F + z * (-1 / 720.0F + z * (1 / 40320.0F - z * (1 / 3628800.0F)))));
    sine = half > 0 ? -away : away;
}

}  // namespace nicol
