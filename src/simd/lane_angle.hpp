// SPDX-License-Identifier: MIT
// The arctangent within a few roundings, for loops over lanes.
#pragma once

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

}  // namespace nicol
