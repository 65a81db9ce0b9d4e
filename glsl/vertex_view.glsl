// SPDX-License-Identifier: MIT
// How a vertex is seen: what looking up a table at the view direction needs.

#include "angle.glsl"

uniform vec3 eye;         // of a perspective camera, in the world
uniform vec3 eye_rest;    // what single precision leaves of it
uniform vec3 forward;
uniform vec3 up;
uniform vec3 right;
uniform bool orthographic;

// The theta-phi frame of a unit direction; on the z axis phi is 0.
mat3 theta_phi_frame(vec3 direction) {
    float rho = length(direction.xy);
    vec2 phi = rho > 0.0 ? direction.xy / rho : vec2(1.0, 0.0);
    return mat3(direction.z * phi, -rho, -phi.y, phi.x, 0.0, direction);
}

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

// The mirrored view direction in the frame about a normal, which view faces or is taken to see at 90 degrees. Straight
// from behind every direction along the surface serves.
vec3 mirrored_view(vec3 view, mat3 surface) {
    vec3 local = view * surface;
    vec3 d = vec3(local.xy, -max(local.z, 0.0));
    return dot(d, d) > 1e-10 ? normalize(d) : camera_x(view) * surface;
}

struct VertexView {
    float zenith;   // of the viewer about the normal, or pi/2 minus it, whichever is less and so has more digits
    bool grazing;   // the latter
    vec2 azimuth;   // cosine and sine
    vec2 turn;      // of twice the angle from the theta-phi frame about the normal to the camera's frame field
};

VertexView look(vec3 position, vec3 normal) {
    mat3 surface = theta_phi_frame(normal);
    vec3 world = towards_camera(position);
    vec3 local = world * surface;
    float rho = length(local.xy);
    VertexView seen;
    seen.grazing = local.z < rho;
    seen.zenith = seen.grazing ? angle_of(max(local.z, 0.0), rho) : angle_of(rho, local.z);
    seen.azimuth = rho > 0.0 ? local.xy / rho : vec2(1.0, 0.0);
    vec2 x = (camera_x(world) * surface * theta_phi_frame(local)).xy;
    seen.turn = vec2(x.x * x.x - x.y * x.y, 2.0 * x.x * x.y);
    return seen;
}

// Zenith angle as a position in a table of `angles` from 0 to pi/2: the element below, and the weight of the one above.
// A normal that faces away is treated as seen at 90 degrees.
struct TablePosition {
    int angle;
    float part;
};

TablePosition position_in(VertexView seen, int angles) {
    float place = seen.zenith / (0.5 * PI) * float(angles - 1);
    int whole = min(int(place), angles - 2);
    float part = place - float(whole);
    return seen.grazing ? TablePosition(angles - 2 - whole, 1.0 - part) : TablePosition(whole, part);
}

// Linear polarization in the camera's frame field.
vec4 in_camera_frame(VertexView seen, vec4 stokes) {
    return vec4(stokes.x, seen.turn.x * stokes.y + seen.turn.y * stokes.z,
                seen.turn.x * stokes.z - seen.turn.y * stokes.y, stokes.w);
}
