// SPDX-License-Identifier: MIT
// Functions of angles, accurate to a few roundings, for loops over lanes.
#pragma once

#include <cmath>
#include <numbers>

namespace nicol {

/// Returns whether the ratio is above tan(pi/8).
[[gnu::always_inline]] inline bool beyond_eighth(float ratio) {
    return ratio > 0.41421356F;
}

/// Returns atan(ratio) for a ratio of 0 to 1, minus pi/4 if beyond_eighth(ratio).
[[gnu::always_inline]] inline float arctangent_rest(float ratio) {
    // The polynomial in t^2 approximates atan(t) / t within 2e-8 up to tan(pi/8).
    const float t = beyond_eighth(ratio) ? (ratio - 1) / (ratio + 1) : ratio;
    const float z = t * t;
    return t * (0.99999998F + z * (-0.33332786F + z * (0.19974082F + z * (-0.13848490F + z * 0.07976292F))));
}

/// Returns atan(rise / run) over pi/2 for numbers that are not negative; 1 if both are 0.
[[gnu::always_inline]] inline float quarter_turns(float rise, float run) {
    const bool steep = rise >= run;
    const float large = steep ? rise : run;
    const float ratio = (steep ? run : rise) / (large > 0 ? large : 1.0F);
    float angle = arctangent_rest(ratio);
    angle = angle * (2 / std::numbers::pi_v<float>)+(beyond_eighth(ratio) ? 0.5F : 0.0F);
    return steep ? 1 - angle : angle;
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
