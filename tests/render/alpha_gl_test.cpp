// SPDX-License-Identifier: MIT
// Tests of coverage: black surfaces remove the uniform light that they cover.
#include <algorithm>

#include "gl/contexts.hpp"
#include "render/scenes.hpp"

using namespace nicol;

namespace {

constexpr int kSide = 32;

/// Returns a black ball and a plate that shows its back.
Scene black_scene() {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(8), .material = diffuse({0.0})});
    const glm::dmat4 turned =
        test::at(1.2, 0.4, 0.7) * glm::rotate(glm::dmat4(1), glm::radians(170.0), glm::dvec3(0, 1, 0));
    scene.add({.mesh = test::rectangle(2), .material = diffuse({0.0}), .to_world = turned});
    return scene;
}

std::vector<RenderOptions> ways() {
    std::vector<RenderOptions> all;
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels})
        for (const int samples : {1, 4, 8})
            all.push_back({.bake_directions = 256, .shade_at = where, .pixel_samples = samples});
    for (const int samples : {1, 9}) all.push_back({.method = Method::reference, .samples = samples});
    for (RenderOptions& options : all) {
        options.aovs = aov_alpha;
        options.refine_tolerance = 0;  // nothing is baked in darkness, so triangles would not be split
    }
    return all;
}

}  // namespace

IMAGE_TEST_CASE("what black surfaces leave of an even light is one minus alpha, by every method") {
    Renderer renderer(context);
    Framebuffer target(context, kSide, kSide, 1);
    Scene scene = black_scene();
    scene.set_environment(test::falling_light(0, false, 1), glm::dmat3(1), 1);
    for (const RenderOptions& options : ways()) {
        CAPTURES(options.method, options.shade_at, options.pixel_samples, options.samples);
        renderer.render(scene, test::camera_at({0, 0, 5}), options, target);
        const float light = target.image().at(0, 0, 0)[0];
        REQUIRE(light > 0);
        int partly = 0;
        for (std::size_t p = 0; p < std::size_t{kSide} * kSide; ++p) {
            const float alpha = target.aovs().alpha[p];
            CHECK(target.image().data[4 * p] == doctest::Approx(light * (1 - alpha)).epsilon(1e-5));
            if (alpha > 0 && alpha < 1) ++partly;
        }
        const bool reference = options.method == Method::reference;
        const int samples = reference ? options.samples : options.pixel_samples;
        CHECK((partly > 10) == (samples > 1));
        if (samples == 1) CHECK(partly == 0);
    }
}

IMAGE_TEST_CASE("hidden emitters light the scene, and leave the camera what surfaces reflect") {
    Renderer renderer(context);
    for (const RenderOptions& options : ways()) {
        CAPTURES(options.method, options.shade_at, options.pixel_samples, options.samples);
        Scene scene = black_scene();
        scene.set_material(0, diffuse({0.5}));
        scene.set_environment(test::falling_light(0, false, 1), glm::dmat3(1), 1);
        Framebuffer seen(context, kSide, kSide, 1);
        renderer.render(scene, test::camera_at({0, 0, 5}), options, seen);
        // The plate is black but emits light.
        scene.set_emission(1,
                           std::make_shared<const Emission>(Emission{.radiance = {3.0}, .two_sided = true}));
        scene.hide_emitters(true);
        Framebuffer hidden(context, kSide, kSide, 1);
        renderer.render(scene, test::camera_at({0, 0, 5}), options, hidden);
        double most = 0;
        int of_plate = 0;
        for (std::size_t p = 0; p < std::size_t{kSide} * kSide; ++p) {
            const float s0 = hidden.image().data[4 * p];
            const float alpha = hidden.aovs().alpha[p];
            if (alpha == 0) CHECK(s0 == 0);
            if (alpha == 1 && s0 == 0) ++of_plate;
            most = std::max(most, double{s0});
        }
        CHECK(of_plate > 10);
        CHECK(most > 0.3 * seen.image().at(0, 0, 0)[0]);
        CHECK(hidden.image().at(0, 0, 0)[0] == 0);
        CHECK(seen.image().at(0, 0, 0)[0] > 0);
    }
}

IMAGE_TEST_CASE("alpha is the same in darkness") {
    Renderer renderer(context);
    for (const RenderOptions& options : ways()) {
        CAPTURES(options.method, options.shade_at, options.pixel_samples, options.samples);
        Scene scene = black_scene();
        Framebuffer dark(context, kSide, kSide, 1);
        renderer.render(scene, test::camera_at({0, 0, 5}), options, dark);
        CHECK(std::ranges::max(dark.aovs().alpha) == 1);
        CHECK(std::ranges::min(dark.aovs().alpha) == 0);
        scene.set_environment(test::falling_light(0, false, 1), glm::dmat3(1), 1);
        Framebuffer lit(context, kSide, kSide, 1);
        renderer.render(scene, test::camera_at({0, 0, 5}), options, lit);
        CHECK(dark.aovs().alpha == lit.aovs().alpha);
    }
}
