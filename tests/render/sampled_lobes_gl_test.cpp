// SPDX-License-Identifier: MIT
// Tests of lobes that reflect samples of the environment, against rays.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/principled.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::minus;
using test::rms;
using test::rms_difference;

namespace {

/// Returns an image of light with detail beyond order 64.
EnvironmentPtr detailed_light(bool polarized) {
    EquirectImage image(256, 129, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const double s0 = ((x / 8 + y / 8) % 2 == 0 ? 1.3 : 0.7) + 0.1 * c;
                const std::span<float, 4> out = image.at(c, y, x);
                out[0] = static_cast<float>(s0);
                if (polarized) out[1] = static_cast<float>(0.5 * s0), out[2] = static_cast<float>(-0.3 * s0);
            }
    return image_environment(image);
}

Scene ball_on_floor(const MaterialPtr& ball, bool polarized) {
    static const auto flat = test::with_texcoords(make_rectangle(4));
    Scene scene;
    scene.set_environment(detailed_light(polarized), glm::dmat3(1), 1);
    scene.add({.mesh = test::fine_sphere(), .material = ball});
    scene.add({.mesh = flat, .material = diffuse({0.2}), .to_world = test::plate_at(-1, 2)});
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("brushed and nearly smooth surfaces are as by rays") {
    const auto metal = [](double u, double v) {
        return rough_conductor({.eta = {{0.2, -3.0}}, .alpha = u, .alpha_v = v});
    };
    const struct {
        const char* name;
        MaterialPtr material;
        double tolerance;  // of the RMS of s0; edges of the light's squares leave noise
        double gain;       // least ratio of the error in harmonics to that of samples
    } rows[] = {{"brushed", metal(0.05, 0.4), 0.055, 1.8},
                {"brushed the other way", metal(0.4, 0.1), 0.05, 1.5},
                {"narrow", metal(0.02, 0), 0.045, 2},
                {"narrow plastic", pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.02}), 0.03, 1.5},
                {"brushed plastic", pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.05, .alpha_v = 0.3}),
                 0.04, 1.5},
                {"principled", principled({.roughness = 0.4, .anisotropic = 0.9, .metallic = 1}), 0.05, 1.6}};
    test::Studio studio(context, 36, 27);
    Camera camera = test::camera_at({1, 1, 4});
    camera.fov = 24;
    // Unpolarized light skips code that polarized light runs, so one material tests it.
    for (const auto& row : rows)
        for (const bool polarized : {true, false}) {
            if (!polarized && row.name != rows[0].name) continue;
            CAPTURES(row.name, polarized);
            const Scene scene = ball_on_floor(row.material, polarized);
            const StokesImage rays = studio(scene, {.method = Method::reference, .samples = 512}, camera);
            RenderOptions options{.bake_directions = 512,
                                  .order_low = 8,
                                  .order_high = 64,
                                  .shade_at = ShadeAt::automatic,
                                  .pixel_samples = 8};
            const double error = rms_difference(studio(scene, options, camera), rays) / rms(rays);
            CHECK(error < row.tolerance);
            CHECK(studio.statistics.pixels_shaded > 0);
            options.bsdf_samples = 0;
            CHECK(rms_difference(studio(scene, options, camera), rays) / rms(rays) > row.gain * error);
        }
}

IMAGE_TEST_CASE("a brushed lobe that is narrow in all directions reflects light without an image, too") {
    test::Studio studio(context, 36, 27);
    Scene scene;
    scene.set_environment(constant_environment({1, 1, 1}), glm::dmat3(1), 1);
    scene.add({.mesh = test::fine_sphere(),
               .material = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.03, .alpha_v = 0.09})});
    const Camera camera = test::camera_at({1, 1, 4});
    const StokesImage rays = studio(scene, {.method = Method::reference, .samples = 256}, camera);
    const StokesImage image = studio(
        scene, {.order_low = 2, .order_high = 2, .shade_at = ShadeAt::pixels, .pixel_samples = 8}, camera);
    CHECK(studio.statistics.pixels_shaded > 0);
    CHECK(rms_difference(image, rays) < 0.02 * rms(rays));
}

IMAGE_TEST_CASE("lobes reflect what hides even light as by rays") {
    static const auto flat = test::with_texcoords(make_rectangle(4));
    const struct {
        const char* name;
        double alpha, alpha_v;
    } rows[] = {{"narrow", 0.05, 0}, {"brushed", 0.24, 0.4}};
    constexpr int images = 8;
    test::Studio studio(context, 48, 36);
    Camera camera = test::camera_at({0, 2, 4});
    camera.fov = 40;
    for (const auto& row : rows) {
        CAPTURES(row.name);
        Scene scene;
        scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
        scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.1})});
        scene.add(
            {.mesh = flat,
             .material = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = row.alpha, .alpha_v = row.alpha_v}),
             .to_world = test::plate_at(-1, 2)});
        const StokesImage rays = studio(scene, {.method = Method::reference, .samples = 1024}, camera);
        // The noise of a single image says nothing of a shadow that is out of place.
        StokesImage mean = minus(rays, rays);
        for (int k = 0; k < images; ++k) {
            const StokesImage image = studio(scene,
                                             {.shade_at = ShadeAt::automatic,
                                              .choose_orders = true,
                                              .pixel_samples = 8,
                                              .seed = static_cast<std::uint64_t>(k)},
                                             camera);
            for (std::size_t i = 0; i < mean.data.size(); ++i) mean.data[i] += image.data[i] / images;
        }
        const double error = rms_difference(mean, rays) / rms(rays);
        CHECK(error < 0.03);
    }
}

IMAGE_TEST_CASE("a smooth surface mirrors the environment's image") {
    test::Studio studio(context, 64, 48);
    const Scene scene = ball_on_floor(conductor({{0, -1}}), false);
    Camera camera = test::camera_at({0, 1, 4});
    camera.fov = 30;
    const StokesImage image =
        studio(scene, {.order_low = 2, .order_high = 2, .shade_at = ShadeAt::pixels}, camera);
    // The squares of the light are 1.3 and 0.7 bright: a blur would show less contrast.
    int bright = 0, dark = 0;
    for (int y = 18; y < 30; ++y)
        for (int x = 26; x < 38; ++x) {
            const float s0 = image.at(0, y, x)[0];
            bright += s0 > 1.25F ? 1 : 0;
            dark += s0 < 0.75F ? 1 : 0;
        }
    CHECK(bright > 20);
    CHECK(dark > 20);
}
