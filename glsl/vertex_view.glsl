// SPDX-License-Identifier: MIT
// The view direction of a vertex: what interpolation in a table over view directions needs.

#include "angle.glsl"
#include "frames.glsl"

uniform vec3 eye;         // of a perspective camera, in the world
uniform vec3 eye_rest;    // what single precision leaves of it
uniform vec3 forward;
uniform vec3 up;
uniform vec3 right;
uniform bool orthographic;

// The unit vector from a point to the camera; a point at the camera itself counts as one straight ahead.
vec3 towards_camera(vec3 position) {
    if (orthographic) return -forward;
    precise vec3 way = (eye - position) + eye_rest;
    return way == vec3(0.0) ? -forward : normalize(way);
}

// The x axis of the camera's frame field for light of that propagation.
vec3 camera_x(vec3 propagation) {
    vec3 x = cross(up, propagation);
    if (dot(x, x) <= 1e-12) x = right - dot(right, propagation) * propagation;
    return normalize(x);
}

struct VertexView {
    float zenith;   // of the viewer about the normal, or pi/2 minus it, whichever is less and so has more digits
    bool grazing;   // the latter
    vec2 azimuth;   // cosine and sine
    vec2 rotation;  // of twice the angle from the theta-phi frame about the normal to the camera's frame field
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

// Zenith angle as a position in a table of `angles` from 0 to pi/2: the element below, and the weight of the one above.
// A normal that faces away is treated as viewed at 90 degrees.
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

// Linear polarization in the camera's frame field.
vec4 in_camera_frame(VertexView view, vec4 stokes) {
    return in_rotated_frame(stokes, view.rotation);
}
