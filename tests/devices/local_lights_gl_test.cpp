// SPDX-License-Identifier: MIT
// Tests of local lights and emissive surfaces with compute shaders, against the images of threads.
#include "devices/both_executors.hpp"
#include "gl/contexts.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::BothExecutors;
using test::rms;
using test::rms_difference;

namespace {

glm::dmat4 aimed(const glm::dvec3& from) {
    return look_at(from, glm::dvec3(0), {0.1, 1, 0.2});
}

PolarizationState some_state() {
    return {.dolp = 0.8, .aolp = 0.4, .docp = -0.5, .axis = {0.3, 1, 0.2}};
}

TexturePtr slope(int channels) {
    return test::texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 0.5F, 1); },
                            channels);
}

LocalLight sun(const glm::dvec3& from) {
    return {
        .kind = LocalLight::Kind::directional, .value = {2}, .to_world = aimed(from), .state = some_state()};
}

LocalLight spot(int channels) {
    return {.kind = LocalLight::Kind::spot,
            .value = {30},
            .to_world = aimed({1, 3, 1.5}),
            .cutoff_angle = 0.35,
            .beam_width = 0.2,
            .texture = slope(channels)};
}

Instance panel(Emission emission, const glm::dvec3& from) {
    static const auto mesh = test::with_texcoords(make_rectangle(2));
    return {.mesh = mesh,
            .material = pplastic({.diffuse_reflectance = {0.3}}),
            .to_world = aimed(from) * test::at(0, 0, 0, 0.5),
            .emission = std::make_shared<const Emission>(std::move(emission))};
}

/// Returns a ball over a floor, which shadow each other and themselves.
Scene still(const MaterialPtr& ball, const MaterialPtr& floor) {
    static const auto round = test::with_texcoords(*test::coarse_sphere(6));
    static const auto flat = test::with_texcoords(make_rectangle(4));
    Scene scene;
    scene.add({.mesh = round, .material = ball, .to_world = test::at(0.2, 0.1, 0.1, 0.7)});
    scene.add({.mesh = flat, .material = floor, .to_world = test::plate_at(-1, 2)});
    return scene;
}
Scene plain_still() {
    return still(pplastic({.diffuse_reflectance = {0.6}, .alpha = 0.25}), test::some_metal(0.3));
}

}  // namespace

IMAGE_TEST_CASE("beside compute shaders local lights are what they are beside threads") {
    struct Row {
        Method method;
        ShadeAt shade_at;
        int channels;
        int samples;
        int components;
        bool shadows, physical;
    };
    constexpr auto factored = Method::factored, dense = Method::dense;
    constexpr auto vertices = ShadeAt::vertices, pixels = ShadeAt::pixels;
    const std::vector<Row> rows{
        {factored, vertices, 3, 1, 4, true, false}, {factored, vertices, 1, 4, 3, false, true},
        {dense, vertices, 1, 1, 4, true, false},    {factored, pixels, 3, 1, 4, true, true},
        {factored, pixels, 6, 4, 4, true, false},   {factored, pixels, 1, 8, 3, false, false},
        {dense, pixels, 3, 4, 1, true, false},      {factored, ShadeAt::automatic, 3, 1, 4, true, false}};
    for (const Row& row : rows) {
        CAPTURES(&row - rows.data());
        Scene scene = plain_still();
        scene.add_light(sun({1, 3, 1.5}));
        if (row.shade_at != vertices) scene.add_light(spot(row.channels == 6 ? 1 : row.channels));
        scene.add(panel({.radiance = std::vector<double>(static_cast<std::size_t>(row.channels), 3),
                         .state = some_state()},
                        {-0.5, 0.5, -1.5}));
        BothExecutors comparison(context, row.channels);
        RenderOptions options{.method = row.method,
                              .shadows = row.shadows,
                              .order_low = 3,
                              .order_high = row.method == dense ? 3 : 6,
                              .shade_at = row.shade_at,
                              .physical = row.physical,
                              .components = row.components,
                              .pixel_samples = row.samples};
        comparison.run(scene, options);
        CHECK((comparison.rays() > 0) == row.shadows);
        CHECK(comparison.rays() == comparison.by_threads.statistics().light_rays);
        scene.set_environment(test::falling_light(6, LightKind::full, row.channels), glm::dmat3(1), 0.3);
        comparison.run(scene, options);
    }
}

IMAGE_TEST_CASE("beside compute shaders local lights emit light on materials that vary") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3});
    const TexturePtr checks = checkerboard_texture(glm::vec3(0.9F, 0.2F, 0.1F), glm::vec3(0.1F, 0.3F, 0.8F),
                                                   3, glm::dmat3(7, 0, 0, 0, 5, 0, 0.2, -0.1, 1));
    const TexturePtr parts =
        image_texture({.width = 3, .height = 2, .channels = 1, .values = {0, 0.4F, 1, 0.7F, 0, 0.2F}});
    const TexturePtr bumps = image_texture(
        {.width = 2, .height = 1, .channels = 3, .values = {0.4F, 0.6F, 0.9F, 0.7F, 0.5F, 0.8F}});
    const struct {
        MaterialPtr ball;
        MaterialPtr floor;
    } rows[] = {{scaled(plastic, checks), blend(test::some_metal(0.2), plastic, parts)},
                {normal_mapped(plastic, bumps), twosided(scaled(plastic, checks))},
                {normal_mapped(test::some_metal(0.05), bumps), plastic}};
    for (const auto& row : rows) {
        Scene scene = still(row.ball, row.floor);
        scene.add_light(sun({1, 3, 1.5}));
        scene.add_light(spot(3));
        scene.add(panel({.radiance = {3}, .texture = slope(3)}, {-0.5, 0.5, -1.5}));
        BothExecutors comparison(context, 3);
        for (const int samples : {1, 4}) {
            comparison.run(
                scene,
                {.order_low = 3, .order_high = 6, .shade_at = ShadeAt::pixels, .pixel_samples = samples});
        }
    }
}

IMAGE_TEST_CASE("beside compute shaders local lights follow changes") {
    for (const ShadeAt shade_at : {ShadeAt::vertices, ShadeAt::pixels}) {
        CAPTURES(static_cast<int>(shade_at));
        BothExecutors comparison(context, 3);
        // By default a first image refines what it shows alone.
        const RenderOptions options{
            .order_low = 3, .order_high = 6, .shade_at = shade_at, .disabled_optimisations = skip_rays};
        Scene scene = plain_still();
        scene.set_environment(test::falling_light(6, LightKind::full, 3), glm::dmat3(1), 0.3);
        comparison.run(scene, options);
        const StokesImage unlit = comparison.by_shaders.image();
        const Statistics before = comparison.by_shaders.statistics();

        const std::uint32_t light = scene.add_light(sun({1, 3, 1.5}));
        comparison.run(scene, options);
        CHECK(rms_difference(unlit, comparison.by_shaders.image()) > 0.1 * rms(unlit));
        scene.set_light(light, sun({-2, 3, 1.5}));
        comparison.run(scene, options);
        scene.set_transform(0, test::at(-0.1, 0.3, 0.2, 0.6));
        comparison.run(scene, options);
        const std::uint32_t shining = scene.add(panel({.radiance = {3}}, {-0.5, 0.5, -1.5}));
        comparison.run(scene, options);
        scene.set_emission(shining, std::make_shared<const Emission>(Emission{.radiance = {1, 2, 3}}));
        comparison.run(scene, options);
        comparison.run(scene, options, test::camera_at({-1, 2, 4}));

        scene.remove(shining);
        scene.remove_light(light);
        scene.set_transform(0, test::at(0.2, 0.1, 0.1, 0.7));
        comparison.run(scene, options);
        CHECK(rms_difference(unlit, comparison.by_shaders.image()) <= 1e-6 * rms(unlit));
        const Statistics& after = comparison.by_shaders.statistics();
        CHECK(after.light_rays == 0);
        CHECK(after.texture_bytes == before.texture_bytes);
        CHECK(after.transfer_bytes == before.transfer_bytes);
    }
}

IMAGE_TEST_CASE("beside compute shaders lights of an environment are extracted") {
    EquirectImage room(64, 33, 3);
    for (int c = 0; c < 3; ++c) {
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 64; ++x) room.at(c, y, x)[0] = 1;
        room.at(c, 8, 20)[0] = 400;
        room.at(c, 12, 45)[0] = 300;
    }
    Scene scene = plain_still();
    scene.set_environment(image_environment(room), theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -1))),
                          0.7);
    BothExecutors comparison(context, 3);
    for (const ShadeAt shade_at : {ShadeAt::vertices, ShadeAt::pixels}) {
        comparison.run(scene, {.order_low = 3, .order_high = 6, .shade_at = shade_at});
        CHECK(comparison.by_shaders.statistics().lights_split == 2);
        CHECK(comparison.rays() > 0);
    }
}

IMAGE_TEST_CASE("the hits that threads read beside compute shaders are in the prediction of memory") {
    Scene scene = plain_still();
    BothExecutors comparison(context, 1);
    for (const int samples : {1, 4}) {
        CAPTURES(samples);
        const RenderOptions options{.executor = Executor::compute,
                                    .order_low = 2,
                                    .order_high = 2,
                                    .shade_at = ShadeAt::pixels,
                                    .pixel_samples = samples};
        const auto taken = [&] {
            comparison.shaders.render(scene, test::some_camera(), options, comparison.by_shaders);
            return comparison.by_shaders.statistics().transfer_bytes;
        };
        const auto predicted = [&] { return image_memory(scene, options, 40, 30); };
        const std::uint64_t taken_without = taken();
        const std::uint64_t predicted_without = predicted();
        const std::uint32_t light = scene.add_light(sun({1, 3, 1.5}));
        const auto hits = static_cast<std::uint64_t>(samples * 4 * 40 * 30);
        CHECK(taken() - taken_without == hits);
        CHECK(predicted() - predicted_without == hits);
        scene.remove_light(light);
        CHECK(taken() == taken_without);
    }
}

IMAGE_TEST_CASE("beside compute shaders sampled lobes are what they are beside threads") {
    EquirectImage image(64, 33, 3);
    for (std::size_t i = 0; i < image.data.size(); i += 4)
        image.data[i] = 1 + std::sin(static_cast<float>(i * i % 97));
    const MaterialPtr brushed = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.1, .alpha_v = 0.4});
    for (const ShadeAt place : {ShadeAt::vertices, ShadeAt::pixels}) {
        CAPTURE(static_cast<int>(place));
        Scene scene = still(brushed, pplastic({.alpha = 0.03}));
        scene.set_environment(image_environment(image), glm::dmat3(1), 1);
        BothExecutors both(context, 3);
        // Narrow lobes magnify what rounding moves at grazing angles.
        both.run(scene,
                 {.order_low = 4, .order_high = 4, .shade_at = place, .bsdf_samples = 8, .pixel_samples = 4},
                 test::some_camera(), true);
        CHECK(both.rays() > 0);
    }
}
