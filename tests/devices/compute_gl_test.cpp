// SPDX-License-Identifier: MIT
// Tests of compute shaders against threads.
#include "devices/both_executors.hpp"
#include "gl/contexts.hpp"

using namespace nicol;
using test::at;
using test::BothExecutors;
using test::falling_light;

namespace {

const Camera above = test::camera_at({2, 4, 6}, {0, 0.5, 0});

/// Returns a coloured sphere on a metal plate, with this number of channels.
Scene sphere_on_plate(const EnvironmentPtr& light, int channels) {
    std::vector<double> colours;
    for (int c = 0; c < channels; ++c) colours.push_back(0.6 - 0.09 * c);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(4),
               .material = pplastic({.diffuse_reflectance = colours, .alpha = 0.3}),
               .to_world = at(0.2, 1, 0.1)});
    scene.add(
        {.mesh = test::rectangle(6), .material = test::some_metal(0.3), .to_world = test::plate_at(0, 3)});
    scene.set_environment(light, glm::dmat3(1), 0.7);
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("compute shaders make what threads make, of every light, channels, order and method") {
    constexpr auto none = HighOrders::none, split = HighOrders::split, convolution = HighOrders::convolution;
    constexpr auto factored = Method::factored, dense = Method::dense;
    constexpr auto unpolarized = LightKind::unpolarized, linear = LightKind::linear, full = LightKind::full;
    // Each two of the channels, lights, orders and shadows of a form meet in a row.
    const struct {
        Method method;
        HighOrders form;
        int channels;
        LightKind kind;
        int low, high;
        bool shadows;
    } rows[] = {{factored, none, 1, unpolarized, 0, 0, true},
                {factored, none, 1, linear, 4, 4, false},
                {factored, none, 1, full, 9, 9, true},
                {factored, none, 3, unpolarized, 4, 4, false},
                {factored, none, 3, linear, 9, 9, true},
                {factored, none, 3, full, 0, 0, false},
                {factored, none, 6, unpolarized, 9, 9, false},
                {factored, none, 6, linear, 0, 0, true},
                {factored, none, 6, full, 4, 4, true},
                // Shadows are multiplied on a grid above order 9.
                {factored, none, 3, unpolarized, 10, 10, true},
                {factored, none, 1, linear, 10, 10, true},
                {factored, none, 1, full, 16, 16, true},
                {dense, none, 1, unpolarized, 4, 4, true},
                {dense, none, 1, full, 4, 4, true},
                {dense, none, 3, unpolarized, 0, 0, true},
                {dense, none, 3, linear, 4, 4, true},
                {dense, none, 6, full, 0, 0, true},
                {factored, split, 1, unpolarized, 3, 9, false},
                {factored, split, 1, full, 3, 9, true},
                {factored, split, 6, unpolarized, 3, 9, true},
                {factored, split, 6, full, 3, 9, false},
                {factored, convolution, 1, unpolarized, 3, 9, true},
                {factored, convolution, 1, full, 3, 9, false},
                {factored, convolution, 6, unpolarized, 3, 9, false},
                {factored, convolution, 6, full, 3, 9, true}};
    for (const int channels : {1, 3, 6}) {
        BothExecutors comparison(context, channels);
        for (const auto& row : rows) {
            if (row.channels != channels) continue;
            CAPTURES(&row - rows);
            comparison.run(sphere_on_plate(falling_light(row.high, row.kind, channels), channels),
                           {.method = row.method,
                            .shadows = row.shadows,
                            .order_low = row.low,
                            .order_high = row.high,
                            .high_orders = row.form},
                           above);
            // Threads also keep the light at vertices if shadows use a grid.
            if (row.low > 9)
                CHECK(comparison.by_shaders.statistics().transfer_bytes <
                      comparison.by_threads.statistics().transfer_bytes);
        }
    }
}

IMAGE_TEST_CASE(
    "at pixels compute shaders make what threads make, of every light, method and number of samples") {
    constexpr auto none = HighOrders::none, split = HighOrders::split;
    constexpr auto factored = Method::factored, dense = Method::dense;
    struct Row {
        Method method;
        HighOrders form;
        int channels;
        LightKind kind;
        int low, high;
        bool shadows;
        int samples;
        bool orthographic;
    };
    const std::vector<Row> rows{
        {factored, none, 1, LightKind::unpolarized, 0, 0, true, 1, false},
        {factored, none, 3, LightKind::unpolarized, 4, 4, true, 1, true},
        {factored, none, 6, LightKind::linear, 4, 4, false, 4, false},
        {factored, none, 3, LightKind::full, 4, 4, true, 8, false},
        {factored, none, 1, LightKind::full, 10, 10, true, 1, false},
        {dense, none, 3, LightKind::unpolarized, 3, 3, true, 4, false},
        {dense, none, 1, LightKind::full, 4, 4, true, 1, false},
        {factored, split, 6, LightKind::full, 3, 9, true, 4, false},
        {factored, split, 3, LightKind::unpolarized, 3, 9, true, 8, true},
        {factored, HighOrders::convolution, 3, LightKind::full, 2, 9, false, 1, false}};
    for (const Row& row : rows) {
        CAPTURES(&row - rows.data());
        BothExecutors comparison(context, row.channels);
        Camera camera = above;
        camera.orthographic = row.orthographic;
        if (row.orthographic) camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(2.5));
        for (const bool physical : {false, true}) {
            comparison.run(sphere_on_plate(falling_light(row.high, row.kind, row.channels), row.channels),
                           {.method = row.method,
                            .shadows = row.shadows,
                            .order_low = row.low,
                            .order_high = row.high,
                            .high_orders = row.form,
                            .shade_at = ShadeAt::pixels,
                            .physical = physical,
                            .pixel_samples = row.samples},
                           camera);
            CHECK(comparison.by_shaders.statistics().pixels_shaded > 300);
        }
    }
}

IMAGE_TEST_CASE("options and changes reach compute shaders") {
    const EnvironmentPtr light = falling_light(6, LightKind::linear, 3);
    BothExecutors comparison(context, 3);
    Scene scene = sphere_on_plate(light, 3);
    for (const Method method : {Method::factored, Method::dense}) {
        // By default a first image refines what it shows alone.
        RenderOptions options{
            .method = method, .order_low = 3, .order_high = 6, .disabled_optimisations = skip_rays};
        comparison.run(scene, options, above);
        BothExecutors fresh(context, 3);
        fresh.run(scene, options, above);
        // After moves, few of the vertices that refinement adds lie elsewhere.
        BothExecutors::check_alike(fresh.by_threads.image(), comparison.by_threads.image(), false, true);
        BothExecutors::check_alike(fresh.by_shaders.image(), comparison.by_shaders.image(), false, true);
        options.physical = true;
        options.dering = 1e-3;
        comparison.run(scene, options, above);
        Camera camera = above;
        camera.orthographic = true;
        comparison.run(scene, options, camera);
        CHECK(comparison.by_shaders.statistics().relight_ms == 0);

        scene.set_environment(light, theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -1))), 0.4);
        comparison.run(scene, options, above);
        scene.set_transform(0, at(-0.5, 1.2, 0.3));
        comparison.run(scene, options, above);
        scene.set_environment(falling_light(5, LightKind::full, 1), glm::dmat3(1), 1);
        comparison.run(scene, options, above);
        scene.set_environment(light, glm::dmat3(1), 0.7);
    }
}

TEST_CASE("compute shaders take more vertices than one buffer of light holds") {
    BothExecutors comparison(gl::make_context(gl::Backend::osmesa), 3);
    Scene scene = sphere_on_plate(falling_light(2, LightKind::linear, 3), 3);
    scene.add({.mesh = test::rectangle(264), .material = diffuse({0.5}), .to_world = at(0, 0, -2, 3)});
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels})
        comparison.run(scene, {.order_low = 2, .order_high = 2, .shade_at = where}, above);
    CHECK(comparison.by_shaders.statistics().vertices > 65536 + 1000);
}

TEST_CASE("compute shaders take more pixels than are listed at once") {
    BothExecutors comparison(gl::make_context(gl::Backend::osmesa), 1, 400, 300);
    const Scene scene = sphere_on_plate(falling_light(1, LightKind::unpolarized, 1), 1);
    comparison.run(scene, {.shadows = false, .order_low = 1, .order_high = 1, .shade_at = ShadeAt::pixels},
                   test::camera_at({1, 4, 2}));
    CHECK(comparison.by_shaders.statistics().pixels_shaded > 65536 + 1000);
}

IMAGE_TEST_CASE("an empty scene and the automatic choice of the executor") {
    test::Studio render(context, 8, 8);
    Scene scene;
    scene.set_environment(constant_environment({1.0, 1.0, 1.0}), glm::dmat3(1), 1);
    CHECK(render(scene, {.executor = Executor::compute}).at(0, 4, 4)[0] == doctest::Approx(1));
    render(scene, {});
    CHECK(render.statistics.compute == !context->info().software);

    scene.add({.mesh = test::coarse_sphere(4), .material = diffuse({0.5})});
    const RenderOptions pixels{.executor = Executor::compute, .shade_at = ShadeAt::pixels};
    CHECK(render(scene, pixels, test::camera_at({0, 0, 3})).at(0, 4, 4)[0] < 0.9F);
    scene.remove(scene.ids().front());
    CHECK(render(scene, pixels).at(0, 4, 4)[0] == doctest::Approx(1));
    CHECK(render.statistics.pixels_shaded == 0);
}
