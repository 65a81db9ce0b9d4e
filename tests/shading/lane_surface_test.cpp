// SPDX-License-Identifier: MIT
// Tests of points on triangles behind pixels.
#include "shading/lane_surface.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

struct Triangle {
    std::vector<glm::vec3> positions, normals;
};

LaneSurface surface_of(const Viewpoint& view, const Triangle& triangle, const std::vector<glm::vec2>& at) {
    LaneSurface out;
    find_surface(view, triangle.positions, triangle.normals, std::vector<Corners>(at.size(), {0, 1, 2}), at,
                 out);
    return out;
}

}  // namespace

TEST_CASE("a point of a triangle is found from where the camera sees it") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(0, 1);
    const auto direction = [&] {
        std::normal_distribution<float> normal;
        return glm::normalize(glm::vec3{normal(random), normal(random), normal(random)});
    };
    for (const bool orthographic : {false, true})
        for (const float size : {1e-4F, 1.0F, 1e4F}) {
            const Viewpoint view{.orthographic = orthographic, .eye = {3, -2, 1}};
            const glm::vec3 centre = glm::vec3(view.eye) + 3 * size * glm::vec3(0.1, 0.2, 1);
            const Triangle triangle{
                {centre + size * direction(), centre + size * direction(), centre + size * direction()},
                {direction(), direction(), direction()}};
            std::vector<glm::vec3> weights;
            std::vector<glm::vec2> at;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const float u = number(random);
                const float v = (1 - u) * number(random);
                weights.emplace_back(1 - u - v, u, v);
                const glm::dvec3 point(weights[i].x * triangle.positions[0] +
                                       weights[i].y * triangle.positions[1] +
                                       weights[i].z * triangle.positions[2]);
                const glm::dvec3 seen = point - view.eye;
                const double depth = orthographic ? 1 : glm::dot(seen, view.forward);
                at.emplace_back(glm::dot(seen, view.right) / depth, glm::dot(seen, view.up) / depth);
            }
            const LaneSurface found = surface_of(view, triangle, at);
            CAPTURES(orthographic, size);
            for (std::size_t i = 0; i < kLanes; ++i) {
                glm::vec3 normal(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const float expected = weights[i][static_cast<glm::length_t>(k)];
                    CHECK(found.weights[k][i] == doctest::Approx(expected).epsilon(1e-2).scale(1));
                    normal += expected * triangle.normals[k];
                }
                CHECK(glm::distance(found.normals[i], glm::normalize(normal)) < 2e-2F);
            }
        }
}

TEST_CASE("triangles without extent, points beside them and normals that cancel yield numbers") {
    const Viewpoint view;
    const glm::vec3 up(0, 0, 1);
    for (const Triangle& triangle :
         {Triangle{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {up, up, up}},
          {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {up, up, up}},  // the camera lies in its plane
          {{{-1, 0, 1}, {1, 0, 1}, {0, 0, 3}}, {up, -up, {0, 0, 0}}},
          {{{1e30F, 0, 1}, {1, 1e30F, 1}, {0, 0, 1e30F}}, {up, up, up}},
          {{{1e-30F, 0, 1}, {0, 1e-30F, 1}, {0, 0, 1}}, {up, up, up}}}) {
        const LaneSurface found = surface_of(view, triangle, {{0, 0}, {0.3, 0.2}, {-5, 7}});
        for (std::size_t i = 0; i < kLanes; ++i) {
            float sum = 0;
            for (const Lanes& weight : found.weights) {
                CHECK(weight[i] >= 0);
                CHECK(weight[i] <= 1);
                sum += weight[i];
            }
            CHECK(sum == doctest::Approx(1));
            CHECK(glm::length(found.normals[i]) == doctest::Approx(1));
        }
    }
}
