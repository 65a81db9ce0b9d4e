// SPDX-License-Identifier: MIT
// Tests of images that a reconstruction filter is applied to.
#include <algorithm>
#include <array>

#include "draw/sample_pattern.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/filtered_image.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::falling_light;
using test::minus;
using test::rms;
using test::Studio;
using Kind = ReconstructionFilter::Kind;

namespace {

/// Returns the part of the filter's integral over the image that lies to the right of `edge`, both relative
/// to a pixel's centre.
double part_beyond(const ReconstructionFilter& filter, double edge, double first, double last) {
    constexpr double step = 1e-3;
    double all = 0, beyond = 0;
    for (double x = first + step / 2; x < last; x += step) {
        all += filter(x);
        if (x > edge) beyond += filter(x);
    }
    return beyond / all;
}

}  // namespace

IMAGE_TEST_CASE("an edge is the filter's integral over the bright side, by rays and in real time") {
    constexpr int side = 8;
    Studio render(context, side, side);
    Camera camera;
    camera.orthographic = true;
    camera.to_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    constexpr double edge = 4.3;  // pixels from the left, or from the top
    constexpr double pixel = 2.0 / side;
    const std::array<ReconstructionFilter, 6> filters{{{.kind = Kind::box},
                                                       {.kind = Kind::gaussian},
                                                       {.kind = Kind::tent},
                                                       {.kind = Kind::mitchell},
                                                       {.kind = Kind::catmullrom},
                                                       {.kind = Kind::lanczos}}};
    for (const ReconstructionFilter& filter : filters) {
        for (const Method method : {Method::factored, Method::reference}) {
            for (const bool upright : {true, false}) {
                CAPTURE(static_cast<int>(filter.kind));
                CAPTURES(method, upright);
                Scene scene;
                const double over = pixel * edge - 1 - 2;
                scene.add({.mesh = test::rectangle(1),
                           .material = diffuse({0.0}),
                           .to_world = test::at(upright ? over : 0, upright ? 0 : -over, 0, 2)});
                scene.set_environment(falling_light(0, false, 1), glm::dmat3(1), 1);
                const RenderOptions options{.method = method,
                                            .executor = Executor::cpu,
                                            .bake_directions = 256,
                                            .order_high = 4,
                                            .pixel_samples = 64,
                                            .filter = filter,
                                            .samples = 4096};
                const StokesImage image = render(scene, options, camera);
                const StokesImage plain = render(scene,
                                                 {.method = method,
                                                  .executor = Executor::cpu,
                                                  .bake_directions = 256,
                                                  .order_high = 4,
                                                  .samples = 4},
                                                 camera);
                const double bright = plain.at(0, side - 1, side - 1)[0];
                REQUIRE(bright > 0);
                for (int i = 0; i < side; ++i) {
                    const double expected = part_beyond(filter, edge - i - 0.5, -i - 0.5, side - i - 0.5);
                    for (int k = 0; k < side; ++k) {
                        const double value = upright ? image.at(0, k, i)[0] : image.at(0, i, k)[0];
                        CHECK(std::abs(value / bright - expected) < 0.012);
                    }
                }
            }
        }
    }
}

IMAGE_TEST_CASE("samples are those of a jittered camera; AOVs are not filtered") {
    Studio render(context, 40, 40);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(16), .material = pplastic({.alpha = 0.3})});
    scene.set_environment(falling_light(4, true, 3), glm::dmat3(1), 1);
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
        for (const int samples : {1, 4, 5}) {
            CAPTURES(where, samples);
            RenderOptions options{.executor = Executor::cpu,
                                  .bake_directions = 256,
                                  .order_high = 4,
                                  .shade_at = where,
                                  .pixel_samples = samples,
                                  .aovs = aov_depth | aov_normals};
            Framebuffer target(context, render.width, render.height, scene.channels());
            render.renderer.render(scene, test::some_camera(), options, target);
            const StokesImage by_box = target.image();
            const Aovs unfiltered = target.aovs();
            options.filter = {.kind = Kind::lanczos};
            render.renderer.render(scene, test::some_camera(), options, target);
            const StokesImage image = target.image();
            CHECK(target.aovs().depth == unfiltered.depth);
            CHECK(target.aovs().normals == unfiltered.normals);

            FilteredImage filtered(options.filter, render.width, render.height, scene.channels());
            RenderOptions one = options;
            one.filter = {};
            one.pixel_samples = 1;
            Camera camera = test::some_camera();
            for (int s = 0; s < samples; ++s) {
                camera.jitter = sample_place(s, samples);
                filtered.add(render(scene, one, camera), camera.jitter);
            }
            const StokesImage expected = std::move(filtered).mean();
            CHECK(rms(minus(image, expected)) < 1e-6 * rms(expected));
            // The filter is 0 at the middles of other pixels, where single samples are.
            if (samples > 1) CHECK(rms(minus(image, by_box)) > 1e-2 * rms(expected));
        }
    }
}

IMAGE_TEST_CASE("executors agree on filtered images") {
    Studio render(context, 40, 40);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(16), .material = pplastic({.alpha = 0.3})});
    scene.set_environment(falling_light(4, true, 3), glm::dmat3(1), 1);
    RenderOptions options{.bake_directions = 256, .order_high = 4, .filter = {.kind = Kind::mitchell}};
    options.executor = Executor::cpu;
    const StokesImage by_threads = render(scene, options);
    options.executor = Executor::compute;
    const StokesImage by_shaders = render(scene, options);
    CHECK(rms(minus(by_threads, by_shaders)) < 1e-5 * rms(by_threads));
}
