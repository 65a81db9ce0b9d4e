// SPDX-License-Identifier: MIT
// High orders and shadows through the whole renderer.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/conductor.hpp"
#include "polarization/stokes.hpp"
#include "render/renderer.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::falling_light;

namespace {

constexpr int width = 48;
constexpr int height = 36;

/// A sphere that stands on a plate, far from the axes.
Scene sphere_on_plate(const EnvironmentPtr& light, const glm::dmat3& turn = glm::dmat3(1)) {
    Scene scene;
    const glm::dmat4 all(turn);
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
               .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}, .alpha = 0.2}),
               .to_world = all * glm::translate(glm::dmat4(1), {0.2, 1, 0.1})});
    scene.add({.mesh = std::make_shared<const Mesh>(make_rectangle(24)),
               .material = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.3}),
               .to_world = all * glm::rotate(glm::dmat4(1), glm::radians(-90.0), glm::dvec3(1, 0, 0)) *
                           glm::scale(glm::dmat4(1), glm::dvec3(3))});
    scene.set_environment(light, turn, 0.7);
    return scene;
}

Camera camera_of(const glm::dmat3& turn = glm::dmat3(1)) {
    Camera camera;
    camera.to_world =
        look_at(turn * glm::dvec3(2, 4, 6), turn * glm::dvec3(0, 0.5, 0), turn * glm::dvec3(0, 1, 0));
    return camera;
}

StokesImage render(const std::shared_ptr<gl::Context>& context, const Scene& scene,
                   const RenderOptions& options, const Camera& camera = camera_of(),
                   Statistics* statistics = nullptr) {
    Framebuffer target(context, width, height, 3);
    Renderer renderer(context, 0);
    renderer.render(scene, camera, options, target);
    if (statistics != nullptr) *statistics = target.statistics();
    return target.image();
}

RenderOptions with(int low, int high, HighOrders form, bool shadows = false,
                   Method method = Method::factored) {
    return {.method = method,
            .shadows = shadows,
            .bake_directions = 512,
            .order_low = low,
            .order_high = high,
            .high_orders = form,
            .progress = {}};
}

}  // namespace

TEST_CASE("split takes the image most of the way to all orders, convolution some") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        for (const bool polarized : {false, true}) {
            Scene scene;
            scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
                       .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}, .alpha = 0.2})});
            scene.set_environment(falling_light(16, polarized), glm::dmat3(1), 0.7);
            const StokesImage all = render(context, scene, with(16, 16, HighOrders::none));
            const double none =
                test::rms_difference(render(context, scene, with(4, 16, HighOrders::none)), all);
            const double split =
                test::rms_difference(render(context, scene, with(4, 16, HighOrders::split)), all);
            const double convolved =
                test::rms_difference(render(context, scene, with(4, 16, HighOrders::convolution)), all);
            CAPTURE(polarized);
            CAPTURE(none);
            CAPTURE(convolved);
            CHECK(none > 1e-3);
            CHECK(split < 0.25 * none);
            CHECK(convolved < none);
            CHECK(split < 0.25 * convolved);
        }
    });
}

TEST_CASE("both methods get the same high orders") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        const Scene scene = sphere_on_plate(falling_light(9, true));
        for (const HighOrders form : {HighOrders::split, HighOrders::convolution}) {
            StokesImage high[2];
            for (const Method method : {Method::factored, Method::dense}) {
                StokesImage& part = high[method == Method::dense ? 1 : 0];
                part = render(context, scene, with(3, 9, form, true, method));
                const StokesImage low = render(context, scene, with(3, 9, HighOrders::none, true, method));
                CHECK(test::rms_difference(part, low) > 1e-3);
                for (std::size_t i = 0; i < part.data.size(); ++i) part.data[i] -= low.data[i];
            }
            CHECK(test::rms_difference(high[0], high[1]) < 1e-6);
        }
    });
}

namespace {

/// With a second ball to the side: a scene with axes of its own.
Scene two_balls_on_plate(const EnvironmentPtr& light, const glm::dmat3& turn = glm::dmat3(1)) {
    Scene scene = sphere_on_plate(light, turn);
    scene.add({.mesh = test::coarse_sphere(8),
               .material = pplastic({.alpha = 0.3}),
               .to_world = glm::scale(glm::translate(glm::dmat4(turn), {1.9, 0.4, 0.9}), glm::dvec3(0.6))});
    return scene;
}

}  // namespace

TEST_CASE("turning the light equals turning everything else back, with shadows and high orders") {
    const glm::dmat3 turn = theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7)));
    const auto context = gl::make_context(gl::Backend::osmesa);
    const EnvironmentPtr light = falling_light(9, true);
    for (const Method method : {Method::factored, Method::dense}) {
        // The bake's directions turn with the scene, so it finds the same shadows.
        RenderOptions options = with(3, 9, HighOrders::split, true, method);
        const StokesImage here = render(context, two_balls_on_plate(light), options);
        const StokesImage there = render(context, two_balls_on_plate(light, turn), options, camera_of(turn));
        CHECK(test::rms_difference(here, there) < 2e-5);
        options.shadows = false;
        CHECK(test::rms_difference(
                  render(context, two_balls_on_plate(light), options),
                  render(context, two_balls_on_plate(light, turn), options, camera_of(turn))) < 1e-5);
    }
}

TEST_CASE("light without high orders costs none") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    const Scene scene = sphere_on_plate(falling_light(3, false));
    Statistics low;
    Statistics high;
    const StokesImage plain = render(context, scene, with(3, 3, HighOrders::none), camera_of(), &low);
    const StokesImage same = render(context, scene, with(3, 64, HighOrders::split), camera_of(), &high);
    CHECK(plain.data == same.data);
    CHECK(high.order == 3);
    CHECK(high.response_bytes == low.response_bytes);
}

TEST_CASE("shadows leave a lone sphere alone") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        Statistics statistics;
        Scene lone;
        lone.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = pplastic({})});
        lone.set_environment(falling_light(4, true), glm::dmat3(1), 1);
        const StokesImage with_shadows =
            render(context, lone, with(4, 4, HighOrders::none, true), camera_of(), &statistics);
        CHECK(statistics.vertices_unoccluded == statistics.vertices);
        CHECK(with_shadows.data == render(context, lone, with(4, 4, HighOrders::none)).data);
    });
}

TEST_CASE("ringing can be windowed away, and what is left of it moved into the physical range") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    EquirectImage image(64, 33, 3);  // a lamp in the dark
    for (int c = 0; c < 3; ++c) image.at(c, 8, 20)[0] = 500;
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = pplastic({.alpha = 0.1})});
    scene.set_environment(image_environment(image), glm::dmat3(1), 1);
    const auto lowest = [](const StokesImage& image) {
        float low = 0;
        for (std::size_t i = 0; i < image.data.size(); i += 4) low = std::min(low, image.data[i]);
        return low;
    };
    RenderOptions options = with(4, 4, HighOrders::none);
    Statistics statistics;
    const StokesImage plain = render(context, scene, options, camera_of(), &statistics);
    CHECK(lowest(plain) < -0.01F);
    CHECK(statistics.vertices_unphysical == 0);

    options.physical = true;
    const StokesImage physical = render(context, scene, options, camera_of(), &statistics);
    CHECK(lowest(physical) == 0);
    CHECK(statistics.vertices_unphysical > 0);
    for (std::size_t i = 0; i < physical.data.size(); i += 4) {
        const float polarized = std::hypot(physical.data[i + 1], physical.data[i + 2], physical.data[i + 3]);
        CHECK_MESSAGE(polarized <= physical.data[i] * 1.001F + 1e-6F, i);
    }

    options.physical = false;
    options.dering = 0.02;
    CHECK(lowest(render(context, scene, options)) > 0.05F * lowest(plain));
    options.dering = -1;
    CHECK_THROWS_AS(render(context, scene, options), Error);
}
