// SPDX-License-Identifier: MIT
#include "shading/tangent_rotation.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "test.hpp"

using namespace nicol;

namespace {

// Returns a texture of one direction.
TexturePtr towards(float x, float y) {
    return constant_texture({0.5F + 0.5F * x, 0.5F + 0.5F * y, 1, 1}, 3);
}

constexpr double kThird = std::numbers::pi / 3;
const float kSine = std::sqrt(0.75F);

}  // namespace

TEST_CASE("axes are rotated from growing u towards falling v") {
    const TextureAxes upright{.by_u = {2, 0, 0}, .by_v = {0, -3, 0}};
    const TextureAxes mirrored{.by_u = {-2, 0, 0}, .by_v = {0, -3, 0}};
    const TextureAxes leaning{.by_u = {1, 0, 5}, .by_v = {0, -1, 2}};
    const struct {
        TextureAxes axes;
        TexturePtr directions;
        double angle;
        glm::vec3 expected;
    } rows[] = {{upright, nullptr, 0, {1, 0, 0}},
                {upright, nullptr, kThird, {0.5F, kSine, 0}},
                {mirrored, nullptr, kThird, {-0.5F, kSine, 0}},
                {leaning, nullptr, kThird, {0.5F, kSine, 0}},
                {upright, towards(0, -1), 0, {0, -1, 0}},
                {upright, towards(0, 0.25F), 0, {0, 1, 0}},
                {upright, towards(0, 1), kThird, {-kSine, 0.5F, 0}},
                {mirrored, towards(0, 1), kThird, {kSine, 0.5F, 0}},
                // A texture without a direction counts as growing u.
                {upright, towards(0, 0), kThird, {0.5F, kSine, 0}},
                {{}, towards(0, 1), kThird, {0, 0, 0}}};
    for (const auto& row : rows) {
        CAPTURES(row.expected.x, row.expected.y, row.angle);
        const glm::vec3 x = rotated_tangent({row.directions, row.angle}, {}, row.axes, {0, 0, 1});
        CHECK(glm::distance(x, row.expected) < 1e-6F);
    }
}

TEST_CASE("tangents of a mesh replace the directions of growing u and falling v") {
    const TextureAxes of_texture{.by_u = {2, 0, 0}, .by_v = {0, -3, 0}};
    const glm::vec3 weights(0.5F, 0.25F, 0.25F), normal(0, 0, 1);
    const TextureAxes kept = tangent_axes({}, weights, normal, of_texture);
    CHECK(kept.by_u == of_texture.by_u);
    CHECK(kept.by_v == of_texture.by_v);
    for (const float side : {1.0F, -1.0F}) {
        const glm::vec4 forth(0, 1, 0, side), left(-1, 0, 0, side);
        const TextureAxes axes = tangent_axes({forth, left, left}, weights, normal, of_texture);
        CHECK(glm::distance(axes.by_u, glm::vec3(-0.5F, 0.5F, 0)) < 1e-6F);
        // v falls along the y axis, side cross(normal, x).
        CHECK(glm::distance(glm::normalize(axes.by_v),
                            -side * glm::cross(normal, glm::normalize(axes.by_u))) < 1e-6F);
    }
}
