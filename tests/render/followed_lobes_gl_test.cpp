// SPDX-License-Identifier: MIT
// Tests of narrow lobes of metal, which rays from pixels follow to other surfaces.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"
#include "scene/path_depth.hpp"

using namespace nicol;
using test::rms;
using test::rms_difference;

namespace {

constexpr std::complex<double> kIndex(0.2, -3.0);

MaterialPtr metal(double alpha, double alpha_v = 0) {
    return rough_conductor({.eta = {kIndex}, .alpha = alpha, .alpha_v = alpha_v});
}

glm::dmat4 wall(double z) {
    return glm::translate(glm::dmat4(1), {0, 0, z}) * test::at(0, 0, 0, 2);
}

/// Returns a floor of a material before a bright wall, and a ball on the floor.
Scene dark_floor_before_wall(const MaterialPtr& floor) {
    static const auto flat = test::with_texcoords(make_rectangle(8));
    Scene scene;
    scene.add({.mesh = flat, .material = floor, .to_world = test::plate_at(-1, 2)});
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.9, 0.5, 0.2}), .to_world = wall(-2)});
    scene.add({.mesh = test::coarse_sphere(8),
               .material = diffuse({0.2, 0.4, 0.8}),
               .to_world = test::at(0, -0.6, 0, 0.4)});
    return scene;
}

/// The same where a spot lights the wall alone, because the light of lamps off metal is not followed.
Scene floor_before_wall(const MaterialPtr& floor) {
    Scene scene = dark_floor_before_wall(floor);
    const glm::dvec3 place(0.3, 0.9, 3), target(0, 0.5, -2);
    scene.add_light({.kind = LocalLight::Kind::spot,
                     .value = {30.0, 30.0, 30.0},
                     .to_world = glm::inverse(glm::lookAt(place, 2.0 * place - target, glm::dvec3(0, 1, 0))),
                     .cutoff_angle = 0.25,
                     .beam_width = 0.2});
    return scene;
}

RenderOptions following(int samples, int max_depth = 12) {
    return {.executor = Executor::cpu,  // the one that follows rays
            .order_low = 4,
            .high_orders = HighOrders::none,
            .shade_at = ShadeAt::automatic,
            .pixel_samples = samples,
            .max_depth = max_depth};
}

/// Returns the difference of s1 and s2, over the RMS of s0 and all.
double polarized_difference(StokesImage image, const StokesImage& truth) {
    for (std::size_t i = 0; i < image.data.size(); i += 4) {
        image.data[i] = truth.data[i];
        image.data[i + 3] = truth.data[i + 3];
    }
    return rms_difference(image, truth) / rms(truth);
}

}  // namespace

IMAGE_TEST_CASE("narrow metal reflects a wall and a ball as by rays, polarized") {
    test::Studio render(context, 24, 18);
    const struct {
        double alpha, alpha_v, error, polarized;
    } rows[] = {{0.05, 0, 0.05, 0.0015}, {0.2, 0, 0.05, 0.0015}, {0.05, 0.2, 0.05, 0.0015}};
    for (const auto& row : rows) {
        CAPTURE(row.alpha);
        CAPTURE(row.alpha_v);
        const Scene scene = floor_before_wall(metal(row.alpha, row.alpha_v));
        const StokesImage truth =
            render(scene, {.method = Method::reference, .samples = 256, .max_depth = 12});
        const StokesImage image = render(scene, following(64));
        CHECK(render.statistics.smooth_rays > 0);
        CHECK(rms_difference(image, truth) / rms(truth) < row.error);
        CHECK(polarized_difference(image, truth) < row.polarized);
    }
}

IMAGE_TEST_CASE("metal that is hardly rough shows what a mirror shows") {
    test::Studio render(context, 24, 18);
    const auto image_of = [&](const MaterialPtr& floor) {
        Scene scene = dark_floor_before_wall(floor);
        scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
        return render(scene, following(16));
    };
    const StokesImage rough = image_of(metal(0.002)), smooth = image_of(conductor({kIndex}));
    CHECK(rms_difference(rough, smooth) < 0.03 * rms(smooth));
}

IMAGE_TEST_CASE("surfaces that absorb nothing look like the even light around them, metal included") {
    test::Studio render(context, 24, 18);
    // This metal reflects nearly everything.
    const MaterialPtr white = rough_conductor({.eta = {{0.0, -100.0}}, .alpha = 0.1});
    Scene scene;
    scene.add({.mesh = test::rectangle(8), .material = white, .to_world = test::plate_at(-1, 2)});
    scene.add(
        {.mesh = test::coarse_sphere(8), .material = diffuse({1.0}), .to_world = test::at(0, -0.6, 0, 0.4)});
    scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
    const StokesImage image = render(scene, following(16, kUnlimitedDepth));
    double sum = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 4) sum += double{image.data[i]};
    CHECK(sum / static_cast<double>(image.data.size() / 4) == doctest::Approx(1).epsilon(0.02));
}

IMAGE_TEST_CASE("metal shows the environment bent by glass as by rays") {
    test::Studio render(context, 24, 18);
    Scene scene;
    scene.add({.mesh = test::rectangle(8), .material = metal(0.15), .to_world = test::plate_at(-1, 2)});
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
               .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
               .to_world = test::at(0, -0.3, 0, 0.6)});
    EquirectImage image(64, 33, 1);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 64; ++x) image.at(0, y, x)[0] = static_cast<float>(1.1 + std::cos(0.2 * x));
    scene.set_environment(image_environment(image), glm::dmat3(1), 1);
    const StokesImage truth = render(scene, {.method = Method::reference, .samples = 512, .max_depth = 12});
    RenderOptions options = following(64);
    options.order_high = 16;
    const StokesImage shown = render(scene, options);
    CHECK(rms_difference(shown, truth) / rms(truth) < 0.06);
    CHECK(polarized_difference(shown, truth) < 0.03);
}

IMAGE_TEST_CASE("rays follow nothing where metal sees no other surface, or light does not bounce") {
    test::Studio render(context, 24, 18);
    Scene alone;
    alone.add({.mesh = test::coarse_sphere(6), .material = metal(0.1)});
    alone.set_environment(test::falling_light(2, false), glm::dmat3(1), 1);
    const StokesImage direct = render(alone, following(4, 2));
    CHECK(render(alone, following(4)).data == direct.data);
    CHECK(render.statistics.smooth_rays == 0);
    static_cast<void>(render(floor_before_wall(metal(0.1)), following(4, 2)));
    CHECK(render.statistics.smooth_rays == 0);
    static_cast<void>(render(floor_before_wall(metal(0.5)), following(4)));
    CHECK(render.statistics.smooth_rays == 0);
}

IMAGE_TEST_CASE("a seed chooses facets, and the same seed the same ones") {
    test::Studio render(context, 24, 18);
    const Scene scene = floor_before_wall(metal(0.1));
    RenderOptions options = following(2);
    const StokesImage first = render(scene, options);
    options.seed = 1;
    CHECK(render(scene, options).data != first.data);
    options.seed = 0;
    CHECK(render(scene, options).data == first.data);
}

IMAGE_TEST_CASE("the predicted error has the noise of rays that follow lobes") {
    test::Studio render(context, 24, 18);
    const Scene scene = floor_before_wall(metal(0.15));
    for (const int samples : {1, 8}) {
        CAPTURE(samples);
        RenderOptions options = following(samples);
        options.seed = 1;
        const StokesImage one = render(scene, options);
        const double predicted = render.statistics.predicted_error;
        options.seed = 2;
        const StokesImage other = render(scene, options);
        const double noise = rms_difference(one, other) / std::sqrt(2.0) / rms(other);
        CHECK(noise > 0.02);
        CHECK(predicted > 0.7 * noise);
        CHECK(predicted < 3 * noise);
    }
}

IMAGE_TEST_CASE("the predicted error has the noise of lobes by their share of the image") {
    test::Studio render(context, 24, 18);
    const Scene scene = floor_before_wall(metal(0.15));
    // The floor is a strip below the wall.
    const Camera camera = test::camera_at({0, 0.6, 1.5}, {0, -0.3, -2});
    RenderOptions options = following(8);
    options.seed = 1;
    const StokesImage one = render(scene, options, camera);
    const double predicted = render.statistics.predicted_error;
    options.seed = 2;
    const StokesImage other = render(scene, options, camera);
    const double noise = rms_difference(one, other) / std::sqrt(2.0) / rms(other);
    CHECK(predicted > 0.6 * noise);
    CHECK(predicted < 1.8 * noise);
}

IMAGE_TEST_CASE("with one bounce, rays end at direct light") {
    test::Studio render(context, 24, 18);
    const Scene scene = floor_before_wall(metal(0.1));
    const StokesImage truth = render(scene, {.method = Method::reference, .samples = 256, .max_depth = 3});
    CHECK(rms_difference(render(scene, following(64, 3)), truth) < 0.05 * rms(truth));
}

IMAGE_TEST_CASE("rays that follow lobes see lit surfaces that the image does not show") {
    Scene scene;
    scene.set_environment(test::falling_light(4, LightKind::full), glm::dmat3(1), 1);
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(4)),
               .material = metal(0.1),
               .to_world = test::at(0, 0, 0, 0.5)});
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-0.6, 3)});
    Camera camera = test::camera_at({0, 0.2, 1.6}, {0, 0.1, 0});
    camera.fov = 20;
    RenderOptions options = following(4);
    const StokesImage image = test::Studio(context, 24, 18)(scene, options, camera);
    options.disabled_optimisations = skip_hidden;
    const StokesImage all = test::Studio(context, 24, 18)(scene, options, camera);
    CHECK(rms(all) > 0);
    CHECK(rms_difference(image, all) < 1e-6 * rms(all));
}
