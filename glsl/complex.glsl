// SPDX-License-Identifier: MIT
// Complex numbers (real, imaginary).

vec2 complex_multiply(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

vec2 complex_conjugate(vec2 a) {
    return vec2(a.x, -a.y);
}

// Returns a^exponent for |a| = 1.
vec2 complex_power(vec2 a, int exponent) {
    vec2 factor = exponent < 0 ? complex_conjugate(a) : a;
    vec2 power = vec2(1.0, 0.0);
    for (int i = abs(exponent); i > 0; i >>= 1) {
        if ((i & 1) != 0) power = complex_multiply(power, factor);
        factor = complex_multiply(factor, factor);
    }
    return power;
}
