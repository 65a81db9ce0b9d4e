// SPDX-License-Identifier: MIT
// Tests of glass that light passes, and of mirrors that show other surfaces.
#include "directions.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::rms;
using test::rms_difference;

namespace {

// Brewster's angle of an index of 1.5.
const double kBrewster = std::atan(1.5);
// Reflectance for s-polarized light of one boundary at this angle; that for p is 0.
constexpr double kReflectance = (1.25 / 3.25) * (1.25 / 3.25);

DielectricParameters glass_of(double index) {
    return {.int_ior = index, .ext_ior = 1};
}

const RenderOptions kPixels{.bake_directions = 512, .shade_at = ShadeAt::automatic};

/// Returns the matrix of a square whose normal is tilted about x from +z by an angle.
glm::dmat4 tilted(double angle, double z, double half) {
    return test::at(0, 0, z, half) * glm::rotate(glm::dmat4(1), angle, glm::dvec3(1, 0, 0));
}

/// Adds a wall at z = -3 that emits light of radiance 1.
void add_wall(Scene& scene, const PolarizationState& state = {}) {
    scene.add({.mesh = test::rectangle(1),
               .material = diffuse({0}),
               .to_world = test::at(0, 0, -3, 2),
               .emission = std::make_shared<const Emission>(Emission{.radiance = {1}, .state = state})});
}

/// Returns the mean of an image of one channel.
Stokes mean_of(const StokesImage& image) {
    Stokes sum(0.0);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        sum[static_cast<glm::length_t>(i % 4)] += static_cast<double>(image.data[i]);
    return sum * (4.0 / static_cast<double>(image.data.size()));
}

/// Returns the root mean square of the difference of a Stokes component, relative to that of s0 of `rays`.
double relative_error(const StokesImage& ours, const StokesImage& rays, std::size_t component) {
    double error = 0, power = 0;
    for (std::size_t i = 0; i < rays.data.size(); i += 4) {
        error += std::pow(static_cast<double>(ours.data[i + component] - rays.data[i + component]), 2);
        power += std::pow(static_cast<double>(rays.data[i]), 2);
    }
    return std::sqrt(error / power);
}

Camera narrow_camera(const glm::dvec3& eye, double fov = 0.5) {
    Camera camera = test::camera_at(eye);
    camera.fov = fov;
    return camera;
}

MaterialPtr soap_film() {
    return dielectric({.int_ior = 1, .ext_ior = 1, .film = {.thickness = 400, .eta = {1.33}}});
}

/// Returns a metal of low reflectance with an oxide.
MaterialPtr anodised(double alpha) {
    const std::vector<std::complex<double>> eta = {{2.7, -3.5}};
    return rough_conductor(
        {.eta = eta, .alpha = alpha, .film = film_table({.thickness = 150, .eta = {2.4}}, 1, eta)});
}

}  // namespace

IMAGE_TEST_CASE("glass that light passes is refused where no rays begin at pixels") {
    test::Studio render(context);
    for (const MaterialPtr& glass : {dielectric({}), thin_dielectric({})}) {
        Scene scene;
        scene.add({.mesh = test::coarse_sphere(6), .material = glass});
        scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
        check_error(ErrorCode::unsupported, CALL(render(scene, {.method = Method::dense})),
                    "glass that light passes", "set method to factored or reference");
        check_error(ErrorCode::unsupported, CALL(render(scene, {.shade_at = ShadeAt::vertices})),
                    "glass that light passes", "set shade_at to automatic or pixels");
    }
}

IMAGE_TEST_CASE("light passes a pane at Brewster's angle as the closed form says") {
    test::Studio studio(context, 8, 8);
    for (const int panes : {1, 2}) {
        CAPTURE(panes);
        Scene scene;
        add_wall(scene);
        for (int i = 0; i < panes; ++i)
            scene.add({.mesh = test::rectangle(1),
                       .material = thin_dielectric(glass_of(1.5)),
                       .to_world = tilted(kBrewster, 0.5 * i, 2)});
        const StokesImage image = studio(scene, kPixels, narrow_camera({0, 0, 9}));
        CHECK(studio.statistics.smooth_rays >= 64);
        // Stokes's formula for a pile of plates, for s, the image's x axis. All of p passes.
        const double passing = (1 - kReflectance) / (1 + (2 * panes - 1) * kReflectance);
        CHECK(glm::distance(mean_of(image), Stokes((passing + 1) / 2, (passing - 1) / 2, 0, 0)) < 1e-3);
    }
}

IMAGE_TEST_CASE("a pane tilted by 56 degrees in any plane shows light in any state as the closed form says") {
    test::Studio studio(context, 8, 8);
    const double tilt = glm::radians(56.0), index = 1.5;
    const double cosine = std::cos(tilt), inner = std::sqrt(1 - std::pow(std::sin(tilt) / index, 2));
    const double s = std::pow((cosine - index * inner) / (cosine + index * inner), 2);
    const double p = std::pow((index * cosine - inner) / (index * cosine + inner), 2);
    // All reflections inside, without interference: 1 - r of each side, and r^2 between two of them.
    const double of_s = (1 - s) / (1 + s), of_p = (1 - p) / (1 + p);
    const double together = (1 - s) * (1 - p) / (1 - s * p);
    for (const double turn : {0.0, 30.0, 100.0}) {
        for (const PolarizationState& state :
             {PolarizationState{}, PolarizationState{.dolp = 0.8, .aolp = 0.3},
              PolarizationState{.dolp = 0.5, .aolp = 1.2, .docp = -0.6}}) {
            CAPTURE(turn);
            CAPTURE(state.dolp);
            Scene scene;
            add_wall(scene, state);
            const double angle = glm::radians(turn);
            scene.add(
                {.mesh = test::rectangle(1),
                 .material = thin_dielectric(glass_of(index)),
                 .to_world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 0, 1)) * tilted(tilt, 0, 2)});
            const StokesImage image = studio(scene, kPixels, narrow_camera({0, 0, 9}));
            // The s-axis is the axis of the tilt. The image's x is the world's.
            const Stokes given(1, state.dolp * std::cos(2 * state.aolp),
                               state.dolp * std::sin(2 * state.aolp), state.docp);
            const Stokes in = rotated(given, angle);
            const Stokes passed((of_s + of_p) / 2 * in[0] + (of_s - of_p) / 2 * in[1],
                                (of_s - of_p) / 2 * in[0] + (of_s + of_p) / 2 * in[1], together * in[2],
                                together * in[3]);
            CHECK(glm::distance(mean_of(image), rotated(passed, -angle)) < 1e-3);
        }
    }
}

IMAGE_TEST_CASE("a pane reflects at Brewster's angle as the closed form says") {
    test::Studio studio(context, 8, 8);
    Scene scene;
    // The wall is where the pane mirrors the view: the pane rotates it by 2 (90 - Brewster) about x.
    const double mirrored = 2 * kBrewster;
    const glm::dmat4 there = glm::rotate(glm::dmat4(1), mirrored, glm::dvec3(1, 0, 0));
    scene.add({.mesh = test::rectangle(1),
               .material = diffuse({0}),
               .to_world = there * test::at(0, 0, 3, 1) *
                           glm::rotate(glm::dmat4(1), glm::radians(180.0), glm::dvec3(1, 0, 0)),
               .emission = std::make_shared<const Emission>(Emission{.radiance = {1}})});
    scene.add({.mesh = test::rectangle(1),
               .material = thin_dielectric(glass_of(1.5)),
               .to_world = tilted(kBrewster, 0, 0.5)});
    const double reflected = 2 * kReflectance / (1 + kReflectance);
    const StokesImage image = studio(scene, kPixels, narrow_camera({0, 0, 9}));
    CHECK(glm::distance(mean_of(image), Stokes(reflected / 2, reflected / 2, 0, 0)) < 1e-3);
}

IMAGE_TEST_CASE("glass of the index of its surroundings changes nothing") {
    test::Studio studio(context);
    const auto colours =
        test::texture_of([](const TexturePoint& at) { return glm::vec4(at.uv.x, at.uv.y, 1 - at.uv.x, 1); });
    for (const MaterialPtr& glass : {dielectric(glass_of(1)), thin_dielectric(glass_of(1))}) {
        Scene scene;
        scene.set_environment(test::falling_light(9, LightKind::full), some_rotation(), 1);
        scene.add({.mesh = test::with_texcoords(make_rectangle(6)),
                   .material = pplastic({.diffuse_reflectance = {colours}, .alpha = 0.3}),
                   .to_world = test::plate_at(-1, 2)});
        scene.add(
            {.mesh = test::coarse_sphere(8), .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}})});
        scene.add({.mesh = test::coarse_sphere(6),
                   .material = test::some_metal(0.3),
                   .to_world = test::at(1.3, -0.4, 0.4, 0.5)});
        LocalLight lamp;
        lamp.value = {20};
        lamp.to_world = test::at(1, 3, 2);
        scene.add_light(lamp);
        for (const bool shadows : {false, true}) {
            CAPTURE(shadows);
            RenderOptions options = kPixels;
            options.shadows = shadows;
            options.executor =
                Executor::cpu;  // as with the pane; compute shaders know no functions as textures
            const StokesImage without = studio(scene, options);
            CHECK(studio.statistics.smooth_rays == 0);
            const std::uint32_t pane = scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                                                  .material = glass,
                                                  .to_world = test::at(1, 1.5, 2, 0.7)});
            const StokesImage with = studio(scene, options);
            CHECK(studio.statistics.smooth_rays > 200);
            scene.remove(pane);
            // Another instance may change the directions of the bake, and rays have no size on edges.
            CHECK(rms_difference(with, without) < (shadows ? 1e-2 : 1e-3) * rms(without));
            if (!shadows) CHECK(test::differing_pixels(with, without, 1e-4 * rms(without)) < 8);
        }
    }
}

IMAGE_TEST_CASE("a film of the index of the surroundings changes nothing, nor does light in any state") {
    test::Studio studio(context, 40, 30);
    // Chains of samples that show a boundary without a film are followed side by side, others one by one.
    const std::vector<double> absorption{0.4, 0, 1.5};
    const auto shown = [&](bool film, bool thin, bool orthographic) {
        DielectricParameters of = glass_of(1.5);
        of.specular_reflectance = {0.9, 1.0, 0.8};
        of.specular_transmittance = {0.8, 0.9, 1.0};
        if (!thin) of.absorption = absorption;
        if (film) of.film = {.thickness = 300, .eta = {1.0}};
        Scene scene;
        scene.set_environment(test::falling_light(6, LightKind::full), some_rotation(), 1.5);
        const MaterialPtr glass = thin ? thin_dielectric(of) : dielectric(of);
        scene.add({.mesh = test::coarse_sphere(8), .material = glass});
        scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                   .material = glass,
                   .to_world = test::at(1.1, 0.3, -1, 0.7)});
        scene.add({.mesh = test::coarse_sphere(6),
                   .material = pplastic({.diffuse_reflectance = {0.3, 0.2, 0.1}}),
                   .to_world = test::at(0, 0.1, 0, 0.4)});
        scene.add({.mesh = test::rectangle(6),
                   .material = test::some_metal(0.3),
                   .to_world = test::plate_at(-1.3, 2)});
        Camera camera = test::some_camera();
        if (orthographic) {
            camera.orthographic = true;
            camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(2));
        }
        RenderOptions options = kPixels;
        options.pixel_samples = 2;
        return studio(scene, options, camera);
    };
    for (const bool thin : {false, true})
        for (const bool orthographic : {false, true}) {
            CAPTURE(thin);
            CAPTURE(orthographic);
            const StokesImage without = shown(false, thin, orthographic);
            CHECK(studio.statistics.smooth_rays > 1000);
            CHECK(rms_difference(shown(true, thin, orthographic), without) < 1e-3 * rms(without));
        }
}

IMAGE_TEST_CASE("a body absorbs light by the length of its path inside, a surface inside included") {
    test::Studio studio(context, 8, 8);
    const std::vector<double> absorption{0.5, 2, 0};
    // The cube extends from z = -1 to 1.
    for (const auto& [wall_at, length] : {std::pair{-3.0, 2.0}, {-0.25, 1.25}}) {
        Scene scene;
        scene.add({.mesh = test::rectangle(1),
                   .material = diffuse({0, 0, 0}),
                   .to_world = test::at(0, 0, wall_at, 0.5),
                   .emission = std::make_shared<const Emission>(Emission{.radiance = {1}})});
        scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                   .material = dielectric({.int_ior = 1, .ext_ior = 1, .absorption = absorption})});
        const StokesImage image = studio(scene, kPixels, narrow_camera({0, 0, 9}));
        for (int c = 0; c < 3; ++c)
            CHECK(static_cast<double>(image.stokes(c, 4, 4)[0]) ==
                  doctest::Approx(std::exp(-absorption[static_cast<std::size_t>(c)] * length)).epsilon(1e-4));
    }
}

IMAGE_TEST_CASE(
    "glass dims the light of lamps behind it in each channel, by its boundaries and its absorption") {
    test::Studio studio(context, 8, 8);
    const auto lit = [&](const MaterialPtr& glass) {
        Scene scene;
        scene.add({.mesh = test::rectangle(1), .material = diffuse({0.5, 0.5, 0.5})});
        if (glass)
            scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                       .material = glass,
                       .to_world = test::at(0, 0, 2, 0.5)});
        LocalLight lamp;
        lamp.value = {20};
        lamp.to_world = test::at(0, 0, 6);
        scene.add_light(lamp);
        const StokesImage image = studio(scene, kPixels, narrow_camera({5, 0, 1}, 0.2));
        return std::array{image.stokes(0, 4, 4)[0], image.stokes(1, 4, 4)[0], image.stokes(2, 4, 4)[0]};
    };
    const auto open = lit(nullptr);
    REQUIRE(open[0] > 0.01);
    // Each pane and each boundary of the body is met twice, along its normal.
    const double pane = 1 - 2 * 0.04 / 1.04;
    const std::vector<double> tint{0.5, 0.25, 1}, absorption{0.7, 0, 0.1};
    const auto panes = lit(thin_dielectric({.specular_transmittance = tint, .int_ior = 1.5, .ext_ior = 1}));
    const auto body = lit(dielectric({.int_ior = 1.5, .ext_ior = 1, .absorption = absorption}));
    for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(panes[c] / open[c] == doctest::Approx(std::pow(pane * tint[c], 2)).epsilon(5e-3));
        CHECK(body[c] / open[c] == doctest::Approx(0.96 * 0.96 * std::exp(-absorption[c])).epsilon(5e-3));
    }
}

IMAGE_TEST_CASE("glass dims the environment's light behind it as by rays, also when the glass changes") {
    test::Studio studio(context, 8, 8);
    Scene scene;
    // The floor is so wide that light which the glass mirrors comes from the floor, after more segments.
    scene.add({.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::at(0, 0, 0, 40)});
    scene.set_environment(test::falling_light(3, LightKind::unpolarized, 1), some_rotation(), 1);
    const auto shown = [&](const RenderOptions& options) {
        return mean_of(studio(scene, options, narrow_camera({5, 0, 1}, 0.2)))[0];
    };
    const auto by_rays = [&](int segments) {
        return shown({.method = Method::reference, .samples = 4096, .max_depth = segments});
    };
    const double open = shown(kPixels);
    CHECK(open == doctest::Approx(by_rays(2)).epsilon(0.01));
    const std::uint32_t pane = scene.add({.mesh = test::rectangle(1),
                                          .material = thin_dielectric(glass_of(1.5)),
                                          .to_world = test::at(0, 0, 2, 400)});
    const double through = shown(kPixels);
    CHECK(through < 0.95 * open);
    CHECK(through == doctest::Approx(by_rays(3)).epsilon(0.015));
    scene.set_material(pane,
                       thin_dielectric({.specular_transmittance = {0.5}, .int_ior = 1.5, .ext_ior = 1}));
    CHECK(shown(kPixels) == doctest::Approx(0.5 * through).epsilon(0.01));
    scene.set_transform(pane, test::at(0, 0, -2, 400));
    CHECK(shown(kPixels) == doctest::Approx(open).epsilon(1e-3));
    scene.set_transform(pane, test::at(0, 0, 2, 400));
    CHECK(shown(kPixels) == doctest::Approx(0.5 * through).epsilon(0.01));
    scene.remove(pane);
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
               .material = dielectric(glass_of(1.5)),
               .to_world = glm::scale(test::at(0, 0, 2.5), glm::dvec3(400, 400, 0.1))});
    CHECK(shown(kPixels) == doctest::Approx(by_rays(4)).epsilon(0.02));
}

IMAGE_TEST_CASE("max_depth says how often light passes glass, as by rays") {
    test::Studio studio(context, 8, 8);
    Scene scene;
    add_wall(scene);
    for (int i = 0; i < 3; ++i)
        scene.add({.mesh = test::rectangle(1),
                   .material = thin_dielectric(glass_of(1.5)),
                   .to_world = test::at(0, 0, i, 2)});
    const double reflected = 2 * 0.04 / 1.04;
    // Light that is reflected to and fro has two events more.
    const double once = std::pow(1 - reflected, 3);
    for (const auto& [max_depth, wanted] : {std::pair{3, 0.0}, {4, once}, {5, once}}) {
        CAPTURE(max_depth);
        RenderOptions options = kPixels;
        options.max_depth = max_depth;
        const double found = mean_of(studio(scene, options, narrow_camera({0, 0, 9})))[0];
        CHECK(found == doctest::Approx(wanted).epsilon(1e-3));
        options = {.method = Method::reference, .samples = 1024, .max_depth = max_depth};
        CHECK(mean_of(studio(scene, options, narrow_camera({0, 0, 9})))[0] ==
              doctest::Approx(wanted).epsilon(5e-3));
    }
    RenderOptions direct = kPixels;
    const double many = mean_of(studio(scene, direct, narrow_camera({0, 0, 9})))[0];
    CHECK(many == doctest::Approx((1 - 0.04) / (1 + 5 * 0.04)).epsilon(2e-3));
}

IMAGE_TEST_CASE("rough glass shows its surroundings as by rays, and what facets of panes transmit") {
    test::Studio studio(context, 32, 24);
    const auto squares = test::texture_of(
        [](const TexturePoint& at) { return glm::vec4((at.uv.x < 0.5F) == (at.uv.y < 0.5F) ? 0.8F : 0.2F); },
        1);
    Camera camera = test::camera_at({1, 1.5, 5});
    camera.fov = 36;
    for (const MaterialPtr& material :
         {dielectric({.int_ior = 1.5, .ext_ior = 1, .absorption = {0.3}, .alpha = 0.2}),
          dielectric({.int_ior = 1.5,
          .ext_ior = 1,
          .absorption = {0.3},
          .alpha = 0.2,
          .film = {.thickness = 300, .eta = {2.2}}}),
          thin_dielectric({.int_ior = 1.5, .ext_ior = 1, .alpha = 0.3, .distribution = Distribution::ggx})}) {
        CAPTURE(material->content_key());
        Scene scene;
        scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {1}}), glm::dmat3(1), 1);
        scene.add({.mesh = test::fine_sphere(), .material = material});
        scene.add({.mesh = test::with_texcoords(make_rectangle(12)),
                   .material = diffuse({squares}),
                   .to_world = test::plate_at(-1.2, 3)});
        RenderOptions options = kPixels;
        options.order_low = 6;
        options.order_high = 16;
        options.pixel_samples = 64;
        const StokesImage ours = studio(scene, options, camera);
        const StokesImage rays =
            studio(scene, {.method = Method::reference, .samples = 1024, .max_depth = 8}, camera);
        for (std::size_t p = 0; p < 3; ++p) {
            CAPTURE(p);
            CHECK(relative_error(StokesImage(rays.width, rays.height, rays.channels), rays, p) > 0.05);
            // The reference's floor is darker below the ball, which casts no shadow by the factored method.
            CHECK(relative_error(ours, rays, p) < (p == 0 ? 0.08 : 0.03));
        }
    }
}

IMAGE_TEST_CASE("rough metal with a film reflects its surroundings as by rays, in colours") {
    test::Studio studio(context, 32, 24);
    Camera camera = test::camera_at({1, 1.5, 5});
    camera.fov = 36;
    Scene scene;
    scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {1, 1, 1}}), glm::dmat3(1),
                          1);
    scene.add({.mesh = test::fine_sphere(), .material = anodised(0.3)});
    RenderOptions options = kPixels;
    options.order_low = 6;
    options.order_high = 16;
    options.pixel_samples = 16;
    const StokesImage ours = studio(scene, options, camera);
    const StokesImage rays =
        studio(scene, {.method = Method::reference, .samples = 512, .max_depth = 8}, camera);
    for (std::size_t p = 0; p < 3; ++p) {
        CAPTURE(p);
        CHECK(relative_error(ours, rays, p) < 0.03);
    }
    const Stokes red = rays.stokes(0, 12, 16), blue = rays.stokes(2, 12, 16);
    CHECK(std::abs(red[0] - blue[0]) > 0.05 * red[0]);
}

IMAGE_TEST_CASE("spheres of glass and mirrors show their surroundings as by rays") {
    test::Studio studio(context, 48, 36);
    const auto squares = test::texture_of(
        [](const TexturePoint& at) { return glm::vec4((at.uv.x < 0.5F) == (at.uv.y < 0.5F) ? 0.8F : 0.2F); },
        1);
    Camera camera = test::camera_at({1, 1.5, 5});
    camera.fov = 36;
    for (const MaterialPtr& material :
         {dielectric(glass_of(1.5)), rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0}), soap_film(),
          anodised(0.0)}) {
        CAPTURE(material->content_key());
        Scene scene;
        EquirectImage image(64, 33, 1);
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 64; ++x) {
                image.at(0, y, x)[0] = static_cast<float>(1 + std::cos(0.4 * y) * std::cos(0.2 * x));
                image.at(0, y, x)[1] = 0.3F * image.at(0, y, x)[0];
            }
        scene.set_environment(image_environment(image), glm::dmat3(1), 1);
        scene.add({.mesh = test::fine_sphere(), .material = material});
        scene.add({.mesh = test::with_texcoords(make_rectangle(12)),
                   .material = diffuse({squares}),
                   .to_world = test::plate_at(-1.2, 3)});
        scene.add({.mesh = test::coarse_sphere(10),
                   .material = pplastic({.diffuse_reflectance = {0.5}, .alpha = 0.3}),
                   .to_world = test::at(-1.6, -0.6, 0.9, 0.5)});
        RenderOptions options = kPixels;
        options.order_low = 6;
        options.order_high = 16;
        options.pixel_samples = 8;
        const StokesImage ours = studio(scene, options, camera);
        // Longer paths reflect light between rough surfaces as well.
        const StokesImage rays =
            studio(scene, {.method = Method::reference, .samples = 512, .max_depth = 8}, camera);
        for (std::size_t p = 0; p < 3; ++p) {
            CAPTURE(p);
            CHECK(relative_error(ours, rays, p) < (p == 0 ? 0.07 : 0.035));
        }
    }
}
