// SPDX-License-Identifier: MIT
// Tests that a pixel is the mean over what it shows, also of highlights and textures that are finer.
#include <glm/geometric.hpp>
#include <utility>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::minus;
using test::rms;
using test::Studio;

namespace {

RenderOptions with(int samples) {
    return {
        .executor = Executor::cpu, .shadows = false, .shade_at = ShadeAt::pixels, .pixel_samples = samples};
}

}  // namespace

IMAGE_TEST_CASE("highlights smaller than a pixel are as bright as by the reference method") {
    struct Case {
        const char* what;
        std::shared_ptr<const Mesh> mesh;
        MaterialPtr material;
        LocalLight light;
    };
    // Normals that turn by half a radian within a few pixels.
    const TexturePtr waves = test::texture_of([](const TexturePoint& p) {
        return glm::vec4(0.5F + 0.25F * std::sin(12 * p.uv.x), 0.5F + 0.25F * std::cos(12 * p.uv.y), 0.9F, 1);
    });
    const auto ball = test::with_texcoords(make_sphere()), square = test::with_texcoords(make_rectangle(1));
    const LocalLight sun{.kind = LocalLight::Kind::directional,
                         .value = {3},
                         .to_world = look_at({1, 2, 3}, glm::dvec3(0), {0.1, 1, 0.2}),
                         .angular_radius = 0.005};
    const LocalLight point{.value = {30}, .to_world = test::at(1, 2, 3)};
    const MaterialPtr metal = test::some_metal(0.02);
    const MaterialPtr brushed = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.1, .alpha_v = 0.02});
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.02});
    Studio render(context, 40, 40);
    for (const Case& one :
         {Case{"point, metal", ball, metal, point},
          {"sun, metal", ball, metal, sun},
          {"point, brushed", ball, brushed, point},
          {"sun, plastic", ball, plastic, sun},
          {"point, normal map", square, normal_mapped(test::some_metal(0.05), waves), point},
          {"sun, normal map", square, normal_mapped(brushed, waves), sun}}) {
        Scene scene;
        scene.add({.mesh = one.mesh, .material = one.material});
        scene.add_light(one.light);
        RenderOptions rays = with(1);
        rays.method = Method::reference;
        rays.samples = 1024;
        const StokesImage expected = render(scene, rays);
        for (const int samples : {1, 8}) {
            CAPTURES(std::string(one.what), samples);
            CHECK(rms(minus(render(scene, with(samples)), expected)) < 0.18 * rms(expected));
        }
    }
}

IMAGE_TEST_CASE("grooves that mirror a light are as bright as by the reference method") {
    // Slopes of 0.6 radians, less than a pixel wide.
    const TexturePtr grooves = test::texture_of([](const TexturePoint& p) {
        const float across = p.uv.y - std::floor(p.uv.y * 6) / 6;
        const float slope = across > 0.04F ? 0.0F : across > 0.02F ? 0.6F : -0.6F;
        return glm::vec4(0.5F, 0.5F + 0.5F * slope, 0.5F + 0.5F * std::sqrt(1 - slope * slope), 1);
    });
    Studio render(context, 40, 40);
    Scene scene;
    scene.add({.mesh = test::with_texcoords(make_rectangle(1)),
               .material = normal_mapped(test::some_metal(0.1), grooves)});
    scene.add_light({.kind = LocalLight::Kind::directional,
                     .value = {3},
                     .to_world = look_at({0.5, 1, 0.6}, glm::dvec3(0), {0.1, 1, 0.2})});
    RenderOptions rays = with(1);
    rays.method = Method::reference;
    rays.samples = 4096;
    const StokesImage expected = render(scene, rays);
    for (const auto& [samples, limit] : {std::pair(8, 0.15), {64, 0.1}}) {
        CAPTURE(samples);
        CHECK(rms(minus(render(scene, with(samples)), expected)) < limit * rms(expected));
    }
}

IMAGE_TEST_CASE("samples that are shaded one by one do not blur textures beyond the pixel") {
    // The border of two squares is that of the columns 7 and 8 of the image.
    Studio render(context, 16, 16);
    Scene scene;
    scene.add(
        {.mesh = test::with_texcoords(make_rectangle(1)),
         .material = scaled(diffuse({1.0}), checkerboard_texture(glm::vec3(0.2F), glm::vec3(0.8F), 1))});
    scene.set_environment(constant_environment({1.0}), glm::dmat3(1), 1);
    Camera camera = test::camera_at({0, 0, 3});
    camera.orthographic = true;
    const StokesImage image = render(scene, with(64), camera);
    const float contrast = image.at(0, 3, 12)[0] - image.at(0, 3, 3)[0];
    CHECK(std::abs(contrast) > 0.1F);
    // 4 of the 64 samples lie within half a sample's width of the border.
    CHECK(std::abs(image.at(0, 3, 7)[0] - image.at(0, 3, 3)[0]) < 0.01F * std::abs(contrast));
    CHECK(std::abs(image.at(0, 3, 8)[0] - image.at(0, 3, 12)[0]) < 0.01F * std::abs(contrast));
}

IMAGE_TEST_CASE("the edge of a hard shadow hides a fraction of a pixel") {
    Studio render(context, 40, 40);
    Scene scene;
    scene.add({.mesh = test::rectangle(1), .material = diffuse({0.6}), .to_world = test::plate_at(-1, 3)});
    scene.add({.mesh = test::rectangle(1),
               .material = diffuse({0.1}),
               .to_world = test::plate_at(0, 0.7) * glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 0, 1))});
    scene.add_light({.value = {30}, .to_world = test::at(1, 3, 1)});
    RenderOptions rays = with(1);
    rays.method = Method::reference;
    rays.shadows = true;
    rays.samples = 1024;
    const StokesImage expected = render(scene, rays);
    RenderOptions options = with(8);
    options.shadows = true;
    CHECK(rms(minus(render(scene, options), expected)) < 0.02 * rms(expected));
}
