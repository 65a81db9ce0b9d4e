// SPDX-License-Identifier: MIT
// View direction of a vertex, for interpolation in a table over view directions.

#include "angle.glsl"
#include "frames.glsl"

uniform vec3 eye;         // position of a perspective camera in the world
uniform vec3 eye_rest;    // its rounding error in single precision
uniform vec3 forward;
uniform vec3 up;
uniform vec3 right;
uniform bool orthographic;

// Returns the unit vector from a point to the camera; the camera counts as straight ahead of a point at its
// position.
vec3 towards_camera(vec3 position) {
    if (orthographic) return -forward;
    precise vec3 way = (eye - position) + eye_rest;
    return way == vec3(0.0) ? -forward : normalize(way);
}

// Returns the x axis of the camera's frame field for light of that propagation direction.
vec3 camera_x(vec3 propagation) {
    vec3 x = cross(up, propagation);
    if (dot(x, x) <= 1e-12) x = right - dot(right, propagation) * propagation;
    return normalize(x);
}

struct VertexView {
    float zenith;   // zenith angle of the viewer, or pi/2 minus it: the smaller one, which has more digits
    bool grazing;   // whether `zenith` is pi/2 minus the zenith angle
    vec2 azimuth;   // cosine and sine
    vec2 rotation;  // cosine and sine of twice the angle from the theta-phi frame to the camera's frame field
};

VertexView view_from_camera(vec3 position, vec3 normal) {
    mat3 surface = theta_phi_frame(normal);
    vec3 world = towards_camera(position);
    vec3 local = world * surface;
    float rho = length(local.xy);
    VertexView view;
    view.grazing = local.z < rho;
    view.zenith = view.grazing ? angle_of(max(local.z, 0.0), rho) : angle_of(rho, local.z);
    view.azimuth = rho > 0.0 ? local.xy / rho : vec2(1.0, 0.0);
    vec2 x = (camera_x(world) * surface * theta_phi_frame(local)).xy;
    view.rotation = double_angle(x);
    return view;
}

// Position of a zenith angle in a table of `angles` angles from 0 to pi/2: the element below, and the weight
// of the element above. A normal that faces away is treated as viewed at 90 degrees.
struct TablePosition {
    int angle;
    float part;
};

TablePosition position_in(VertexView view, int angles) {
    float place = view.zenith / (0.5 * PI) * float(angles - 1);
    int whole = min(int(place), angles - 2);
    float part = place - float(whole);
    return view.grazing ? TablePosition(angles - 2 - whole, 1.0 - part) : TablePosition(whole, part);
}

// Rotates the linear polarization into the camera's frame field.
vec4 in_camera_frame(VertexView view, vec4 stokes) {
    return in_rotated_frame(stokes, view.rotation);
}
