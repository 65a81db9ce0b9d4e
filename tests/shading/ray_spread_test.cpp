// SPDX-License-Identifier: MIT
#include "shading/ray_spread.hpp"

#include <glm/geometric.hpp>

#include "geometry/ray_scene.hpp"
#include "shading/boundary_split.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// Returns the place where a ray meets the unit sphere around the origin.
glm::dvec3 place_on_sphere(const Ray& ray) {
    const double half = glm::dot(ray.origin, ray.direction);
    return ray.origin +
           (-half - std::sqrt(half * half - glm::dot(ray.origin, ray.origin) + 1)) * ray.direction;
}

// Returns what a sphere of glass makes of a ray.
Ray beyond(const Ray& ray, const SmoothBoundary& glass, bool reflected) {
    const glm::dvec3 place = place_on_sphere(ray);
    const BoundarySplit split = split_at(glass, place, place, theta_phi_frame(-ray.direction));
    return {.origin = place, .direction = (reflected ? split.reflected : split.transmitted).towards_light};
}

}  // namespace

TEST_CASE("the spread of a ray is that of rays beside it, reflected and refracted by a sphere") {
    const Ray ray{.origin = {0.3, 0.2, 3}, .direction = glm::normalize(glm::dvec3(0.05, -0.1, -1))};
    const glm::dvec3 beside[] = {glm::normalize(glm::cross(ray.direction, glm::dvec3(0, 1, 0))),
                                 glm::normalize(glm::cross(ray.direction, glm::dvec3(1, 0, 0)))};
    const SmoothBoundary glass{.eta = 1.5};
    constexpr double h = 1e-5;
    for (const bool reflected : {false, true})
        for (const bool parallel : {false, true}) {
            CAPTURES(reflected, parallel);
            RaySpread spread;
            (parallel ? spread.places : spread.directions) = {beside[0], beside[1]};
            const glm::dvec3 place = place_on_sphere(ray);
            spread.meet(ray.direction, glm::distance(ray.origin, place), place);
            const std::array bends = spread.places;  // the normal is the place
            if (reflected)
                spread.reflect(ray.direction, place, bends);
            else
                spread.refract(ray.direction, place, bends, glass.eta);
            for (std::size_t i = 0; i < 2; ++i) {
                const auto moved = [&](double way) {
                    Ray out = ray;
                    if (parallel)
                        out.origin += way * beside[i];
                    else
                        out.direction = glm::normalize(out.direction + way * beside[i]);
                    return beyond(out, glass, reflected);
                };
                const Ray a = moved(-h), b = moved(h);
                CHECK(glm::distance((b.origin - a.origin) / (2 * h), spread.places[i]) < 1e-6);
                CHECK(glm::distance((b.direction - a.direction) / (2 * h), spread.directions[i]) < 1e-6);
            }
        }
}
