// SPDX-License-Identifier: MIT
// Tests of several samples per pixel, and of camera jitter.
#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "draw/sample_pattern.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::falling_light;
using test::minus;
using test::rms;
using test::Studio;

namespace {

RenderOptions with(int samples, ShadeAt where) {
    return {.executor = Executor::cpu,
            .bake_directions = 256,
            .order_high = 4,
            .shade_at = where,
            .pixel_samples = samples,
            .disabled_optimisations = skip_rays};  // a first picture bakes less than later ones
}

constexpr std::array kPlaces{ShadeAt::vertices, ShadeAt::pixels};

/// Returns a dark sphere over a bright plate.
Scene sphere_on_plate() {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(16), .material = diffuse({0.1})});
    scene.add({.mesh = test::rectangle(16),
               .material = twosided(pplastic({.diffuse_reflectance = {0.8}, .alpha = 0.3})),
               .to_world = test::plate_at(-1, 1.5)});
    scene.set_environment(falling_light(4, true, 3), glm::dmat3(1), 1);
    return scene;
}

/// Returns the mean of images whose camera is jittered over the centres of a grid of side x side in a pixel.
StokesImage mean_of_jittered(Studio& render, const Scene& scene, const RenderOptions& options, int side) {
    StokesImage mean(render.width, render.height, scene.channels());
    Camera camera = test::some_camera();
    for (int i = 0; i < side * side; ++i) {
        camera.jitter = {(i % side + 0.5) / side - 0.5, (i / side + 0.5) / side - 0.5};
        const StokesImage image = render(scene, options, camera);
        for (std::size_t k = 0; k < mean.data.size(); ++k)
            mean.data[k] += image.data[k] / static_cast<float>(side * side);
    }
    return mean;
}

}  // namespace

TEST_CASE("samples lie in their pixel around its centre, one in each row and column of a grid") {
    for (const int samples : {1, 2, 3, 4, 6, 8, 16, 64, 100, 1024}) {
        const std::span<const glm::dvec2> together = sample_pattern(samples);
        std::vector<glm::dvec2> pattern(together.begin(), together.end());
        for (int s = 0; together.empty() && s < samples; ++s) pattern.push_back(sample_place(s, samples));
        REQUIRE(pattern.size() == static_cast<std::size_t>(samples));
        glm::dvec2 sum(0);
        for (const glm::length_t axis : {0, 1}) {
            std::vector<int> cells;
            for (const glm::dvec2& at : pattern)
                cells.push_back(static_cast<int>(std::floor((at[axis] + 0.5) * samples)));
            std::ranges::sort(cells);
            for (int i = 0; i < samples; ++i) CHECK(cells[static_cast<std::size_t>(i)] == i);
        }
        for (const glm::dvec2& at : pattern) sum += at;
        // Sums are exact for powers of two and rounded for other numbers.
        CHECK(glm::length(sum) <= (std::has_single_bit(pattern.size()) ? 0.0 : 1e-9));
    }
    for (const int samples : {-1, 0, 2, 3, 5, 16}) {
        CHECK(sample_pattern(samples).empty());
        CHECK(samples_at_once(samples) == kMostPixelSamples);
    }
}

TEST_CASE("samples that are drawn one by one fill their pixel evenly") {
    for (const int samples : {2, 16, 64, 1024}) {
        // Every box at a corner of the pixel holds its share of the samples, up to little more than their
        // discrepancy.
        double worst = 0;
        for (double x = -0.5; x <= 0.5; x += 0.0625)
            for (double y = -0.5; y <= 0.5; y += 0.0625) {
                int inside = 0;
                for (int s = 0; s < samples; ++s) {
                    const glm::dvec2 at = sample_place(s, samples);
                    inside += at.x < x && at.y < y ? 1 : 0;
                }
                worst = std::max(worst, std::abs(inside / double{1} / samples - (x + 0.5) * (y + 0.5)));
            }
        CHECK(worst < (1 + std::log2(samples)) / samples);
    }
}

IMAGE_TEST_CASE("a number that is not drawn together is the mean of images of a jittered camera") {
    Studio render(context, 40, 40);
    const Scene scene = sphere_on_plate();
    for (const ShadeAt where : kPlaces) {
        constexpr int samples = 5;
        StokesImage expected(render.width, render.height, scene.channels());
        Camera camera = test::some_camera();
        for (int s = 0; s < samples; ++s) {
            // Both offsets point to the right and down.
            camera.jitter = sample_place(s, samples);
            const StokesImage image = render(scene, with(1, where), camera);
            for (std::size_t i = 0; i < expected.data.size(); ++i)
                expected.data[i] += image.data[i] / samples;
        }
        const StokesImage image = render(scene, with(samples, where), test::some_camera());
        CHECK(rms(minus(image, expected)) < 1e-6 * rms(expected));
        CHECK(rms(minus(image, render(scene, with(1, where), test::some_camera()))) > 1e-3 * rms(expected));
    }
}

IMAGE_TEST_CASE("a straight edge covers a pixel to half a sample") {
    Studio render(context, 8, 8);
    Camera camera;
    camera.orthographic = true;
    camera.to_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    for (const ShadeAt where : kPlaces)
        for (const int samples : {4, 8})
            for (const bool upright : {true, false})
                for (const double fraction : {0.03, 0.2, 0.4, 0.55, 0.7, 0.95}) {
                    CAPTURES(where, samples, upright, fraction);
                    Scene scene;
                    // Pixels are 0.25 wide. One half of the image and a fraction of the next pixel are black.
                    const double over = 0.25 * fraction - 2;
                    scene.add({.mesh = test::rectangle(1),
                               .material = diffuse({0.0}),
                               .to_world = test::at(upright ? over : 0, upright ? 0 : -over, 0, 2)});
                    scene.set_environment(falling_light(0, false, 1), glm::dmat3(1), 1);
                    const StokesImage image = render(scene, with(samples, where), camera);
                    const float bright = image.at(0, 7, 7)[0];
                    CHECK(bright > 0);
                    for (int i = 0; i < 8; ++i) {
                        const float at_edge = upright ? image.at(0, i, 4)[0] : image.at(0, 4, i)[0];
                        CHECK(std::abs(static_cast<double>(1 - at_edge / bright) - fraction) <=
                              0.5 / samples + 1e-5);
                        CHECK((upright ? image.at(0, i, 3)[0] : image.at(0, 3, i)[0]) == 0);
                        CHECK((upright ? image.at(0, i, 5)[0] : image.at(0, 5, i)[0]) ==
                              doctest::Approx(bright));
                    }
                }
}

IMAGE_TEST_CASE("outlines are as of 64 images of a jittered camera, the closer the more samples") {
    Studio render(context);
    const Scene scene = sphere_on_plate();
    for (const ShadeAt where : kPlaces) {
        CAPTURES(where);
        const StokesImage expected = mean_of_jittered(render, scene, with(1, where), 8);
        const auto error = [&](int samples) {
            return rms(minus(render(scene, with(samples, where)), expected));
        };
        const double one = error(1);
        // Straight edges in all directions would give 0.377 and 0.235.
        CHECK(error(4) < 0.42 * one);
        CHECK(error(8) < 0.26 * one);
    }
}

IMAGE_TEST_CASE("pixels that show several facets of a mesh reflect a lamp from each of them") {
    Studio render(context);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(16),
               .material = pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.2})});
    scene.add_light({.kind = LocalLight::Kind::directional,
                     .value = {3},
                     .to_world = look_at({0.3, 0.9, -0.5}, {0, 0, 0}, {0, 0, 1})});
    scene.set_environment(falling_light(0, false, 1), glm::dmat3(1), 0.01);
    StokesImage expected(render.width, render.height, scene.channels());
    Camera camera = test::some_camera();
    for (const glm::dvec2& at : sample_pattern(8)) {
        camera.jitter = at;
        const StokesImage image = render(scene, with(1, ShadeAt::pixels), camera);
        for (std::size_t i = 0; i < expected.data.size(); ++i) expected.data[i] += image.data[i] / 8;
    }
    const StokesImage image = render(scene, with(8, ShadeAt::pixels));
    CAPTURE(rms(minus(image, expected)));
    CHECK(rms(minus(image, expected)) < 0.01 * rms(expected));
}

IMAGE_TEST_CASE("what has no edges is as with one sample, and the environment is not blurred") {
    Studio render(context);
    for (const ShadeAt where : kPlaces)
        for (const bool surface : {true, false}) {
            CAPTURES(where, surface);
            Scene scene;
            if (surface)
                scene.add({.mesh = test::rectangle(9),
                           .material = diffuse({0.5}),
                           .to_world = test::at(0, 0, 0, 9)});
            scene.set_environment(falling_light(9, true, 3), glm::dmat3(1), 1);
            const Camera camera = test::camera_at({0.5, 0.3, 4});
            const StokesImage one = render(scene, with(1, where), camera);
            CHECK(rms(one) > 0);
            for (const int samples : {4, 8})
                CHECK(rms(minus(render(scene, with(samples, where), camera), one)) < 1e-5 * rms(one));
        }
}

IMAGE_TEST_CASE("the mean of 16 images of a jittered camera is an image of four times the size, averaged") {
    const Scene scene = sphere_on_plate();
    Studio small(context, 32, 24);
    Studio large(context, 128, 96);
    for (RenderOptions options : {with(1, ShadeAt::vertices), with(1, ShadeAt::pixels)}) {
        // By default a first image refines down to two of its pixels alone.
        options.disabled_optimisations = skip_rays;
        const StokesImage mean = mean_of_jittered(small, scene, options, 4);
        const StokesImage fine = large(scene, options);
        StokesImage reduced(32, 24, 3);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < 96; ++y)
                for (int x = 0; x < 128; ++x)
                    for (std::size_t p = 0; p < 4; ++p)
                        reduced.at(c, y / 4, x / 4)[p] += fine.at(c, y, x)[p] / 16;
        CHECK(rms(minus(mean, reduced)) < 1e-3 * rms(mean));
    }
}

IMAGE_TEST_CASE("AOVs are of the nearest sample, normals their mean and alpha the fraction with a surface") {
    const Scene scene = sphere_on_plate();
    Studio studio(context);
    RenderOptions options = with(1, ShadeAt::vertices);
    const auto aovs_of = [&](const Camera& camera, std::uint32_t mask) {
        options.aovs = mask;
        Framebuffer target(context, 64, 48, 3);
        studio.renderer.render(scene, camera, options, target);
        CHECK(target.aovs().mask() == mask);
        return target.aovs();
    };
    constexpr std::uint32_t all = aov_depth | aov_instances | aov_normals | aov_positions | aov_alpha;
    Aovs expected(64, 48, all);
    Camera camera = test::some_camera();
    for (const glm::dvec2& at : sample_pattern(4)) {
        camera.jitter = at;
        const Aovs sample = aovs_of(camera, all);
        for (std::size_t p = 0; p < expected.depth.size(); ++p) {
            expected.alpha[p] += sample.alpha[p] / 4;
            for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) expected.normals[i] += sample.normals[i];
            if (!(sample.depth[p] < expected.depth[p])) continue;
            expected.depth[p] = sample.depth[p];
            expected.instances[p] = sample.instances[p];
        }
    }
    options.pixel_samples = 4;
    const Aovs aovs = aovs_of(test::some_camera(), all);
    const Viewpoint view = project(test::some_camera(), 64, 48).view;
    CHECK(aovs.instances == expected.instances);
    CHECK(aovs.alpha == expected.alpha);
    CHECK(std::ranges::count_if(aovs.alpha, [](float a) { return a > 0 && a < 1; }) > 50);
    for (std::size_t p = 0; p < expected.depth.size(); ++p) {
        if (aovs.instances[p] == kNoInstance) {
            CHECK(glm::make_vec3(&aovs.normals[3 * p]) == glm::vec3(0));
            continue;
        }
        CHECK(aovs.depth[p] == doctest::Approx(expected.depth[p]).epsilon(1e-6));
        const glm::dvec3 position = glm::make_vec3(&aovs.positions[3 * p]);
        CHECK(glm::dot(position - view.eye, view.forward) == doctest::Approx(aovs.depth[p]));
        const glm::vec3 mean = glm::normalize(glm::make_vec3(&expected.normals[3 * p]));
        CHECK(glm::distance(glm::make_vec3(&aovs.normals[3 * p]), mean) < 1e-5F);
    }
    // Each plane is also correct alone, without the depth that selects the nearest sample.
    CHECK(aovs_of(test::some_camera(), aov_instances).instances == aovs.instances);
    CHECK(aovs_of(test::some_camera(), aov_positions).positions == aovs.positions);
    CHECK(aovs_of(test::some_camera(), aov_normals).normals == aovs.normals);
    CHECK(aovs_of(test::some_camera(), aov_alpha).alpha == aovs.alpha);
}

IMAGE_TEST_CASE("samples add work at outlines alone where pixels are shaded, and physical stays physical") {
    Studio render(context);
    const Scene scene = sphere_on_plate();
    render(scene, with(1, ShadeAt::pixels));
    const auto one = static_cast<double>(render.statistics.pixels_shaded);
    for (const ShadeAt where : kPlaces) {
        RenderOptions options = with(4, where);
        options.physical = true;
        const StokesImage image = render(scene, options);
        for (std::size_t i = 0; i < image.data.size(); i += 4) {
            const double s0 = static_cast<double>(image.data[i]);
            const glm::dvec3 polarized(image.data[i + 1], image.data[i + 2], image.data[i + 3]);
            CHECK(glm::length(polarized) <= s0 * (1 + 1e-5));
        }
    }
    CHECK(static_cast<double>(render.statistics.pixels_shaded) < 1.4 * one);
}

IMAGE_TEST_CASE("an image of several samples is that of a fresh start, whatever was rendered before") {
    Studio render(context);
    const Scene scene = sphere_on_plate();
    for (const ShadeAt where : kPlaces)
        for (const int samples : {4, 1, 8}) {
            CAPTURES(where, samples);
            RenderOptions options = with(samples, where);
            options.components = samples == 8 ? 1 : 4;
            // By default a first image refines what it shows alone.
            options.disabled_optimisations = skip_rays;
            const StokesImage image = render(scene, options);
            CHECK(rms(minus(image, Studio(context)(scene, options))) < 1e-5 * rms(image));
            if (options.components == 1) CHECK(image.at(0, 24, 32)[1] == 0);
        }
}

IMAGE_TEST_CASE("other numbers of samples are refused") {
    Studio render(context);
    for (const int samples : {0, -4, 1025})
        check_error(ErrorCode::invalid_argument,
                    CALL(render(sphere_on_plate(), with(samples, ShadeAt::vertices))), "pixel_samples",
                    "1 to 1024");
}

IMAGE_TEST_CASE("where nothing else asks for pixels, threads shade several samples there, which costs less") {
    for (const Executor executor : {Executor::cpu, Executor::compute}) {
        for (const int samples : {1, 4}) {
            CAPTURES(executor == Executor::cpu, samples);
            Studio render(context, 20, 16);
            RenderOptions options = with(samples, ShadeAt::automatic);
            options.executor = executor;
            options.tolerance = 1;
            render(sphere_on_plate(), options);
            const bool pixels = render.statistics.pixels_shaded > 0;
            CHECK(pixels == (samples > 1 && executor == Executor::cpu));
        }
    }
}
