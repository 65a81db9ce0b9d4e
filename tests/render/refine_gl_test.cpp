// SPDX-License-Identifier: MIT
// Tests of triangles that the bake splits for shadows.
#include <limits>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::at;
using test::falling_light;
using test::Studio;

namespace {

RenderOptions options_of(double tolerance, ShadeAt where = ShadeAt::pixels) {
    return {.executor = Executor::cpu,
            .bake_directions = 1024,
            .refine_tolerance = tolerance,
            .order_low = 3,
            .order_high = 3,
            .shade_at = where};
}

/// Returns a box (id 0) and a ball (id 1) on a floor (id 2) with one side or two.
Scene things_on_floor(int floor_cells, bool two_sided = false) {
    const MaterialPtr grey = diffuse({0.5});
    Scene scene;
    scene.set_environment(falling_light(3, false, 1), glm::dmat3(1), 1);
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(4)),
               .material = grey,
               .to_world = at(0.6, 0, 0.3, 0.4) * glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(0, 1, 0))});
    scene.add({.mesh = test::coarse_sphere(6), .material = grey, .to_world = at(-0.7, -0.1, 0.4, 0.3)});
    scene.add({.mesh = test::rectangle(floor_cells),
               .material = two_sided ? twosided(grey) : grey,
               .to_world = test::plate_at(-0.4, 2)});
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("a floor of two triangles shows the shadows of a fine one, with fewer vertices") {
    Studio render(context, 128, 96);
    for (const bool two_sided : {false, true}) {
        const StokesImage fine = render(things_on_floor(64, two_sided), options_of(0));
        const std::uint64_t vertices = render.statistics.vertices;
        CHECK(render.statistics.vertices_added == 0);
        const Scene coarse = things_on_floor(1, two_sided);
        const double without = test::rms_difference(render(coarse, options_of(0)), fine) / test::rms(fine);
        const double with = test::rms_difference(render(coarse, options_of(0.02)), fine) / test::rms(fine);
        CAPTURES(two_sided, without, with, vertices, render.statistics.vertices);
        CHECK(with < 0.02);
        CHECK(with < without / 4);
        CHECK(render.statistics.vertices_added > 100);
        CHECK(render.statistics.vertices < vertices);
    }
}

IMAGE_TEST_CASE("surfaces stay where they are") {
    Studio render(context, 64, 48);
    const Scene scene = things_on_floor(1, true);
    RenderOptions options = options_of(0);
    options.aovs = aov_depth | aov_instances | aov_normals;
    Framebuffer before(context, 64, 48, 1);
    Framebuffer after(context, 64, 48, 1);
    render.renderer.render(scene, test::some_camera(), options, before);
    options.refine_tolerance = 0.02;
    render.renderer.render(scene, test::some_camera(), options, after);
    REQUIRE(after.statistics().vertices_added > 0);
    CHECK(before.aovs().instances == after.aovs().instances);
    for (std::size_t i = 0; i < before.aovs().depth.size(); ++i) {
        if (std::isinf(before.aovs().depth[i])) continue;
        CHECK(after.aovs().depth[i] ==
              doctest::Approx(before.aovs().depth[i]).epsilon(gl::tolerance_of(context) * 1e-5));
    }
    for (std::size_t i = 0; i < before.aovs().normals.size(); ++i)
        CHECK(std::abs(after.aovs().normals[i] - before.aovs().normals[i]) < 2e-2F);
}

IMAGE_TEST_CASE("changes of refined scenes end where a fresh start does") {
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
        for (const Method method : {Method::factored, Method::dense}) {
            RenderOptions options = options_of(0.05, where);
            options.method = method;
            options.bake_directions = 256;
            options.order_low = options.order_high = 2;
            // By default a first image refines what it shows alone.
            options.disabled_optimisations = skip_rays;
            Scene scene = things_on_floor(1);
            Studio render(context, 32, 24);
            const auto check = [&](const char* what) {
                CAPTURES(what, where, method);
                Studio fresh(context, 32, 24);
                const StokesImage image = render(scene, options);
                // Threads recompute the material tables, whose rounding differs slightly.
                CHECK(test::rms_difference(image, fresh(scene, options)) < 1e-6 * test::rms(image));
                CHECK(render.statistics.vertices_added == fresh.statistics.vertices_added);
            };
            check("first");
            scene.set_transform(1, at(-0.6, 0.2, 0.5, 0.3));
            check("moved");
            scene.set_material(2, diffuse({0.2}));
            check("another material");
            options.shadows = false;
            check("no shadows");
            scene.set_material(2, twosided(diffuse({0.3})));
            options.shadows = true;
            check("two sides");
            options.refine_tolerance = 0;
            check("not refined");
            options.refine_tolerance = 0.1;
            options.max_vertices = 400;
            check("few vertices");
            scene.remove(0);
            check("removed");
        }
    }
}

IMAGE_TEST_CASE("nothing is split where nothing casts shadows, and never beyond the bound") {
    Studio render(context, 16, 12);
    Scene alone;
    alone.set_environment(falling_light(3, false, 1), glm::dmat3(1), 1);
    alone.add({.mesh = test::rectangle(1), .material = diffuse({0.5})});
    render(alone, options_of(0.001));
    CHECK(render.statistics.vertices_added == 0);
    CHECK(render.statistics.vertices_traced == 4);

    const Scene scene = things_on_floor(1);
    RenderOptions options = options_of(0.001);
    options.shadows = false;
    render(scene, options);
    CHECK(render.statistics.vertices_added == 0);
    options.shadows = true;
    options.max_vertices = 700;
    render(scene, options);
    CHECK(render.statistics.vertices_added > 100);
    CHECK(render.statistics.vertices <= 700);
    options.max_vertices = 1;
    render(scene, options);
    CHECK(render.statistics.vertices_added == 0);
}

IMAGE_TEST_CASE("a tolerance of refinement out of range is refused") {
    Studio render(context, 16, 12);
    for (const double tolerance : {-1e-3, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_THROWS_WITH_AS(render(things_on_floor(1), options_of(tolerance)),
                             doctest::Contains("refine_tolerance"), Error);
    }
}
