// SPDX-License-Identifier: MIT
// The physical range of Stokes vectors (Eq. 70).

bool is_physical(vec4 stokes) {
    return stokes.x >= 0.0 && dot(stokes.yzw, stokes.yzw) <= stokes.x * stokes.x;
}

// Clamps s0 to 0 and the polarized part to s0.
vec4 made_physical(vec4 stokes) {
    float polarized2 = dot(stokes.yzw, stokes.yzw);
    float s0 = max(stokes.x, 0.0);
    return vec4(s0, stokes.yzw * (polarized2 > 0.0 ? min(s0 / sqrt(polarized2), 1.0) : 1.0));
}
