// SPDX-License-Identifier: MIT
// Physically realizable range of Stokes vectors (Eq. 70), as in make_physical().

bool is_physical(vec4 stokes) {
    return stokes.x >= 0.0 && dot(stokes.yzw, stokes.yzw) <= stokes.x * stokes.x;
}

// Clamps s0 to 0 and the polarized part to s0. Shortens the polarized part if s0 is as small as the noise.
vec4 made_physical(vec4 stokes, float noise) {
    float polarized2 = dot(stokes.yzw, stokes.yzw);
    float s0 = max(stokes.x, 0.0);
    float factor = polarized2 > 0.0 ? min(s0 / sqrt(polarized2), 1.0) : 1.0;
    if (noise > 0.0) factor = s0 > 0.0 ? factor / (1.0 + noise / s0 * (noise / s0)) : 0.0;
    return vec4(s0, stokes.yzw * factor);
}
