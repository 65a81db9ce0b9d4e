// SPDX-License-Identifier: MIT
// Tests of renders within a budget of time. No frame keeps the shortest budget, and every frame keeps the
// longest one, so that the results do not depend on the machine.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::Studio;

namespace {

RenderOptions wish(double budget) {
    RenderOptions options{.executor = Executor::cpu, .bake_directions = 256, .refine_tolerance = 0};
    options.time_budget_ms = budget;
    options.pixel_samples = 4;
    options.shade_at = ShadeAt::automatic;
    options.choose_orders = true;
    return options;
}

Scene ball_on_plate() {
    Scene scene;
    scene.set_environment(test::falling_light(9, true, 1), glm::dmat3(1), 1);
    scene.add({.mesh = test::coarse_sphere(8), .material = diffuse({0.5})});
    scene.add({.mesh = test::rectangle(6), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    return scene;
}

// Returns the camera of one of a series of frames.
Camera camera_of(int frame) {
    return test::camera_at({3, 4, 6 + 0.1 * frame}, {0, 0, 0});
}

constexpr double kShortest = 1e-9;
constexpr double kLongest = 1e9;

}  // namespace

IMAGE_TEST_CASE("a budget that is too short leads to the cheapest picture, and the statistics say so") {
    const Scene scene = ball_on_plate();
    Studio render(context);
    for (int frame = 0; frame < 60; ++frame) render(scene, wish(kShortest), camera_of(frame));
    const std::vector<Effort> all = efforts(wish(kShortest), true);
    CHECK(render.statistics.given_up + 1 == static_cast<int>(all.size()));
    CHECK(render.statistics.pixel_samples == 1);
    CHECK(render.statistics.light_samples == 4);
    CHECK(render.statistics.bsdf_samples == 8);
    CHECK(render.statistics.order_tolerance == 8 * wish(0).tolerance);
    CHECK(render.statistics.pixels_shaded == 0);

    // The picture is that of the options that are left.
    const Camera camera = camera_of(100);
    const StokesImage image = render(scene, wish(kShortest), camera);
    RenderOptions left = wish(0);
    left.pixel_samples = 1;
    left.light_samples = 4;
    left.bsdf_samples = 8;
    left.shade_at = ShadeAt::vertices;
    left.order_slack = 8;
    CHECK(image.data == Studio(context)(scene, left, camera).data);
    CHECK(image.data != Studio(context)(scene, wish(0), camera).data);
}

IMAGE_TEST_CASE("a budget that is long enough gives up nothing") {
    const Scene scene = ball_on_plate();
    Studio render(context), free(context);
    for (int frame = 0; frame < 12; ++frame) {
        const Camera camera = camera_of(frame);
        CHECK(render(scene, wish(kLongest), camera).data == free(scene, wish(0), camera).data);
    }
    CHECK(render.statistics.given_up == 0);
    CHECK(render.statistics.pixel_samples == 4);
    CHECK(render.statistics.order_tolerance == wish(0).tolerance);
}

IMAGE_TEST_CASE("a scene that does not change keeps its picture, whatever the time") {
    const Scene scene = ball_on_plate();
    Renderer renderer(context);
    Framebuffer target(context, 64, 48, 1);
    renderer.render(scene, camera_of(0), wish(kShortest), target);
    const StokesImage first = target.image();
    for (int frame = 0; frame < 5; ++frame) {
        const Statistics again = renderer.render(scene, camera_of(0), wish(kShortest), target);
        CHECK(again.draw_ms == 0);
        CHECK(again.given_up == 0);
    }
    CHECK(target.image().data == first.data);
}

IMAGE_TEST_CASE("textures and glass are shaded at pixels within any budget") {
    Scene scene = ball_on_plate();
    scene.add(
        {.mesh = test::coarse_sphere(6), .material = dielectric({}), .to_world = test::at(2, 0, 0, 0.5)});
    Studio render(context);
    for (int frame = 0; frame < 40; ++frame) render(scene, wish(kShortest), camera_of(frame));
    CHECK(render.statistics.given_up > 0);
    CHECK(render.statistics.pixels_shaded > 0);
}
