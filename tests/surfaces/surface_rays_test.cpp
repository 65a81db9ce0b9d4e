// SPDX-License-Identifier: MIT
#include "surfaces/surface_rays.hpp"

#include <set>

#include "directions.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::coarse_sphere;

namespace {

/// A two-sided ball, 40 others, and a wall.
struct Balls {
    Scene scene;
    std::uint32_t wall;

    Balls() {
        scene.add({.mesh = coarse_sphere(8), .material = twosided(diffuse({0.5}))});
        for (int i = 0; i < 40; ++i)
            scene.add({.mesh = coarse_sphere(7),
                       .material = diffuse({0.4}),
                       .to_world = at(3.0 * (i % 8) - 9, 3, 3.0 * i / 8 - 7)});
        wall = scene.add({.mesh = std::make_shared<const Mesh>(make_rectangle(1)),
                          .material = diffuse({0.4}),
                          .to_world = at(0, 0, -2)});
    }
};

/// Hierarchy of surfaces that follow a scene.
struct Traced {
    SceneGeometry surfaces;
    SurfaceRays rays{surfaces};

    std::shared_ptr<const RayScene> follow(const Scene& scene) {
        surfaces.update(scene);
        return rays.get();
    }
};

// Compares hits with those of surfaces that have not known another scene. Returns the numbers of the hit
// ranges of vertices.
std::set<std::size_t> compare(const Traced& changed, const RayScene& rays, const Scene& scene) {
    Traced fresh;
    const auto truth = fresh.follow(scene);
    REQUIRE(fresh.surfaces.geometry().positions == changed.surfaces.geometry().positions);
    std::set<std::size_t> ranges;
    std::mt19937 random(5);
    for (int i = 0; i < 4000; ++i) {
        const Ray ray{.origin = 2.0 * random_direction(random), .direction = random_direction(random)};
        const auto hit = rays.intersect(ray), expected = truth->intersect(ray);
        REQUIRE(hit.has_value() == expected.has_value());
        if (!hit) continue;
        CHECK(hit->triangle == expected->triangle);
        CHECK(hit->distance == expected->distance);
        CHECK(hit->b1 == expected->b1);
        const WorldGeometry& geometry = fresh.surfaces.geometry();
        const glm::uvec3& corners = geometry.triangles.at(hit->triangle);
        const glm::dvec3 point = (1 - hit->b1 - hit->b2) * glm::dvec3(geometry.positions[corners.x]) +
                                 hit->b1 * glm::dvec3(geometry.positions[corners.y]) +
                                 hit->b2 * glm::dvec3(geometry.positions[corners.z]);
        CHECK(glm::distance(point, ray.origin + hit->distance * ray.direction) < 1e-4);
        ranges.insert(range_of(geometry, corners.x));
    }
    return ranges;
}

}  // namespace

TEST_CASE("rays meet moved, added and removed instances as in a scene that was always so") {
    Balls balls;
    Traced traced;
    auto rays = traced.follow(balls.scene);
    CHECK(compare(traced, *rays, balls.scene).size() > 10);
    for (int step = 1; step <= 3; ++step) {
        balls.scene.set_transform(12, at(0.2 * step, 1.2, 0));
        rays = traced.follow(balls.scene);
        CHECK(compare(traced, *rays, balls.scene).size() > 10);
    }
    balls.scene.set_transform(20, at(0, -1.5, 0));
    balls.scene.remove(3);
    balls.scene.remove(13);
    balls.scene.add({.mesh = coarse_sphere(3), .material = diffuse({0.4}), .to_world = at(1.6, 0, 0)});
    rays = traced.follow(balls.scene);
    CHECK(compare(traced, *rays, balls.scene).size() > 10);
}

TEST_CASE("rays that meet a two-sided surface meet the side that they come from") {
    Balls balls;
    Traced traced;
    auto rays = traced.follow(balls.scene);
    for (const bool moved : {false, true}) {
        if (moved) {
            balls.scene.set_transform(12, at(0, 5, 0));
            rays = traced.follow(balls.scene);
        }
        const WorldGeometry& geometry = traced.surfaces.geometry();
        const auto range = [&](const Ray& ray) {
            return range_of(geometry, geometry.triangles.at(rays->intersect(ray).value().triangle).x);
        };
        CHECK_FALSE(is_back(geometry, geometry.ranges[range({{0.1, 0.2, 2}, {0, 0, -1}})]));
        CHECK(is_back(geometry, geometry.ranges[range({{0.1, 0.2, 0}, {0, 0, 1}})]));
        CHECK(geometry.ranges[range({{0.1, 0.2, 0}, {0, 0, 1}})].instance == 0);
    }
}

TEST_CASE("a hierarchy in use is not made again") {
    Balls balls;
    Traced traced;
    const auto rays = traced.follow(balls.scene);
    traced.rays.release();
    CHECK(traced.rays.get() == rays);
}
