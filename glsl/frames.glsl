// SPDX-License-Identifier: MIT
// Frames of Stokes vectors and the directions they belong to, as in polarization/view_geometry.hpp.

// Returns the theta-phi frame of a unit direction; phi is 0 on the z axis.
mat3 theta_phi_frame(vec3 direction) {
    float rho = length(direction.xy);
    vec2 phi = rho > 0.0 ? direction.xy / rho : vec2(1.0, 0.0);
    return mat3(direction.z * phi, -rho, -phi.y, phi.x, 0.0, direction);
}

// Returns the view direction or, if the normal faces away, the nearest direction that the normal faces, at 90
// degrees. Returns `fallback` if the normal faces exactly away. All vectors are unit vectors.
vec3 facing_view(vec3 normal, vec3 view, vec3 fallback) {
    float cosine = dot(normal, view);
    if (cosine >= 0.0) return view;
    vec3 along = view - cosine * normal;
    return dot(along, along) > 1e-10 ? normalize(along) : fallback;
}

// Returns cosine and sine of twice an angle from cosine and sine of the angle.
vec2 double_angle(vec2 angle) {
    return vec2(angle.x * angle.x - angle.y * angle.y, 2.0 * angle.x * angle.y);
}

// Returns a Stokes vector in a frame rotated by an angle, from cosine and sine of twice the angle.
vec4 in_rotated_frame(vec4 stokes, vec2 twice) {
    return vec4(stokes.x, twice.x * stokes.y + twice.y * stokes.z, twice.x * stokes.z - twice.y * stokes.y, stokes.w);
}
