// SPDX-License-Identifier: MIT
#include "shading/lane_surface.hpp"

#include <algorithm>

#include "polarization/lane_points.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// A ray from the eye, or beside it where all rays are parallel.
struct Rays {
    Vector3<float> backward, up, right;
    float perspective;  // 1, or 0 for an orthographic camera
    Lanes x, y;
};

struct Triangles {
    LaneVectors first;          // corner, from the eye
    LaneVectors second, third;  // edges to the others
    std::array<LaneVectors, 3> normals;
};

struct Points {
    std::array<Lanes, 3> weights;
    LaneVectors offset;  // from the first corner
    LaneVectors normal;
};

void put(LaneVectors& lanes, std::size_t i, const glm::vec3& v) {
    lanes.x[i] = v.x;
    lanes.y[i] = v.y;
    lanes.z[i] = v.z;
}

[[gnu::always_inline]] inline Vector3<float> lane(const LaneVectors& lanes, std::size_t i) {
    return {lanes.x.value[i], lanes.y.value[i], lanes.z.value[i]};
}

// 0 for what is not a number.
[[gnu::always_inline]] inline float between_zero_and(float most, float x) {
    x = x > 0 ? x : 0;
    return x < most ? x : most;
}

// Where ray and plane meet, by Cramer's rule.
[[gnu::always_inline]] inline void meet(const Rays& rays, const Triangles& triangles, Points& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = rays.x.value[i];
        const float y = rays.y.value[i];
        const Vector3<float> aside{x * rays.right.x + y * rays.up.x, x * rays.right.y + y * rays.up.y,
                                   x * rays.right.z + y * rays.up.z};
        const float near = rays.perspective;
        const Vector3<float> direction{near * aside.x - rays.backward.x, near * aside.y - rays.backward.y,
                                       near * aside.z - rays.backward.z};
        const Vector3<float> first = lane(triangles.first, i);
        const Vector3<float> begin{(1 - near) * aside.x - first.x, (1 - near) * aside.y - first.y,
                                   (1 - near) * aside.z - first.z};
        const Vector3<float> second = lane(triangles.second, i);
        const Vector3<float> third = lane(triangles.third, i);

        const Vector3<float> across = cross(direction, third);
        float determinant = 0;
        dot(second, across, determinant);
        const float inverse = 1 / (determinant == 0 ? 1.0F : determinant);
        float u = 0;
        dot(begin, across, u);
        u = between_zero_and(1, u * inverse);
        float v = 0;
        dot(direction, cross(begin, second), v);
        v = between_zero_and(1 - u, v * inverse);
        const float w = 1 - u - v;
        out.weights[0].value[i] = w;
        out.weights[1].value[i] = u;
        out.weights[2].value[i] = v;
        out.offset.x.value[i] = u * second.x + v * third.x;
        out.offset.y.value[i] = u * second.y + v * third.y;
        out.offset.z.value[i] = u * second.z + v * third.z;

        const Vector3<float> a = lane(triangles.normals[0], i);
        const Vector3<float> b = lane(triangles.normals[1], i);
        const Vector3<float> c = lane(triangles.normals[2], i);
        const Vector3<float> sum{w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y,
                                 w * a.z + u * b.z + v * c.z};
        const Vector3<float> back{-direction.x, -direction.y, -direction.z};
        const Vector3<float> unit = normalized_or(sum, 1e-12F, normalized_or(back, 0.0F, back));
        out.normal.x.value[i] = unit.x;
        out.normal.y.value[i] = unit.y;
        out.normal.z.value[i] = unit.z;
    }
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
        out.positions[i] =
            positions[corners.x] + glm::vec3(points.offset.x[i], points.offset.y[i], points.offset.z[i]);
        out.normals[i] = {points.normal.x[i], points.normal.y[i], points.normal.z[i]};
    }
}

}  // namespace nicol
