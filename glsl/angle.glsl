// SPDX-License-Identifier: MIT
// Angle of a vector in the plane.

const float PI = 3.14159265358979;

// Returns the angle of (x, y), 0 if both are 0. Drivers' own atan() may err by 1e-5, a visible part of a
// texel.
float angle_of(float y, float x) {
    vec2 size = abs(vec2(x, y));
    float large = max(size.x, size.y);
    float ratio = large > 0.0 ? min(size.x, size.y) / large : 0.0;
    // The ratio is reduced to at most tan(pi/8), where the fit of atan(t) / t in t^2 errs by at most 2e-8.
    bool beyond = ratio > 0.41421356;
    float t = beyond ? (ratio - 1.0) / (ratio + 1.0) : ratio;
    float z = t * t;
    float angle = t * (0.99999998 + z * (-0.33332786 + z * (0.19974082 + z * (-0.13848490 + z * 0.07976292))));
    if (beyond) angle += 0.25 * PI;
    if (size.y > size.x) angle = 0.5 * PI - angle;
    if (x < 0.0) angle = PI - angle;
    return y < 0.0 ? -angle : angle;
}
