// SPDX-License-Identifier: MIT
// Tests of local lights and emissive surfaces against closed forms and the reference method.
#include <functional>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::minus;
using test::rms;
using test::Studio;

namespace {

RenderOptions options(ShadeAt shade_at, bool shadows = true) {
    return {.executor = Executor::cpu, .shadows = shadows, .bake_directions = 512, .shade_at = shade_at};
}

/// Returns the matrix of a light at `from` that shines towards the origin.
glm::dmat4 aimed(const glm::dvec3& from) {
    return look_at(from, glm::dvec3(0), {0.1, 1, 0.2});
}

PolarizationState some_state() {
    return {.dolp = 0.8, .aolp = 0.4, .docp = -0.5, .axis = {0.3, 1, 0.2}};
}

TexturePtr slope() {
    return test::texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 0.5F, 1); }, 3);
}

MaterialPtr plastic() {
    return pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.25});
}

/// Returns a ball over a floor.
Scene still(const MaterialPtr& ball = plastic()) {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(12), .material = ball, .to_world = test::at(0.2, 0.1, 0.1, 0.7)});
    scene.add({.mesh = test::rectangle(24), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 2)});
    return scene;
}

/// Adds a square panel of half side `half` at `from`, facing the origin.
void add_panel(Scene& scene, Emission emission, const glm::dvec3& from, double half) {
    static const auto mesh = test::with_texcoords(make_rectangle(1));
    scene.add({.mesh = mesh,
               .material = diffuse({0.0}),
               .to_world = aimed(from) * test::at(0, 0, 0, half),
               .emission = std::make_shared<const Emission>(std::move(emission))});
}

/// Averages squares of 4 x 4 pixels, because the reference method averages over pixels, too.
StokesImage reduced(const StokesImage& image) {
    StokesImage out(image.width / 4, image.height / 4, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (std::size_t p = 0; p < 4; ++p) out.at(c, y / 4, x / 4)[p] += image.at(c, y, x)[p] / 16;
    return out;
}

struct Case {
    const char* name;
    std::function<void(Scene&)> add;
};
const std::vector<Case>& cases() {
    static const glm::dvec3 above(1, 3, 1.5);
    static const std::vector<Case> all{
        {"directional",
         [](Scene& s) {
             s.add_light({.kind = LocalLight::Kind::directional,
                          .value = {3, 2, 1},
                          .to_world = aimed(above),
                          .state = some_state()});
         }},
        {"disc",
         [](Scene& s) {
             s.add_light({.kind = LocalLight::Kind::directional,
                          .value = {2},
                          .to_world = aimed(above),
                          .angular_radius = 0.2,
                          .state = some_state()});
         }},
        {"point",
         [](Scene& s) { s.add_light({.value = {20}, .to_world = aimed(above), .state = some_state()}); }},
        {"spot",
         [](Scene& s) {
             s.add_light({.kind = LocalLight::Kind::spot,
                          .value = {30},
                          .to_world = aimed(above),
                          .cutoff_angle = 0.35,
                          .beam_width = 0.2,
                          .texture = slope(),
                          .state = some_state()});
         }},
        {"projector",
         [](Scene& s) {
             s.add_light({.kind = LocalLight::Kind::projector,
                          .value = {30},
                          .to_world = aimed(above),
                          .texture = slope(),
                          .fov = 0.6,
                          .aspect = 1.5});
         }},
        {"panel",
         [](Scene& s) {
             add_panel(s, {.radiance = {9, 8, 7}, .state = some_state()}, above, 0.6);
         }},
        {"textured panel", [](Scene& s) { add_panel(s, {.radiance = {9}, .texture = slope()}, above, 0.6); }},
        {"sphere",
         [](Scene& s) {
             s.add({.mesh = test::coarse_sphere(4),
                    .material = diffuse({0.2}),
                    .to_world = test::at(1, 1.6, 1.2, 0.3),
                    .emission = std::make_shared<const Emission>(Emission{.radiance = {12}})});
         }},
    };
    return all;
}

}  // namespace

IMAGE_TEST_CASE("a directional light on a Lambertian sphere is its cosine") {
    const glm::dvec3 from = glm::normalize(glm::dvec3(2, 1, 3));
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.5})});
    scene.add_light({.kind = LocalLight::Kind::directional, .value = {3}, .to_world = aimed(from)});
    Renderer renderer(context);
    Framebuffer target(context, 96, 72, 1);
    RenderOptions with_normals = options(ShadeAt::pixels, false);
    with_normals.aovs = aov_normals | aov_positions | aov_instances;
    renderer.render(scene, test::some_camera(), with_normals, target);
    const StokesImage& image = target.image();
    int count = 0;
    int near = 0;
    for (std::size_t p = 0; p < target.aovs().instances.size(); ++p) {
        if (target.aovs().instances[p] == kNoInstance) continue;
        const float* n = &target.aovs().normals[3 * p];
        const float* at = &target.aovs().positions[3 * p];
        // Normals at the outline may face away from the viewer, and no front is visible there.
        const glm::dvec3 normal(n[0], n[1], n[2]);
        if (!(glm::dot(normal, glm::dvec3(2, 3, 4) - glm::dvec3(at[0], at[1], at[2])) > 1e-3)) continue;
        const double cosine = glm::dot(normal, from);
        const double expected = 3 * 0.5 / std::numbers::pi * std::max(0.0, cosine);
        const double got = image.at(0, static_cast<int>(p / 96), static_cast<int>(p % 96))[0];
        const double error = std::abs(got - expected);
        // Rasterisation places edges to 1/256 of a pixel, so a pixel may show the neighbouring triangle.
        CHECK(error < gl::tolerance_of(context) * 1e-3);
        if (error < gl::tolerance_of(context) * 1e-5) ++near;
        ++count;
    }
    CHECK(count > 1000);
    CHECK(near > (1 - 0.01 * gl::tolerance_of(context)) * count);
}

IMAGE_TEST_CASE("highlights of brushed metal follow texture coordinates, as by the reference method") {
    const auto lit = [](const Mesh& mesh, const glm::dmat4& to_world, double alpha_u, double alpha_v) {
        Scene scene;
        scene.add(
            {.mesh = std::make_shared<const Mesh>(mesh),
             .material = rough_conductor({.eta = metal_index("Au"), .alpha = alpha_u, .alpha_v = alpha_v}),
             .to_world = to_world});
        scene.add_light({.value = {40}, .to_world = aimed({1, 3, 1.5}), .state = some_state()});
        return scene;
    };
    Studio render(context, 96, 72);
    const auto by_rays = [&](const Scene& scene) {
        return render(scene, {.method = Method::reference, .samples = 16});
    };
    // The axes of the plate's texture coordinates are at right angles.
    const glm::dmat4 lying = test::plate_at(-0.5, 2);
    const Mesh along_x = *test::with_texcoords(make_rectangle(4));
    Mesh along_y = along_x;
    for (glm::vec2& uv : along_y.texcoords) uv = {uv.y, uv.x};
    const StokesImage plate = by_rays(lit(along_x, lying, 0.5, 0.15));
    CHECK(rms(plate) > 0.01);
    CHECK(rms(minus(by_rays(lit(along_y, lying, 0.15, 0.5)), plate)) < 1e-5 * rms(plate));
    CHECK(rms(minus(by_rays(lit(along_y, lying, 0.5, 0.15)), plate)) > 0.3 * rms(plate));
    CHECK(rms(minus(by_rays(lit(along_x, lying, std::sqrt(0.075), 0)), plate)) > 0.1 * rms(plate));

    const Scene ball = lit(*test::with_texcoords(make_sphere()), glm::dmat4(1), 0.5, 0.15);
    const StokesImage expected = by_rays(ball);
    const double size = rms(expected);
    CHECK(size > 0.01);
    Studio fine(context, 384, 288);
    for (const ShadeAt shade_at : {ShadeAt::pixels, ShadeAt::vertices}) {
        CAPTURE(shade_at == ShadeAt::pixels);
        const StokesImage image = reduced(fine(ball, options(shade_at)));
        CHECK(rms(minus(image, expected)) < 0.03 * size);
    }
    // Brushed metal also renders without texture coordinates.
    Scene plain;
    plain.add({.mesh = test::fine_sphere(), .material = rough_conductor({.alpha = 0.5, .alpha_v = 0.15})});
    plain.add_light({.value = {40}, .to_world = aimed({1, 3, 1.5})});
    CHECK(rms(render(plain, options(ShadeAt::pixels))) > 0.01);
}

IMAGE_TEST_CASE("local lights are those of the reference method") {
    for (const Case& light : cases()) {
        CAPTURE(light.name);
        for (const bool shadows : {true, false}) {
            Scene scene = still();
            light.add(scene);
            const RenderOptions reference{.method = Method::reference, .shadows = shadows, .samples = 256};
            Studio small(context);
            const StokesImage expected = small(scene, reference);
            const double size = rms(expected);
            CHECK(size > 0.01);
            Studio render(context, 256, 192);
            const double at_pixels =
                rms(minus(reduced(render(scene, options(ShadeAt::automatic, shadows))), expected)) / size;
            CHECK(at_pixels < 0.02);
            CHECK((render.statistics.light_rays > 0) == shadows);
            CHECK(render.statistics.local_lights == 1);
            CHECK(render.statistics.order == 0);
            if (scene.varies()) continue;
            const double at_vertices =
                rms(minus(reduced(render(scene, options(ShadeAt::vertices, shadows))), expected)) / size;
            // Edges of shadows and cones have the resolution of the vertices, 5 of which span the spot on the
            // floor.
            CHECK(at_vertices < (shadows ? 0.2 : 0.15));
        }
    }
}

IMAGE_TEST_CASE("local lights cast no rays where the bake found that nothing is occluded") {
    for (const ShadeAt shade_at : {ShadeAt::pixels, ShadeAt::vertices}) {
        CAPTURE(shade_at == ShadeAt::pixels);
        Scene alone;
        alone.add({.mesh = test::coarse_sphere(12), .material = plastic()});
        alone.set_environment(constant_environment({0.1}), glm::dmat3(1), 1);
        alone.add_light({.value = {20}, .to_world = aimed({1, 3, 1.5})});
        Studio render(context);
        const StokesImage image = render(alone, options(shade_at));
        CHECK(render.statistics.light_rays == 0);
        CHECK(render.statistics.bake_rays_skipped > 0);
        CHECK(rms(minus(image, render(alone, options(shade_at, false)))) == 0);

        Scene shadowed = alone;
        shadowed.add({.mesh = test::coarse_sphere(4),
                      .material = plastic(),
                      .to_world = test::at(0.6, 1.5, 0.8, 0.3)});
        const StokesImage unshadowed = render(shadowed, options(shade_at, false));
        CHECK(rms(minus(render(shadowed, options(shade_at)), unshadowed)) > 0.001);
        CHECK(render.statistics.light_rays > 0);
        // It was baked, then nothing is occluded any more.
        CHECK(rms(minus(render(alone, options(shade_at)), image)) < 1e-6);
        CHECK(render.statistics.light_rays == 0);
    }
}
