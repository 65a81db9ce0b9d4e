// SPDX-License-Identifier: MIT
// Tests of high orders and shadows through the whole renderer.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::falling_light;

namespace {

/// Returns a sphere standing on a plate and a ball beside it, away from the axes and rotated.
Scene balls_on_plate(const EnvironmentPtr& light, const glm::dmat3& rotation = glm::dmat3(1)) {
    Scene scene;
    const glm::dmat4 all(rotation);
    scene.add({.mesh = test::coarse_sphere(12),
               .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}, .alpha = 0.2}),
               .to_world = all * at(0.2, 1, 0.1)});
    scene.add({.mesh = test::rectangle(12),
               .material = test::some_metal(0.3),
               .to_world = all * test::plate_at(0, 3)});
    scene.add({.mesh = test::coarse_sphere(8),
               .material = pplastic({.alpha = 0.3}),
               .to_world = all * at(1.9, 0.4, 0.9, 0.6)});
    scene.set_environment(light, rotation, 0.7);
    return scene;
}

Scene lone_sphere(const EnvironmentPtr& light, const MaterialPtr& material) {
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = material});
    scene.set_environment(light, glm::dmat3(1), 0.7);
    return scene;
}

Camera camera_of(const glm::dmat3& rotation = glm::dmat3(1)) {
    Camera camera;
    camera.to_world = look_at(rotation * glm::dvec3(2, 4, 6), rotation * glm::dvec3(0, 0.5, 0),
                              rotation * glm::dvec3(0, 1, 0));
    return camera;
}

/// Renders with a new renderer.
StokesImage render(const std::shared_ptr<gl::Context>& context, const Scene& scene,
                   const RenderOptions& options, const Camera& camera = camera_of(),
                   Statistics* statistics = nullptr) {
    test::Studio studio(context, 48, 36);
    const StokesImage image = studio(scene, options, camera);
    if (statistics != nullptr) *statistics = studio.statistics;
    return image;
}

RenderOptions with(int low, int high, HighOrders form, bool shadows = false,
                   Method method = Method::factored) {
    return {.method = method,
            .shadows = shadows,
            .bake_directions = 512,
            .order_low = low,
            .order_high = high,
            .high_orders = form};
}

}  // namespace

IMAGE_TEST_CASE("split takes the image most of the way to all orders, convolution some") {
    for (const bool polarized : {false, true}) {
        const Scene scene = lone_sphere(falling_light(16, polarized),
                                        pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}, .alpha = 0.2}));
        const StokesImage all = render(context, scene, with(16, 16, HighOrders::none));
        const auto error = [&](HighOrders form) {
            return test::rms_difference(render(context, scene, with(4, 16, form)), all);
        };
        const double none = error(HighOrders::none);
        const double split = error(HighOrders::split);
        const double convolved = error(HighOrders::convolution);
        CAPTURES(polarized, none, convolved);
        CHECK(none > 1e-3);
        CHECK(split < 0.25 * none);
        CHECK(convolved < none);
        CHECK(split < 0.25 * convolved);
    }
}

IMAGE_TEST_CASE("both methods get the same high orders") {
    const Scene scene = balls_on_plate(falling_light(9, true));
    for (const HighOrders form : {HighOrders::split, HighOrders::convolution}) {
        StokesImage high[2];
        for (const Method method : {Method::factored, Method::dense}) {
            StokesImage& part = high[method == Method::dense ? 1 : 0];
            // The factored method alone would bake the seen vertices only, which refinement depends on.
            RenderOptions options = with(3, 9, form, true, method);
            options.disabled_optimisations = skip_rays;
            part = render(context, scene, options);
            options.high_orders = HighOrders::none;
            const StokesImage low = render(context, scene, options);
            CHECK(test::rms_difference(part, low) > 1e-3);
            part = test::minus(part, low);
        }
        CHECK(test::rms_difference(high[0], high[1]) < 1e-6);
    }
}

TEST_CASE("rotating the light equals rotating all else back, with shadows and high orders") {
    const glm::dmat3 rotation = theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7)));
    const auto context = gl::make_context(gl::Backend::osmesa);
    const EnvironmentPtr light = falling_light(9, true);
    for (const Method method : {Method::factored, Method::dense}) {
        // The bake directions rotate with the scene, so the shadows are equal.
        RenderOptions options = with(3, 9, HighOrders::split, true, method);
        options.disabled_optimisations = skip_rays;  // which vertices share a pixel depends on the axes
        const StokesImage here = render(context, balls_on_plate(light), options);
        const StokesImage there =
            render(context, balls_on_plate(light, rotation), options, camera_of(rotation));
        CHECK(test::rms_difference(here, there) < 2e-5);
        options.shadows = false;
        CHECK(test::rms_difference(
                  render(context, balls_on_plate(light), options),
                  render(context, balls_on_plate(light, rotation), options, camera_of(rotation))) < 1e-5);
    }
}

TEST_CASE("light without high orders costs none") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    const Scene scene = balls_on_plate(falling_light(3, false));
    Statistics low;
    Statistics high;
    const StokesImage plain = render(context, scene, with(3, 3, HighOrders::none), camera_of(), &low);
    const StokesImage same = render(context, scene, with(3, 64, HighOrders::split), camera_of(), &high);
    CHECK(plain.data == same.data);
    CHECK(high.order == 3);
    CHECK(high.response_bytes == low.response_bytes);
}

TEST_CASE("ringing can be windowed away, and what is left of it moved into the physically realizable range") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    const Scene scene = lone_sphere(test::lamp(), pplastic({.alpha = 0.1}));
    const auto lowest = [](const StokesImage& image) {
        float low = 0;
        for (std::size_t i = 0; i < image.data.size(); i += 4) low = std::min(low, image.data[i]);
        return low;
    };
    RenderOptions options = with(4, 4, HighOrders::none);
    options.split_lights = 0;
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
