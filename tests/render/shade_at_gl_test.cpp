// SPDX-License-Identifier: MIT
// Tests of shading at pixels.
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::falling_light;
using test::minus;
using test::rms;
using test::Studio;

namespace {

RenderOptions at(ShadeAt where, Executor executor = Executor::cpu) {
    return {
        .executor = executor, .bake_directions = 1024, .order_low = 4, .order_high = 9, .shade_at = where};
}

/// Returns a metal sphere over a two-sided plastic plate.
Scene sphere_on_plate(const EnvironmentPtr& light, const std::shared_ptr<const Mesh>& sphere, int cells) {
    static const MaterialPtr plastic = twosided(pplastic({.diffuse_reflectance = {0.4}, .alpha = 0.3}));
    Scene scene;
    scene.add({.mesh = sphere, .material = test::some_metal(0.3)});
    scene.add({.mesh = test::rectangle(cells), .material = plastic, .to_world = test::plate_at(-1, 3)});
    scene.set_environment(light, theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))), 0.7);
    return scene;
}

/// Splits each triangle into four in the same plane, with normals as shading interpolates them.
Mesh split(const Mesh& mesh) {
    Mesh out = mesh;
    out.triangles.clear();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, added] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(out.positions.size()));
        if (added) {
            out.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5F);
            out.normals.push_back(glm::normalize(mesh.normals[a] + mesh.normals[b]));
        }
        return found->second;
    };
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
        for (const glm::uvec3& part :
             {glm::uvec3(t.x, m.x, m.z), glm::uvec3(m.x, t.y, m.y), glm::uvec3(m.z, m.y, t.z), glm::uvec3(m)})
            out.triangles.push_back(part);
    }
    return out;
}

void check_changes(const std::shared_ptr<gl::Context>& context, Executor executor) {
    const EnvironmentPtr light = falling_light(9, false, 3);
    Scene scene = sphere_on_plate(light, test::coarse_sphere(6), 8);
    Studio render(context);
    const auto as_fresh = [&](const RenderOptions& options, const Camera& camera) {
        const StokesImage image = render(scene, options, camera);
        RenderOptions fresh = options;
        fresh.executor = Executor::cpu;  // starts faster
        CHECK(rms(minus(image, Studio(context)(scene, fresh, camera))) <
              gl::tolerance_of(context) * 1e-5 * rms(image));
    };
    RenderOptions pixels = at(ShadeAt::pixels, executor);
    RenderOptions vertices = at(ShadeAt::vertices, executor);
    // By default vertices keep their light if a move hides almost nothing more from them.
    pixels.disabled_optimisations = vertices.disabled_optimisations = skip_rays;
    Camera other = test::some_camera();
    other.fov = 25;
    as_fresh(pixels, test::some_camera());
    as_fresh(vertices, test::some_camera());
    as_fresh(pixels, other);
    scene.set_environment(light, scene.light_rotation() * theta_phi_frame(glm::dvec3(0, 0.6, 0.8)), 0.5);
    as_fresh(pixels, other);
    as_fresh(vertices, other);
    scene.set_transform(scene.ids().front(), test::at(0.2, 0.1, 0));
    as_fresh(pixels, other);
    pixels.method = Method::dense;
    as_fresh(pixels, other);
    pixels.shadows = false;
    pixels.method = Method::factored;
    as_fresh(pixels, other);
    pixels.components = 1;
    as_fresh(pixels, other);
    pixels.physical = true;
    as_fresh(pixels, other);
}

void check_backs(const std::shared_ptr<gl::Context>& context, Executor executor) {
    Studio render(context);
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.5}), .to_world = test::at(0, 0, 0, 20)});
    scene.set_environment(falling_light(4, false, 1), glm::dmat3(1), 1);
    const StokesImage inside = render(scene, at(ShadeAt::pixels, executor));
    CHECK(rms(inside) == 0);
    CHECK(render.statistics.pixels_shaded == 0);

    Scene sides;
    sides.add({.mesh = test::rectangle(1), .material = twosided(diffuse({0.5}))});
    sides.set_environment(falling_light(4, false, 1), glm::dmat3(1), 1);
    for (const double z : {4.0, -4.0}) {
        const Camera camera = test::camera_at({0, 0, z});
        RenderOptions options = at(ShadeAt::pixels, executor);
        const StokesImage image = render(sides, options, camera);
        options.shade_at = ShadeAt::vertices;
        CHECK(rms(minus(image, render(sides, options, camera))) < 1e-5 * rms(image));
        CHECK(image.at(0, 24, 32)[0] > 0);
    }
}

}  // namespace

IMAGE_TEST_CASE("where vertices are dense, pixels make what they make") {
    Studio render(context);
    struct Case {
        int channels;
        bool polarized;
        Method method;
        HighOrders form;
        bool shadows;
        bool orthographic;
        double least;  // upper limit of the relative difference
    };
    for (const Case& one : {Case{1, true, Method::factored, HighOrders::none, false, false, 2e-3},
                            {3, false, Method::factored, HighOrders::none, true, false, 2e-3},
                            {6, true, Method::factored, HighOrders::split, true, true, 3e-3},
                            {3, true, Method::factored, HighOrders::convolution, false, false, 2e-3},
                            {3, true, Method::dense, HighOrders::none, true, true, 1e-3}}) {
        CAPTURES(one.channels, one.polarized, one.form, one.method, one.shadows, one.orthographic);
        const Scene scene =
            sphere_on_plate(falling_light(9, one.polarized, one.channels), test::coarse_sphere(24), 32);
        RenderOptions options = at(ShadeAt::pixels);
        options.method = one.method;
        options.high_orders = one.form;
        options.shadows = one.shadows;
        Camera camera = test::some_camera();
        camera.orthographic = one.orthographic;
        if (one.orthographic) camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(1.7));
        const StokesImage pixels = render(scene, options, camera);
        CHECK(render.statistics.pixels_shaded > 500);
        CHECK(render.statistics.vertices_shaded == 0);
        options.shade_at = ShadeAt::vertices;
        const StokesImage vertices = render(scene, options, camera);
        CHECK(render.statistics.pixels_shaded == 0);
        const double difference = rms(minus(pixels, vertices)) / rms(vertices);
        CHECK(difference < one.least);
        CHECK(difference > 0);
    }
}

IMAGE_TEST_CASE("threads interpolate between vertices as the device does") {
    Studio threads(context), device(context);
    // A plate that is seen from behind, and triangles of many pixels.
    Scene scene = sphere_on_plate(falling_light(9, true, 6), test::coarse_sphere(8), 2);
    scene.add(
        {.mesh = test::rectangle(2),
         .material = diffuse({0.5}),
         .to_world = test::at(-1.2, 0, 0.3, 0.4) * glm::rotate(glm::dmat4(1), 2.8, glm::dvec3(0, 1, 0))});
    for (const auto& [samples, components, orthographic] :
         {std::tuple{1, 4, false}, {1, 1, false}, {4, 4, false}, {1, 4, true}}) {
        CAPTURES(samples, components, orthographic);
        Camera camera = test::some_camera();
        camera.orthographic = orthographic;
        if (orthographic) camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(1.7));
        RenderOptions options = at(ShadeAt::vertices);
        options.components = components;
        options.pixel_samples = samples;
        const StokesImage image = threads(scene, options, camera);
        CHECK(threads.statistics.pixels_shaded == 0);
        options.executor = Executor::compute;
        CHECK(rms(minus(image, device(scene, options, camera))) <
              gl::tolerance_of(context) * 3e-5 * rms(image));
    }
}

IMAGE_TEST_CASE("at pixels a coarse mesh looks as its triangles split in sixteen do") {
    Studio render(context);
    const auto coarse = test::coarse_sphere(4);
    const auto fine = std::make_shared<const Mesh>(split(split(*coarse)));
    const EnvironmentPtr light = falling_light(9, true, 3);
    for (const bool shadows : {false, true})
        for (const HighOrders form : {HighOrders::none, HighOrders::split, HighOrders::convolution}) {
            CAPTURES(shadows, form);
            RenderOptions options = at(ShadeAt::vertices);
            options.high_orders = form;
            options.shadows = shadows;
            const StokesImage expected = render(sphere_on_plate(light, fine, 48), options);
            const Scene scene = sphere_on_plate(light, coarse, 48);
            const double vertices = rms(minus(render(scene, options), expected));
            options.shade_at = ShadeAt::pixels;
            const double pixels = rms(minus(render(scene, options), expected));
            CHECK(pixels < (shadows ? 0.4 : 0.2) * vertices);
            CHECK(pixels < 0.02 * rms(expected));
        }
}

IMAGE_TEST_CASE("what vertices miss is predicted, and decides where light becomes a Stokes vector") {
    Studio render(context);
    const EnvironmentPtr light = falling_light(16, false);
    const double glossy = 0.12, matt = 0.5;
    const auto ball = [&](int cells, const MaterialPtr& material) {
        Scene scene;
        scene.add({.mesh = test::coarse_sphere(cells), .material = material});
        scene.set_environment(light, theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))), 0.7);
        return scene;
    };
    for (const int cells : {4, 8, 24}) {
        for (const MaterialPtr& material :
             {test::some_metal(glossy), test::some_metal(matt), diffuse({0.5}),
              pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.2, .distribution = Distribution::ggx})}) {
            CAPTURES(cells, material->content_key());
            const Scene scene = ball(cells, material);
            const StokesImage background = render(ball(cells, diffuse({0.0})), at(ShadeAt::vertices));
            const auto without_background = [&](StokesImage image) {
                for (std::size_t i = 0; i < image.data.size(); ++i)
                    if (background.data[i - i % 4] != 0) image.data[i] = 0;
                return image;
            };
            RenderOptions options{.executor = Executor::cpu, .tolerance = 0.03};
            options.shade_at = ShadeAt::vertices;
            const StokesImage vertices = render(scene, options);
            const double predicted = render.statistics.interpolation_error;
            CHECK(render.statistics.predicted_error >= predicted);
            options.shade_at = ShadeAt::pixels;
            const StokesImage pixels = render(scene, options);
            CHECK(render.statistics.interpolation_error == 0);
            const double measured = rms(minus(vertices, pixels)) / rms(without_background(pixels));
            CHECK(predicted > 0.5 * measured - 1e-3);
            CHECK(predicted < 2 * measured + 1e-3);
            options.shade_at = ShadeAt::automatic;
            const StokesImage automatic = render(scene, options);
            CHECK((render.statistics.pixels_shaded > 0) == (predicted > options.tolerance));
        }
    }
}

IMAGE_TEST_CASE("shadows dim high orders at pixels as they dim them at vertices") {
    Studio render(context);
    const Scene scene = sphere_on_plate(falling_light(9, false), test::coarse_sphere(23), 40);
    // Returns the contribution of the high orders, with or without shadows.
    const auto high = [&](ShadeAt where, bool shadows) {
        RenderOptions options = at(where);
        options.shadows = shadows;
        const StokesImage all = render(scene, options);
        options.high_orders = HighOrders::none;
        return minus(all, render(scene, options));
    };
    const StokesImage shadowed = high(ShadeAt::pixels, true);
    const StokesImage plain = high(ShadeAt::pixels, false);
    const StokesImage shadow = minus(plain, shadowed);
    const StokesImage at_vertices = minus(high(ShadeAt::vertices, false), high(ShadeAt::vertices, true));
    CHECK(rms(shadow) > 0.2 * rms(plain));
    CHECK(rms(minus(shadow, at_vertices)) < 0.1 * rms(shadow));
    // A visible fraction only reduces light.
    const double most = largest(plain);
    for (std::size_t i = 0; i < plain.data.size(); i += 4) {
        REQUIRE(std::abs(shadowed.data[i]) <= std::abs(plain.data[i]) + 0.02 * most);
    }
}

IMAGE_TEST_CASE("the physically realizable range is that of the sum of all orders, at pixels") {
    Studio render(context);
    const Scene scene = sphere_on_plate(test::lamp(), test::coarse_sphere(14), 4);
    const auto unphysical = [](const StokesImage& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.data.size(); i += 4) {
            const float* s = &image.data[i];
            count += s[0] < 0 || std::hypot(s[1], s[2], s[3]) > s[0] * 1.00001F + 1e-6F ? 1 : 0;
        }
        return count;
    };
    for (const Executor executor : {Executor::cpu, Executor::compute}) {
        RenderOptions options = at(ShadeAt::pixels, executor);
        options.split_lights = 0;
        const StokesImage plain = render(scene, options);
        CHECK(unphysical(plain) > 100);
        options.physical = true;
        const StokesImage physical = render(scene, options);
        CHECK(unphysical(physical) == 0);
        CHECK(render.statistics.vertices_unphysical == 0);
        // Physically realizable values stay unchanged.
        for (std::size_t i = 0; i < plain.data.size(); i += 4) {
            const float* s = &plain.data[i];
            if (s[0] < 0 || std::hypot(s[1], s[2], s[3]) > 0.999F * s[0]) continue;
            for (std::size_t p = 0; p < 4; ++p) REQUIRE(physical.data[i + p] == s[p]);
        }
    }
}

IMAGE_TEST_CASE("a render at pixels is that of a fresh start, whatever was rendered before") {
    for (const Executor executor : {Executor::cpu, Executor::compute}) check_changes(context, executor);
}

IMAGE_TEST_CASE("pixels of backs are black, and each side of a surface has its own light") {
    for (const Executor executor : {Executor::cpu, Executor::compute}) check_backs(context, executor);
}
