// SPDX-License-Identifier: MIT
// The arctangent within a few roundings, for loops over lanes.
#pragma once

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

}  // namespace nicol
