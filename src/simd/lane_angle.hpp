// SPDX-License-Identifier: MIT
// Functions of angles within a few roundings, for loops over lanes.
#pragma once

#include <cmath>
#include <numbers>

namespace nicol {

/// The ratio is above tan(pi/8).
[[gnu::always_inline]] inline bool beyond_eighth(float ratio) {
    return ratio > 0.41421356F;
}

/// atan(ratio) for a ratio of 0 to 1, less pi/4 where that is beyond_eighth().
[[gnu::always_inline]] inline float arctangent_rest(float ratio) {
    // Up to tan(pi/8) the fit of atan(t) / t in t^2 is good to 2e-8.
    const float t = beyond_eighth(ratio) ? (ratio - 1) / (ratio + 1) : ratio;
    const float z = t * t;
    return t * (0.99999998F + z * (-0.33332786F + z * (0.19974082F + z * (-0.13848490F + z * 0.07976292F))));
}

/// atan(rise / run) over pi/2 for what is not negative; 1 where both are 0.
[[gnu::always_inline]] inline float quarter_turns(float rise, float run) {
    const bool steep = rise >= run;
    const float large = steep ? rise : run;
    const float ratio = (steep ? run : rise) / (large > 0 ? large : 1.0F);
    float angle = arctangent_rest(ratio);
    angle = angle * (2 / std::numbers::pi_v<float>)+(beyond_eighth(ratio) ? 0.5F : 0.0F);
    return steep ? 1 - angle : angle;
}

/// Cosine and sine of 2 pi turns, for turns of 0 to 1.
[[gnu::always_inline]] inline void turn(float turns, float& cosine, float& sine) {
    const float half = turns - 0.5F;
    const float a = (0.25F - std::abs(half)) * (2 * std::numbers::pi_v<float>);  // -pi/2 to pi/2
    const float z = a * a;
    // Taylor's series, good to 6e-8 and 5e-7.
    cosine =
        -a * (1 + z * (-1 / 6.0F +
                       z * (1 / 120.0F + z * (-1 / 5040.0F + z * (1 / 362880.0F - z * (1 / 39916800.0F))))));
    const float away =
        1 + z * (-1 / 2.0F + z * (1 / 24.0F + z * (-1 / 720.0F + z * (1 / 40320.0F - z * (1 / 3628800.0F)))));
    sine = half > 0 ? -away : away;
}

}  // namespace nicol
