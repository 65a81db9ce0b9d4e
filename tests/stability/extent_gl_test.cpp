// SPDX-License-Identifier: MIT
// Tests that the size of a scene changes nothing.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/renderer.hpp"
#include "render/scenes.hpp"
#include "stability/lights.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr int size = 64;

StokesImage rendered(const std::shared_ptr<gl::Context>& context, const Scene& scene, const Camera& camera,
                     Executor executor, int order_low = 4) {
    Framebuffer target(context, size, size, 3);
    Renderer renderer(context);
    renderer.render(scene, camera, {.executor = executor, .bake_directions = 512, .order_low = order_low},
                    target);
    return target.image();
}

EnvironmentPtr light() {
    return psh_environment(test::random_light(9, 3, 4, 1));
}

// Renders a sphere over a plate with shadows, low and high orders, with all lengths times `unit`.
StokesImage image(const std::shared_ptr<gl::Context>& context, double unit, Executor executor) {
    const glm::dmat4 grow = glm::scale(glm::dmat4(1), glm::dvec3(unit));
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(12),
               .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}, .alpha = 0.2}),
               .to_world = grow * test::at(0.2, 1, 0.1)});
    scene.add({.mesh = test::rectangle(24),
               .material = test::some_metal(0.3),
               .to_world = grow * test::plate_at(0, 3)});
    scene.set_environment(light(), glm::dmat3(1), 1);
    Camera camera = test::camera_at(unit * glm::dvec3(2, 4, 6), unit * glm::dvec3(0, 0.5, 0));
    camera.near_clip *= unit;
    camera.far_clip *= unit;
    return rendered(context, scene, camera, executor);
}

}  // namespace

TEST_CASE("a scene of a millionth or a million of its size looks the same") {
    const auto context = gl::make_context(gl::Backend::automatic);
    const StokesImage truth = image(context, 1, Executor::cpu);
    const double most = largest(truth);
    REQUIRE(most > 0);
    for_all({Executor::cpu, Executor::compute}, {1e-7, 1e-6, 1e6, 1e7}, [&](Executor executor, double unit) {
        CAPTURES(unit, executor);
        const StokesImage found = image(context, unit, executor);
        CHECK(largest(found) <= 2 * most);  // also implies finite values
        std::size_t apart = 0;
        for (std::size_t i = 0; i < truth.data.size(); ++i)
            apart += std::abs(found.data[i] - truth.data[i]) > 1e-4 * most ? 1 : 0;
        // Rays and edges that just miss may fall to either side.
        CHECK(static_cast<double>(apart) < 0.002 * static_cast<double>(truth.data.size()));
    });
}

TEST_CASE("normals that point straight away from the camera make no holes in the image") {
    const auto context = gl::make_context(gl::Backend::automatic);
    Mesh plate = make_rectangle(8);
    for (glm::vec3& normal : plate.normals) normal = -normal;
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(std::move(plate)), .material = pplastic({.alpha = 0.2})});
    scene.add(
        {.mesh = test::coarse_sphere(4), .material = diffuse({0.5}), .to_world = test::at(0.3, 0.2, -1.5)});
    scene.set_environment(light(), glm::dmat3(1), 1);
    Camera camera;
    camera.orthographic = true;
    camera.to_world = look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0});
    // In this view s0 of order 0 does not depend on the azimuth, which rounding decides.
    const StokesImage threads = rendered(context, scene, camera, Executor::cpu, 0);
    const StokesImage shaders = rendered(context, scene, camera, Executor::compute, 0);
    CHECK(std::isfinite(largest(threads)));
    CHECK(std::isfinite(largest(shaders)));
    float most = 0;
    float apart = 0;
    for (std::size_t i = 0; i < threads.data.size(); i += 4) {
        most = std::max(most, std::abs(threads.data[i]));
        apart = std::max(apart, std::abs(threads.data[i] - shaders.data[i]));
    }
    CHECK(most > 0);
    CHECK(apart < 1e-3F * most);
}
