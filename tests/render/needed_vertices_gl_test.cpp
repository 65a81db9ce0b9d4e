// SPDX-License-Identifier: MIT
// Tests of bakes of the vertices that an image needs: pictures agree with those of all rays.
#include "render/needed_vertices.hpp"

#include <functional>
#include <random>
#include <string_view>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::camera_at;
using test::rms;
using test::rms_difference;
using test::Studio;

namespace {

RenderOptions options_with(std::uint32_t disabled) {
    return {.executor = Executor::cpu,
            .bake_directions = 256,
            .order_high = 4,
            .shade_at = ShadeAt::pixels,
            .disabled_optimisations = disabled};
}

/// Returns a sphere with bumps that shadow each other; detail: of make_sphere().
std::shared_ptr<const Mesh> bumpy_sphere(double detail = 1) {
    Mesh mesh = make_sphere({}, 1, detail);
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.1F * std::sin(9 * p.x) * std::sin(11 * p.y) * std::sin(10 * p.z);
    mesh.normals.clear();
    smooth_normals(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

Scene scene_of(const std::shared_ptr<const Mesh>& mesh, double reflectance, double light) {
    Scene scene;
    scene.add({.mesh = mesh, .material = diffuse({reflectance})});
    scene.set_environment(test::falling_light(4, false, 3), glm::dmat3(1), light);
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("pictures agree with those of all rays, also if none are traced") {
    const auto bumpy = bumpy_sphere();
    const auto convex = test::fine_sphere();
    Scene apart = scene_of(convex, 0.5, 1);
    apart.add({.mesh = convex, .material = diffuse({0.5}), .to_world = test::at(1000, 0, 0)});
    Scene boxed = scene_of(bumpy, 0.5, 1);
    boxed.add({.mesh = std::make_shared<const Mesh>(make_cube(8)),
               .material = diffuse({0.5}),
               .to_world = test::at(0, 0, 0, 1.2)});
    Scene lit = scene_of(bumpy, 0.5, 0);
    lit.add_light({.value = {20}, .to_world = look_at({1, 3, 1.5}, {0, 0, 0}, {0, 1, 0.1})});
    const struct {
        const char* name;
        Scene scene;
        double most;  // of all rays, the part that may be traced
        bool whole;   // all vertices are baked, so that pictures are equal to the last bit
        glm::dvec3 target{0};
    } cases[] = {{"convex object", scene_of(convex, 0.5, 1), 0, true},
                 {"objects far apart", apart, 1e-3, false},
                 {"black object", scene_of(bumpy, 0, 1), 0, true},
                 {"darkness", lit, 0, true},
                 {"camera that looks away", scene_of(bumpy, 0.5, 1), 0, true, {100, 3, 4}},
                 {"object in a box", boxed, 0.2, false},
                 {"far side", scene_of(bumpy, 0.5, 1), 0.75, false}};
    for (const auto& each : cases) {
        CAPTURE(each.name);
        const Camera camera = camera_at({0, 1, 4}, each.target);
        Studio skipping(context), tracing(context);
        const StokesImage some = skipping(each.scene, options_with(0), camera);
        const StokesImage all = tracing(each.scene, options_with(skip_rays), camera);
        const Statistics& statistics = skipping.statistics;
        CHECK(tracing.statistics.vertices_unbaked == 0);
        CHECK(tracing.statistics.bake_rays_skipped == 0);
        CHECK(static_cast<double>(statistics.bake_rays) <=
              each.most * static_cast<double>(tracing.statistics.bake_rays));
        if (each.whole)
            CHECK(some.data == all.data);
        else
            CHECK(rms_difference(some, all) <= 2e-3 * rms(all));
        // The box hides all but the sample that says where triangles are refined.
        if (std::string_view(each.name) == "object in a box")
            CHECK(statistics.vertices_unbaked > 9 * bumpy->positions.size() / 10);
        if (std::string_view(each.name) == "far side") {
            CHECK(statistics.vertices_unbaked > statistics.vertices / 4);
            CHECK(rms(all) > 0);
        }
    }
}

IMAGE_TEST_CASE("what a further view shows is baked with it, and all the rest once a camera goes on moving") {
    const Scene scene = scene_of(bumpy_sphere(0.5), 0.5, 1);
    const Camera front = camera_at({0, 1, 4}), beside = camera_at({0.1, 1, 4}), back = camera_at({0, 1, -4}),
                 away = camera_at({0, 1, 4}, {0, 1, 9});
    Studio studio(context), tracing(context);
    static_cast<void>(studio(scene, options_with(0), away));
    CHECK(studio.statistics.vertices_traced == 0);
    static_cast<void>(studio(scene, options_with(0), front));
    const std::uint64_t unbaked = studio.statistics.vertices_unbaked;
    std::uint64_t rays = studio.statistics.bake_rays;
    CHECK(unbaked > 0);
    const auto check_against_all = [&](const Camera& camera) {
        const StokesImage image = studio(scene, options_with(0), camera);
        rays += studio.statistics.bake_rays;
        const StokesImage all = tracing(scene, options_with(skip_rays), camera);
        CHECK(rms_difference(image, all) <= 2e-3 * rms(all));
    };
    check_against_all(beside);
    CHECK(studio.statistics.vertices_unbaked < unbaked);
    CHECK(studio.statistics.vertices_traced > 0);
    CHECK(20 * studio.statistics.vertices_traced < unbaked);
    check_against_all(front);
    CHECK(studio.statistics.vertices_traced == 0);
    check_against_all(away);
    CHECK(studio.statistics.vertices_traced == 0);
    check_against_all(back);
    CHECK(studio.statistics.vertices_traced > unbaked / 4);
    for (int step = 0; step < 40 && studio.statistics.vertices_unbaked > 0; ++step)
        static_cast<void>(studio(scene, options_with(0), camera_at({0.1 * step, 1, 4})));
    CHECK(studio.statistics.vertices_unbaked == 0);
    check_against_all(back);
    CHECK(studio.statistics.vertices_traced == 0);
    Studio fresh(context);
    static_cast<void>(fresh(scene, options_with(skip_rays), front));
    CHECK(static_cast<double>(rays) <= 1.2 * static_cast<double>(fresh.statistics.bake_rays));
}

IMAGE_TEST_CASE("edges below two pixels are not split until a camera comes nearer") {
    Scene scene = scene_of(bumpy_sphere(), 0.5, 1);
    scene.add({.mesh = test::rectangle(32), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    // Images with a mirror need all vertices, but what it shows is no nearer than the mirror.
    SUBCASE("of a scene without smooth surfaces") {}
    SUBCASE("of a scene with a mirror") {
        scene.add({.mesh = test::coarse_sphere(4),
                   .material = conductor({{0.2, -3.0}}),
                   .to_world = test::at(1, 0, 1, 0.3)});
    }
    RenderOptions options = options_with(0);
    options.refine_tolerance = 0.005;
    options.max_vertices = 100000;
    const Camera far = camera_at({0, 3, 6}), near = camera_at({0, 2, 4});
    Studio small(context, 32, 24), large(context, 640, 480), fresh(context, 32, 24);
    static_cast<void>(small(scene, options, far));
    const std::uint64_t added = small.statistics.vertices_added;
    static_cast<void>(large(scene, options, far));
    CHECK(2 * added < large.statistics.vertices_added);
    const StokesImage image = small(scene, options, near);
    CHECK(small.statistics.vertices_added > added);
    options.disabled_optimisations = skip_rays;
    CHECK(rms_difference(image, fresh(scene, options, near)) <= 5e-3 * rms(image));
}

IMAGE_TEST_CASE("bounced light and mirrors need all vertices") {
    Scene scene = scene_of(bumpy_sphere(0.5), 0.5, 1);
    const Camera camera = camera_at({0, 1, 4});
    Studio studio(context);
    RenderOptions bouncing = options_with(0);
    bouncing.max_depth = 3;
    static_cast<void>(studio(scene, bouncing, camera));
    CHECK(studio.statistics.vertices_unbaked == 0);

    scene.add({.mesh = test::rectangle(1),
               .material = conductor({{0.2, -3.0}}),
               .to_world = test::plate_at(-1.2, 3)});
    Studio mirrored(context);
    static_cast<void>(mirrored(scene, options_with(0), camera));
    CHECK(mirrored.statistics.vertices_unbaked == 0);
}

IMAGE_TEST_CASE("vertices that no image needs follow changes of the scene once one does") {
    constexpr double size = 0.4;
    const glm::dmat4 far = test::at(0, 0.3, -30, size), behind = test::at(0, 0.3, -1.6, size),
                     beside = test::at(0.4, 0.2, -1.5, size),
                     turned = glm::rotate(behind, 0.5, glm::dvec3(0, 1, 0));
    const auto set = [](const glm::dmat4& place) {
        return [place](Scene& scene, std::uint32_t id) { scene.set_transform(id, place); };
    };
    using Edit = std::function<void(Scene&, std::uint32_t)>;
    const struct {
        const char* name;
        glm::dmat4 from;
        std::vector<Edit> edits;
        bool whole = false;  // whether all vertices are baked before the first change
    } cases[] = {{"an object comes", far, {set(behind)}},
                 {"an object is removed", behind, {[](Scene& scene, std::uint32_t id) { scene.remove(id); }}},
                 {"an object turns", behind, {set(turned)}},
                 {"an object moves twice", far, {set(behind), set(beside)}, true}};
    const Camera front = camera_at({0, 1, 4}), back = camera_at({0, 1, -4});
    for (const auto& each : cases) {
        CAPTURE(each.name);
        Scene scene = scene_of(bumpy_sphere(0.5), 0.5, 1);
        const auto id =
            scene.add({.mesh = test::coarse_sphere(12), .material = diffuse({0.5}), .to_world = each.from});
        Studio studio(context), tracing(context);
        static_cast<void>(studio(scene, options_with(0), front));
        for (int step = 0; each.whole && step < 40 && studio.statistics.vertices_unbaked > 0; ++step)
            static_cast<void>(studio(scene, options_with(0), camera_at({0.1 * step, 1, 4})));
        CHECK((studio.statistics.vertices_unbaked == 0) == each.whole);
        for (const Edit& edit : each.edits) {
            edit(scene, id);
            const StokesImage image = studio(scene, options_with(0), front);
            CHECK(studio.statistics.vertices_unbaked > studio.statistics.vertices / 4);
            CHECK(studio.statistics.vertices_unoccluded < studio.statistics.vertices);
            const StokesImage all = tracing(scene, options_with(skip_rays), front);
            CHECK(rms_difference(image, all) <= 2e-3 * rms(all));
        }
        const StokesImage image = studio(scene, options_with(0), back);
        CHECK(studio.statistics.vertices_traced > 0);
        const StokesImage all = tracing(scene, options_with(skip_rays), back);
        CHECK(rms_difference(image, all) <= 2e-3 * rms(all));
    }
}

IMAGE_TEST_CASE("a series of changes and views leaves the image of a fresh start") {
    Scene scene = scene_of(bumpy_sphere(0.5), 0.5, 1);
    scene.add({.mesh = test::rectangle(32), .material = diffuse({0.5}), .to_world = test::plate_at(-1.2, 3)});
    const auto ball = test::fine_sphere();
    std::vector<std::uint32_t> balls;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1, 1);
    const auto place = [&] {
        return test::at(2.5 * value(random), 0.5 * value(random), 2.5 * value(random), 0.3);
    };
    for (int i = 0; i < 3; ++i)
        balls.push_back(scene.add({.mesh = ball, .material = diffuse({0.5}), .to_world = place()}));
    Studio studio(context);
    for (int step = 0; step < 8; ++step) {
        const std::size_t some = random() % balls.size();
        if (step % 4 == 3) {
            scene.remove(balls[some]);
            balls[some] = scene.add({.mesh = ball, .material = diffuse({0.5}), .to_world = place()});
        } else if (step % 4 != 2) {
            scene.set_transform(balls[some], place());
        }
        const double angle = 0.7 * step;
        const Camera camera = camera_at({5 * std::sin(angle), 2, 5 * std::cos(angle)});
        CAPTURE(step);
        const StokesImage image = studio(scene, options_with(0), camera);
        CHECK(studio.statistics.vertices_unbaked > 0);
        Studio fresh(context);
        const StokesImage truth = fresh(scene, options_with(skip_rays), camera);
        CHECK(rms_difference(image, truth) <= 3e-3 * rms(truth));
    }
}

IMAGE_TEST_CASE("a far view leaves no coarse shadows to nearer ones") {
    const auto bumpy = bumpy_sphere(0.5);
    // Distances stay about the same, so that what the first near view has traced suffices.
    const Camera near = camera_at({0, 1, 4}), near_back = camera_at({0, 1, -4}),
                 far = camera_at({0, 2.5, 40}), far_back = camera_at({0, 2.5, -40});
    const struct {
        const char* name;
        std::vector<Camera> before, after;  // views before and after an object comes
        Camera last;
    } cases[] = {{"of vertices that come", {near}, {far}, near},
                 {"of outdated vertices", {far}, {far_back, near_back}, near}};
    for (const auto& each : cases) {
        CAPTURE(each.name);
        Scene scene = scene_of(bumpy, 0.5, 1);
        Studio studio(context);
        for (const Camera& camera : each.before) static_cast<void>(studio(scene, options_with(0), camera));
        scene.add({.mesh = bumpy, .material = diffuse({0.5}), .to_world = test::at(1.7, 0, 0, 0.5)});
        for (const Camera& camera : each.after) static_cast<void>(studio(scene, options_with(0), camera));
        CHECK(studio.statistics.vertices_unbaked > 0);
        const StokesImage image = studio(scene, options_with(0), each.last);
        Studio fresh(context);
        const StokesImage truth = fresh(scene, options_with(skip_rays), each.last);
        CHECK(rms_difference(image, truth) <= 2e-3 * rms(truth));
    }
}

IMAGE_TEST_CASE("images of few vertices refine what they show") {
    Scene scene;
    scene.set_environment(test::falling_light(4, false, 3), glm::dmat3(1), 1);
    scene.add({.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    const auto ball = scene.add(
        {.mesh = test::coarse_sphere(6), .material = diffuse({0.5}), .to_world = test::at(0, -0.4, 0, 0.5)});
    RenderOptions options = options_with(0);
    options.refine_tolerance = 0.005;
    RenderOptions tracing = options;
    tracing.disabled_optimisations = skip_rays;
    const Camera above = camera_at({0, 4, 3}), aside = camera_at({1, 4, 3}), below = camera_at({0, -4, 3});
    Studio studio(context, 64, 48), fresh(context, 64, 48);
    const StokesImage first = studio(scene, options, above);
    const std::uint64_t added = studio.statistics.vertices_added;
    CHECK(studio.statistics.vertices_unbaked == 0);
    const StokesImage all = fresh(scene, tracing, above);
    const std::uint64_t most = fresh.statistics.vertices_added;
    CHECK(added > 0);
    CHECK(2 * added < most);
    CHECK(rms_difference(first, all) <= 1e-2 * rms(all));
    CHECK(first.data != all.data);

    SUBCASE("from another side") {
        Studio other(context, 64, 48);
        const StokesImage part = other(scene, options, aside), truth = fresh(scene, tracing, aside);
        const StokesImage image = studio(scene, options, aside);
        CHECK(rms_difference(image, part) <= 5e-3 * rms(part));
        CHECK(rms_difference(image, truth) <= 1e-2 * rms(truth));
        CHECK(studio.statistics.vertices_added >= added);
        CHECK(2 * studio.statistics.vertices_added < most);
    }
    SUBCASE("from ever nearer") {
        for (int step = 1; step < 40; ++step)
            static_cast<void>(studio(scene, options, camera_at({0, 4 - 0.05 * step, 3})));
        CHECK(2 * studio.statistics.vertices_added > most);
        CHECK(rms_difference(studio(scene, options, above), all) <= 2e-3 * rms(all));
    }
    SUBCASE("when an object moves") {
        scene.set_transform(ball, test::at(0, -0.3, 0, 0.5));
        const StokesImage moved = studio(scene, options, above), truth = fresh(scene, tracing, above);
        CHECK(2 * studio.statistics.vertices_added < fresh.statistics.vertices_added);
        CHECK(rms_difference(moved, truth) <= 1e-2 * rms(truth));
        // A shadow that stayed behind would be within the tolerance of all rays.
        Studio part(context, 64, 48);
        const StokesImage anew = part(scene, options, above);
        CHECK(rms_difference(moved, anew) <= 5e-3 * rms(anew));
    }
    SUBCASE("when a render has a budget") {
        options.bake_budget_ms = 1e9;
        CHECK(rms_difference(studio(scene, options, above), all) <= 2e-3 * rms(all));
    }
    SUBCASE("when light bounces") {
        options.max_depth = tracing.max_depth = 3;
        const StokesImage truth = fresh(scene, tracing, below);
        CHECK(rms_difference(studio(scene, options, below), truth) <= 2e-3 * rms(truth));
    }
}

IMAGE_TEST_CASE("images of several samples need the vertices of triangles at their samples alone") {
    const Scene scene = scene_of(bumpy_sphere(), 0.5, 1);
    const Camera camera = camera_at({0, 1, 4});
    RenderOptions options = options_with(0);
    Studio one(context, 16, 12), some(context, 16, 12), tracing(context, 16, 12);
    static_cast<void>(one(scene, options, camera));
    SUBCASE("drawn together") {
        options.pixel_samples = 4;
    }
    SUBCASE("drawn one by one") {
        options.pixel_samples = 5;
    }
    const StokesImage image = some(scene, options, camera);
    const std::uint64_t unbaked = some.statistics.vertices_unbaked;
    CHECK(2 * some.statistics.vertices_traced < one.statistics.vertices_traced);
    CHECK(unbaked > one.statistics.vertices_unbaked);
    RenderOptions all = options;
    all.disabled_optimisations = skip_rays;
    const StokesImage truth = tracing(scene, all, camera);
    CHECK(rms_difference(image, truth) <= 2e-3 * rms(truth));
    // Vertices that are left out count as unoccluded, which a single one at a sample would show.
    CHECK(test::differing_pixels(image, truth, 2e-2 * rms(truth)) == 0);

    static_cast<void>(some(scene, options, camera));
    CHECK(some.statistics.vertices_traced == 0);
    // Less than a pixel aside, samples show other triangles.
    const Camera beside = camera_at({0.02, 1, 4});
    const StokesImage moved = some(scene, options, beside), moved_truth = tracing(scene, all, beside);
    CHECK(some.statistics.vertices_traced > 0);
    CHECK(2 * some.statistics.vertices_unbaked > unbaked);
    CHECK(rms_difference(moved, moved_truth) <= 2e-3 * rms(moved_truth));
}

namespace {

RenderOptions options_of_samples(int count, std::uint32_t disabled = 0) {
    RenderOptions options = options_with(disabled);
    options.pixel_samples = count;
    return options;
}

/// Returns small triangles in a cube, each with vertices of its own.
std::shared_ptr<const Mesh> shreds(std::uint32_t count) {
    Mesh mesh;
    auto some = [state = std::uint32_t{1}]() mutable {
        state = state * 1664525U + 1013904223U;
        return 2 * static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U) - 1;
    };
    for (std::uint32_t t = 0; t < count; ++t) {
        const glm::vec3 centre(some(), some(), some());
        for (int k = 0; k < 3; ++k) {
            mesh.positions.push_back(centre + 0.01F * glm::vec3(some(), some(), some()));
            mesh.normals.emplace_back(0, 0, 1);
        }
        mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace

IMAGE_TEST_CASE("a mirror or glass matters to an image that shows it") {
    const struct {
        const char* name;
        MaterialPtr material;
        glm::dvec3 place;
        bool shown;
    } cases[] = {{"mirror in front", conductor({{0.2, -3.0}}), {0, 0, 2}, true},
                 {"mirror behind", conductor({{0.2, -3.0}}), {0, -0.2, -2}, false},
                 {"glass in front", thin_dielectric({}), {0, 0, 2}, true},
                 {"glass behind", thin_dielectric({}), {0, -0.2, -2}, false}};
    for (const auto& each : cases) {
        CAPTURE(each.name);
        Scene scene = scene_of(bumpy_sphere(), 0.5, 1);
        scene.add({.mesh = test::coarse_sphere(4),
                   .material = each.material,
                   .to_world = test::at(each.place.x, each.place.y, each.place.z, 0.1)});
        for (const int samples : {1, 4}) {
            CAPTURE(samples);
            Studio some(context, 32, 24), tracing(context, 32, 24);
            const Camera camera = camera_at({0, 0, 4});
            const StokesImage image = some(scene, options_of_samples(samples), camera);
            CHECK((some.statistics.vertices_unbaked == 0) == each.shown);
            const StokesImage truth = tracing(scene, options_of_samples(samples, skip_rays), camera);
            CHECK(rms_difference(image, truth) <= 2e-3 * rms(truth));
        }
    }
}

IMAGE_TEST_CASE("an image of several samples refines what it shows, and what light passes") {
    Scene scene = scene_of(test::coarse_sphere(8), 0.5, 1);
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    RenderOptions options = options_of_samples(4);
    options.refine_tolerance = 0.005;
    const Camera camera = camera_at({0, 1, 4});
    const auto refined = [&] {
        Studio studio(context);
        static_cast<void>(studio(scene, options, camera));
        return studio.statistics.vertices_added;
    };
    const std::uint64_t alone = refined();
    CHECK(alone > 0);
    const auto plate = scene.add(
        {.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1.1, 3)});
    SUBCASE("not below the floor") {
        CHECK(refined() <= alone);
    }
    SUBCASE("but above it") {
        scene.set_roles(plate, {.casts_shadows = false});
        scene.set_transform(plate, test::plate_at(-0.9, 3));
        CHECK(refined() > alone);
    }
}

IMAGE_TEST_CASE("vertices that only a drawn image shows are baked with it") {
    Scene scene = scene_of(shreds(30000), 0.5, 1);
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(2)),
               .material = diffuse({0.5}),
               .to_world = test::at(0, 0, 0, 4)});
    Studio some(context, 128, 96), tracing(context, 128, 96);
    const Camera camera = camera_at({0, 0, 3.5});
    const StokesImage image = some(scene, options_of_samples(4), camera);
    CHECK(some.statistics.vertices_unbaked > 0);
    const StokesImage truth = tracing(scene, options_of_samples(4, skip_rays), camera);
    CHECK(test::differing_pixels(image, truth, 2e-2 * rms(truth)) == 0);
}
