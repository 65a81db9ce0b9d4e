// SPDX-License-Identifier: MIT
// Tests of shadows of known depth: view factors of squares and walls.
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

/// Returns the view factor from a small plane element to a parallel a x b rectangle at height 1 with a corner
/// above it.
double corner_factor(double a, double b) {
    const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * pi);
}

const glm::dvec3 aside = glm::normalize(glm::dvec3(1, 0.2, 0.3));

/// Returns a white floor and a square of half width `half` above it, under uniform light.
Scene square_above_floor(double height, double half) {
    Scene scene;
    scene.add(square(diffuse({0.8}), Frame(1.0), {0, 0, 0}, 50));
    scene.add(square(diffuse({0.8}), Frame(1.0), {0, 0, height}, half));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    return scene;
}

}  // namespace

TEST_CASE("a square above a plane takes its view factor away") {
    const Scene scene = square_above_floor(1, 0.5);
    for (const Strategy strategy : {Strategy::both, Strategy::light, Strategy::surface}) {
        const double below = point(scene, camera_on({0, 0, 0}, aside), 1 << 15, strategy)[0][0];
        CHECK(below == doctest::Approx(0.8 * (1 - 4 * corner_factor(0.5, 0.5))).epsilon(2e-3));
        const double corner = point(scene, camera_on({0.5, 0.5, 0}, aside), 1 << 15, strategy)[0][0];
        CHECK(corner == doctest::Approx(0.8 * (1 - corner_factor(1, 1))).epsilon(2e-3));
        const double far = point(scene, camera_on({40, 0, 0}, aside), 1 << 15, strategy)[0][0];
        CHECK(far == doctest::Approx(0.8).epsilon(2e-3));
    }
}

TEST_CASE("a square in contact with the plane leaves no light between") {
    const Scene scene = square_above_floor(0.01, 1);
    // The camera is between floor and square.
    Camera camera;
    camera.to_world = look_at({0.02, 0, 0.005}, {0, 0, 0}, {0, 0, 1});
    camera.fov = 0.01;
    camera.near_clip = 1e-4;
    const StokesImage image = render(scene, camera, 1, 1, {.samples = 4096});
    CHECK(image.stokes(0, 0, 0)[0] < 1e-3);
}

TEST_CASE("without shadows nothing occludes, and no shadow rays are traced") {
    const Scene scene = square_above_floor(1, 0.5);
    ReferenceStatistics statistics;
    const Projection projection = project(camera_on({0, 0, 0}, aside), 1, 1);
    const StokesImage image =
        render_reference(scene, projection, 1, 1, {.samples = 1 << 14, .shadows = false}, statistics);
    CHECK(image.data[0] == doctest::Approx(0.8).epsilon(2e-3));
    CHECK(statistics.shadow_rays == 0);
}

TEST_CASE("rays pass a small surface far away that casts no shadow") {
    Scene scene;
    scene.add(square(diffuse({0.8}), Frame(1.0), {0, 0, -8}, 50));
    const std::uint32_t small = scene.add(square(diffuse({0.8}), Frame(1.0), {0, 0, 0}, 0.15));
    scene.set_roles(small, {.casts_shadows = false});
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    const double open = point(scene, camera_on({0, 0, -8}, aside), 1 << 15, Strategy::surface)[0][0];
    CHECK(open == doctest::Approx(0.8).epsilon(2e-3));
}
