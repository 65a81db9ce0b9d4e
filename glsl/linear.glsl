// SPDX-License-Identifier: MIT
// Linear polarization of a Stokes vector: its degree (DoLP) and its angle (AoLP).
#include "angle.glsl"

// Numbers that are not finite count as 0.
vec4 finite_or_zero(vec4 s) {
    return mix(s, vec4(0.0), bvec4(uvec4(isnan(s)) | uvec4(isinf(s))));
}

float dolp(vec4 s) {
    return s.x > 0.0 ? min(length(s.yz) / s.x, 1.0) : 0.0;
}

// Returns an angle in (-pi/2, pi/2].
float aolp(vec4 s) {
    // The sum turns -0 into 0, so that vertical polarization is pi / 2 and never -pi / 2.
    return s.x > 0.0 ? 0.5 * angle_of(s.z + 0.0, s.y) : 0.0;
}
