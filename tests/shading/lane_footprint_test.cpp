// SPDX-License-Identifier: MIT
#include "shading/lane_footprint.hpp"

#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;

namespace {

struct Plane {
    glm::dvec3 origin, by_u, by_v;

    /// Returns the texture coordinates of the point where a ray hits the plane.
    [[nodiscard]] glm::dvec2 meet(const glm::dvec3& from, const glm::dvec3& ray) const {
        const glm::dvec3 normal = glm::cross(by_u, by_v);
        const glm::dvec3 at = from + glm::dot(origin - from, normal) / glm::dot(ray, normal) * ray - origin;
        const double area = glm::dot(normal, normal);
        return {glm::dot(glm::cross(at, by_v), normal) / area, glm::dot(glm::cross(by_u, at), normal) / area};
    }
};

}  // namespace

TEST_CASE("a footprint leads to where the rays of neighbouring pixels meet the triangle's plane") {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    for (const bool orthographic : {false, true}) {
        const glm::dvec3 forward = glm::normalize(vector()), right = glm::normalize(cross(forward, vector()));
        // Footprints are of first order, so the steps are small and the expected values in double precision.
        const double step = 1e-5;
        const glm::dvec3 moves[2] = {step * right, 2 * step * glm::cross(forward, right)};
        LaneTextureAxes axes;
        LaneVectors towards_viewer;
        TexturePoints points{};
        std::array<glm::dvec2, kLanes> expected[2];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 eye = vector();
            const glm::dvec3 ray =
                orthographic ? forward : 3.0 * forward + 0.5 * vector();  // in front of the camera
            const Plane plane{.origin = eye + ray, .by_u = vector(), .by_v = 4.0 * vector()};
            put(axes.by_u, i, plane.by_u);
            put(axes.by_v, i, plane.by_v);
            put(towards_viewer, i, -ray);
            const double distance = glm::dot(ray, forward);
            for (std::size_t m = 0; m < 2; ++m)
                expected[m][i] = orthographic ? plane.meet(eye + moves[m], ray)
                                              : plane.meet(eye, ray + distance * moves[m]);
        }
        find_footprints(
            {.forward = forward, .right = moves[0], .down = moves[1], .orthographic = orthographic}, axes,
            towards_viewer, points);
        for (std::size_t i = 0; i < kLanes; ++i)
            for (std::size_t m = 0; m < 2; ++m) {
                CAPTURES(orthographic, i, m);
                const std::array<Lanes, 2>& found = m == 0 ? points.du : points.dv;
                const glm::dvec2 change(found[0][i], found[1][i]);
                CHECK(glm::distance(change, expected[m][i]) < 1e-3 * glm::length(expected[m][i]));
            }
    }
}

TEST_CASE("a footprint is finite edge on, and 0 without axes") {
    const PixelSteps steps{
        .forward = {0, 0, -1}, .right = {0.01F, 0, 0}, .down = {0, -0.01F, 0}, .orthographic = false};
    LaneTextureAxes axes{};
    LaneVectors towards_viewer;
    for (std::size_t i = 0; i < kLanes; ++i) put(towards_viewer, i, {0, 0, 2});
    put(axes.by_u, 1, {0, 0, 1});
    put(axes.by_v, 1, {0, 1, 0});
    TexturePoints points;
    find_footprints(steps, axes, towards_viewer, points);
    for (const std::array<Lanes, 2>* const change : {&points.du, &points.dv})
        for (const Lanes& t : *change) {
            CHECK(t[0] == 0);
            CHECK(std::isfinite(t[1]));
        }
    // A step to the right leaves the plane by 0.02 at distance 2. The rays descend by 1e-4 per unit length.
    CHECK(std::abs(points.du[0][1]) == doctest::Approx(200));
}
