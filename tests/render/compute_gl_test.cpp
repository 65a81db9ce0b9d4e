// SPDX-License-Identifier: MIT
// Compute shaders against threads.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/conductor.hpp"
#include "polarization/stokes.hpp"
#include "render/renderer.hpp"
#include "render/scenes.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using test::falling_light;

namespace {

constexpr double tolerance = 1e-5;  // of the largest value

const Camera some_camera = test::camera_at({2, 4, 6}, {0, 0.5, 0});

/// A coloured sphere that stands on a metal plate, with so many colour channels.
Scene sphere_on_plate(const EnvironmentPtr& light, int channels) {
    std::vector<double> colours;
    for (int c = 0; c < channels; ++c) colours.push_back(0.6 - 0.09 * c);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(4),
               .material = pplastic({.diffuse_reflectance = colours, .alpha = 0.3}),
               .to_world = glm::translate(glm::dmat4(1), {0.2, 1, 0.1})});
    scene.add({.mesh = std::make_shared<const Mesh>(make_rectangle(6)),
               .material = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.3}),
               .to_world = glm::rotate(glm::dmat4(1), glm::radians(-90.0), glm::dvec3(1, 0, 0)) *
                           glm::scale(glm::dmat4(1), glm::dvec3(3))});
    scene.set_environment(light, glm::dmat3(1), 0.7);
    return scene;
}

bool alike(const StokesImage& a, const StokesImage& b) {
    const double largest = test::largest(a);
    const double difference = test::largest_difference(a, b);
    CHECK(test::finite(b));
    CHECK(largest > 0.1);
    CHECK(difference <= tolerance * largest);
    return test::finite(b) && difference <= tolerance * largest;
}

/// Renders by both executors and compares the images.
struct Comparison {
    Comparison(const std::shared_ptr<gl::Context>& context, int channels)
        : threads(context, 0),
          shaders(context, 0),
          by_threads(context, 40, 30, channels),
          by_shaders(context, 40, 30, channels) {
        threads.set_cache(folder(), {});
        shaders.set_cache(folder(), {});
    }

    /// What takes long to prepare is shared by the backends.
    static std::filesystem::path folder() {
        static const TemporaryFolder shared;
        return shared.path();
    }

    void run(const Scene& scene, RenderOptions options, const Camera& camera = some_camera) {
        options.bake_directions = 256;
        options.executor = Executor::cpu;
        threads.render(scene, camera, options, by_threads);
        CHECK_FALSE(by_threads.statistics().compute);
        options.executor = Executor::compute;
        shaders.render(scene, camera, options, by_shaders);
        CHECK(by_shaders.statistics().compute);
        CHECK(alike(by_threads.image(), by_shaders.image()));
    }

    Renderer threads;  // each keeps what it needs, as it would give that up for the other executor
    Renderer shaders;
    Framebuffer by_threads;
    Framebuffer by_shaders;
};

constexpr std::array kinds{LightKind::unpolarized, LightKind::linear, LightKind::full};

}  // namespace

TEST_CASE("compute shaders make what threads make, of every kind of light, channels, orders and shadows") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        for (const int channels : {1, 3, 6}) {
            Comparison comparison(context, channels);
            for (const LightKind kind : kinds) {
                for (const int order : {0, 4, 9}) {
                    const Scene scene = sphere_on_plate(falling_light(order, kind, channels), channels);
                    for (const bool shadows : {false, true}) {
                        CAPTURE(channels);
                        CAPTURE(static_cast<int>(kind));
                        CAPTURE(order);
                        CAPTURE(shadows);
                        comparison.run(scene, {.shadows = shadows,
                                               .order_low = order,
                                               .order_high = order,
                                               .high_orders = HighOrders::none,
                                               .progress = {}});
                    }
                }
            }
        }
    });
}

TEST_CASE("compute shaders make what threads make of shadows on a grid") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        const auto compare = [](Comparison& comparison, LightKind kind, int order, int channels) {
            CAPTURE(channels);
            CAPTURE(static_cast<int>(kind));
            CAPTURE(order);
            comparison.run(
                sphere_on_plate(falling_light(order, kind, channels), channels),
                {.order_low = order, .order_high = order, .high_orders = HighOrders::none, .progress = {}});
            // Threads keep the light of vertices beside the shadows.
            CHECK(comparison.by_shaders.statistics().transfer_bytes <
                  comparison.by_threads.statistics().transfer_bytes);
        };
        for (const int channels : {1, 3}) {
            Comparison comparison(context, channels);
            for (const LightKind kind : kinds) compare(comparison, kind, 10, channels);
        }
        Comparison comparison(context, 1);
        compare(comparison, LightKind::full, 16, 1);
    });
}

TEST_CASE("compute shaders make what threads make by the dense method") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        for (const int channels : {1, 3, 6}) {
            Comparison comparison(context, channels);
            for (const LightKind kind : kinds) {
                for (const int order : {0, 4}) {
                    const Scene scene = sphere_on_plate(falling_light(order, kind, channels), channels);
                    CAPTURE(channels);
                    CAPTURE(static_cast<int>(kind));
                    CAPTURE(order);
                    comparison.run(scene, {.method = Method::dense,
                                           .order_low = order,
                                           .order_high = order,
                                           .high_orders = HighOrders::none,
                                           .progress = {}});
                }
            }
        }
    });
}

TEST_CASE("compute shaders make what threads make of high orders") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        for (const int channels : {1, 6}) {
            Comparison comparison(context, channels);
            for (const LightKind kind : {LightKind::unpolarized, LightKind::full}) {
                const Scene scene = sphere_on_plate(falling_light(9, kind, channels), channels);
                for (const HighOrders form : {HighOrders::split, HighOrders::convolution}) {
                    for (const bool shadows : {false, true}) {
                        CAPTURE(channels);
                        CAPTURE(static_cast<int>(kind));
                        CAPTURE(static_cast<int>(form));
                        CAPTURE(shadows);
                        comparison.run(scene, {.shadows = shadows,
                                               .order_low = 3,
                                               .order_high = 9,
                                               .high_orders = form,
                                               .progress = {}});
                    }
                }
            }
        }
    });
}

TEST_CASE("options and changes reach compute shaders") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        const EnvironmentPtr light = falling_light(6, LightKind::linear, 3);
        Comparison comparison(context, 3);
        Scene scene = sphere_on_plate(light, 3);
        for (const Method method : {Method::factored, Method::dense}) {
            RenderOptions options{.method = method, .order_low = 3, .order_high = 6, .progress = {}};
            comparison.run(scene, options);
            Comparison fresh(context, 3);
            fresh.run(scene, options);
            CHECK(alike(fresh.by_threads.image(), comparison.by_threads.image()));
            CHECK(alike(fresh.by_shaders.image(), comparison.by_shaders.image()));
            options.physical = true;
            options.dering = 1e-3;
            comparison.run(scene, options);
            Camera camera = some_camera;
            camera.orthographic = true;
            comparison.run(scene, options, camera);
            CHECK(comparison.by_shaders.statistics().relight_ms == 0);

            scene.set_environment(light, theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -1))), 0.4);
            comparison.run(scene, options);
            scene.set_transform(0, glm::translate(glm::dmat4(1), {-0.5, 1.2, 0.3}));
            comparison.run(scene, options);
            scene.set_environment(falling_light(5, LightKind::full, 1), glm::dmat3(1), 1);
            comparison.run(scene, options);
            scene.set_environment(light, glm::dmat3(1), 0.7);
        }
    });
}

TEST_CASE("compute shaders take more vertices than one buffer of light holds") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    Comparison comparison(context, 3);
    Scene scene = sphere_on_plate(falling_light(2, LightKind::linear, 3), 3);
    scene.add(
        {.mesh = std::make_shared<const Mesh>(make_rectangle(264)),
         .material = diffuse({0.5}),
         .to_world = glm::translate(glm::dmat4(1), {0, 0, -2}) * glm::scale(glm::dmat4(1), glm::dvec3(3))});
    comparison.run(scene, {.order_low = 2, .order_high = 2, .progress = {}});
    CHECK(comparison.by_shaders.statistics().vertices > 65536 + 1000);
}

TEST_CASE("an empty scene and the automatic choice of the executor") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        Renderer renderer(context, 0);
        Framebuffer target(context, 8, 8, 3);
        Scene scene;
        scene.set_environment(constant_environment({1.0, 1.0, 1.0}), glm::dmat3(1), 1);
        renderer.render(scene, some_camera, {.executor = Executor::compute, .progress = {}}, target);
        CHECK(target.image().at(0, 4, 4)[0] == doctest::Approx(1));
        renderer.render(scene, some_camera, {.progress = {}}, target);
        CHECK(target.statistics().compute == !context->info().software);
    });
}
