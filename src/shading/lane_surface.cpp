// SPDX-License-Identifier: MIT
#include "shading/lane_surface.hpp"

#include <algorithm>

#include "polarization/lane_points.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Rays from the eye, or from beside it for an orthographic camera.
struct Rays {
    Vector3<float> backward, up, right;
    float perspective;  // 1, or 0 for an orthographic camera
    Lanes x, y;
};

struct Triangles {
    LaneVectors first;          // first corner, relative to the eye
    LaneVectors second, third;  // edges from the first corner to the others
    std::array<LaneVectors, 3> normals;
};

struct Points {
    std::array<Lanes, 3> weights;
    LaneVectors offset;  // offset from the first corner
    LaneVectors normal;
};

// The compiler's own vector type. GCC does not vectorise plain loops over lanes with so many conditions.
using Number [[gnu::vector_size(64)]] = float;

[[gnu::always_inline]] inline void load(const Lanes& from, Number& to) {
    to = *reinterpret_cast<const LaneVector*>(&from);
}

[[gnu::always_inline]] inline Vector3<Number> load(const LaneVectors& from) {
    Vector3<Number> to;
    load(from.x, to.x);
    load(from.y, to.y);
    load(from.z, to.z);
    return to;
}

[[gnu::always_inline]] inline void store(LaneVectors& to, const Vector3<Number>& from) {
    store(&to.x, from.x);
    store(&to.y, from.y);
    store(&to.z, from.z);
}

// Clamps x to 0..most; a NaN becomes 0.
[[gnu::always_inline]] inline void move_between_zero_and(const Number& most, Number& x) {
    x = x > 0 ? x : Number{};
    x = x < most ? x : most;
}

// Intersects rays and planes by Cramer's rule.
[[gnu::always_inline]] inline void meet(const Rays& rays, const Triangles& triangles, Points& out) {
    Number x;
    Number y;
    load(rays.x, x);
    load(rays.y, y);
    const Vector3<Number> aside{x * rays.right.x + y * rays.up.x, x * rays.right.y + y * rays.up.y,
                                x * rays.right.z + y * rays.up.z};
    const float near = rays.perspective;
    const Vector3<Number> direction{near * aside.x - rays.backward.x, near * aside.y - rays.backward.y,
                                    near * aside.z - rays.backward.z};
    const Vector3<Number> first = load(triangles.first);
    const Vector3<Number> begin{(1 - near) * aside.x - first.x, (1 - near) * aside.y - first.y,
                                (1 - near) * aside.z - first.z};
    const Vector3<Number> second = load(triangles.second);
    const Vector3<Number> third = load(triangles.third);

    const Number one = Number{} + 1.0F;
    const Vector3<Number> across = cross(direction, third);
    Number determinant;
    dot(second, across, determinant);
    const Number inverse = 1.0F / (determinant == 0.0F ? one : determinant);
    Number u;
    dot(begin, across, u);
    u *= inverse;
    move_between_zero_and(one, u);
    Number v;
    dot(direction, cross(begin, second), v);
    v *= inverse;
    move_between_zero_and(one - u, v);
    const Number w = one - u - v;
    store(out.weights.data(), w);
    store(&out.weights[1], u);
    store(&out.weights[2], v);
    store(out.offset, {u * second.x + v * third.x, u * second.y + v * third.y, u * second.z + v * third.z});

    const Vector3<Number> a = load(triangles.normals[0]);
    const Vector3<Number> b = load(triangles.normals[1]);
    const Vector3<Number> c = load(triangles.normals[2]);
    const Vector3<Number> sum{w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y,
                              w * a.z + u * b.z + v * c.z};
    const Vector3<Number> back{-direction.x, -direction.y, -direction.z};
    store(out.normal, normalized_or(sum, 1e-12F, normalized_or(back, 0.0F, back)));
}

}  // namespace

void find_surface(const Viewpoint& view, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> normals, std::span<const Corners> triangles,
                  std::span<const glm::vec2> at, LaneSurface& out) {
    const CameraAxes camera = view.axes();
    Rays rays{.backward = in_floats(camera.backward),
              .up = in_floats(camera.up),
              .right = in_floats(camera.right),
              .perspective = static_cast<float>(camera.perspective),
              .x = {},
              .y = {}};
    Triangles gathered;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t own = i < triangles.size() ? i : 0;
        const Corners& corners = triangles[own];
        const glm::dvec3 first(positions[corners.x]);
        put(gathered.first, i, glm::vec3(first - view.eye));
        put(gathered.second, i, glm::vec3(glm::dvec3(positions[corners.y]) - first));
        put(gathered.third, i, glm::vec3(glm::dvec3(positions[corners.z]) - first));
        for (glm::length_t k = 0; k < 3; ++k)
            put(gathered.normals[static_cast<std::size_t>(k)], i, normals[corners[k]]);
        rays.x[i] = at[own].x;
        rays.y[i] = at[own].y;
    }
    Points points;
    dispatch<meet>(rays, gathered, points);
    out.weights = points.weights;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Corners& corners = triangles[i < triangles.size() ? i : 0];
        out.positions[i] = positions[corners.x] + vector_at(points.offset, i);
        out.normals[i] = vector_at(points.normal, i);
    }
}

}  // namespace nicol
