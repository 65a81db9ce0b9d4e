// SPDX-License-Identifier: MIT
// Tests of bakes within a budget: shadows follow over several renders and end as those of a fresh start.
#include "geometry/deformed_mesh.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::Studio;

namespace {

RenderOptions options_with(double budget_ms, ShadeAt where = ShadeAt::pixels) {
    return {.executor = Executor::cpu,
            .bake_directions = 512,
            .refine_tolerance = 0.02,
            .bake_budget_ms = budget_ms,
            .order_low = 3,
            .order_high = 5,
            .shade_at = where};
}

// Shorter than any step, so that each render takes one.
constexpr double kLeast = 1e-6;

/// A floor, a ball and a sheet with two sides.
struct Table {
    Table() {
        scene.set_environment(test::falling_light(5, true, 3), glm::dmat3(1), 1);
        floor = scene.add(
            {.mesh = test::rectangle(16), .material = diffuse({0.5}), .to_world = test::plate_at(0, 3)});
        ball = scene.add({.mesh = test::coarse_sphere(5),
                          .material = pplastic({.alpha = 0.3}),
                          .to_world = at(0.5, 0.4, 0, 0.4)});
        sheet = scene.add({.mesh = test::rectangle(4),
                           .material = twosided(test::some_metal(0.4)),
                           .to_world = at(-1, 0.5, 0.3, 0.5)});
    }

    Scene scene;
    std::uint32_t floor = 0, ball = 0, sheet = 0;
};

// Returns the image of a fresh start. A first image by default refines what it shows alone.
StokesImage fresh_image(Studio& fresh, const Scene& scene, RenderOptions options = options_with(0)) {
    options.bake_budget_ms = 0;
    options.disabled_optimisations = skip_rays;
    return fresh(scene, options);
}

// Renders until nothing is pending. Returns the number of renders.
int converge(Studio& studio, const Scene& scene, const RenderOptions& options) {
    constexpr int most = 3000;
    for (int renders = 1; renders < most; ++renders) {
        studio(scene, options);
        if (studio.statistics.vertices_pending == 0) return renders;
    }
    return most;
}

}  // namespace

IMAGE_TEST_CASE("renders within a budget end with the image of a fresh start") {
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
        Table table;
        Studio studio(context);
        const RenderOptions options = options_with(kLeast, where);
        std::uint32_t added = 0;
        const std::vector<std::pair<const char*, std::function<void()>>> edits{
            {"first picture", [] {}},
            {"move", [&] { table.scene.set_transform(table.ball, at(0.9, 0.4, 0.3, 0.4)); }},
            {"rotate",
             [&] {
                 table.scene.set_transform(
                     table.sheet,
                     at(-0.6, 0.5, 0.3, 0.5) * glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0, 1, 0)));
             }},
            {"deform",
             [&] {
                 const Mesh& mesh = *table.scene.at(table.ball).mesh;
                 std::vector<glm::vec3> positions = mesh.positions;
                 for (glm::vec3& p : positions) p.x += 0.4F * p.y * p.y;
                 table.scene.set_mesh(table.ball,
                                      std::make_shared<const Mesh>(deformed(mesh, std::move(positions), {})));
             }},
            {"add",
             [&] {
                 added = table.scene.add({.mesh = test::coarse_sphere(3),
                                          .material = diffuse({0.3}),
                                          .to_world = at(-0.2, 0.2, 1, 0.2)});
             }},
            {"remove", [&] { table.scene.remove(added); }},
        };
        for (const auto& [name, edit] : edits) {
            CAPTURES(where, name);
            edit();
            studio(table.scene, options);
            std::uint64_t pending = studio.statistics.vertices_pending;
            CHECK(pending > 0);
            studio(table.scene, options);
            CHECK(studio.statistics.vertices_pending <= pending);
            CHECK(converge(studio, table.scene, options) < 3000);
            const StokesImage image = studio(table.scene, options);
            CHECK(studio.statistics.bake_rays == 0);
            Studio fresh(context);
            const StokesImage truth = fresh_image(fresh, table.scene, options);
            CHECK(fresh.statistics.vertices_pending == 0);
            CHECK(studio.statistics.vertices == fresh.statistics.vertices);
            CHECK(studio.statistics.vertices_unoccluded == fresh.statistics.vertices_unoccluded);
            CHECK(test::rms_difference(image, truth) < 1e-5 * largest(truth));
        }
    }
}

IMAGE_TEST_CASE("a budget that begins with other directions takes over no bake") {
    const struct {
        int directions;
        bool rotated;  // the largest object, along whose axes the directions lie
    } rows[] = {{1024, false}, {256, false}, {512, true}};
    for (const auto& row : rows) {
        CAPTURES(row.directions, row.rotated);
        Table table;
        Studio studio(context);
        studio(table.scene, options_with(0));
        RenderOptions options = options_with(kLeast);
        options.bake_directions = row.directions;
        if (row.rotated)
            table.scene.set_transform(
                table.floor, glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0, 1, 0)) * test::plate_at(0, 3));
        CHECK(converge(studio, table.scene, options) < 3000);
        const StokesImage image = studio(table.scene, options);
        Studio fresh(context);
        const StokesImage truth = fresh_image(fresh, table.scene, options);
        CHECK(test::rms_difference(image, truth) < 1e-5 * largest(truth));
    }
}

IMAGE_TEST_CASE(
    "an object that moves in every render keeps its own shadow, and a render without budget ends it") {
    Table table;
    Studio studio(context);
    studio(table.scene, options_with(0));
    const StokesImage still = studio(table.scene, options_with(0));
    for (int step = 1; step <= 10; ++step) {
        table.scene.set_transform(table.ball, at(0.5 + 0.05 * step, 0.4, 0.04 * step, 0.4));
        const StokesImage image = studio(table.scene, options_with(kLeast));
        CHECK(studio.statistics.vertices_pending > 0);
        Studio fresh(context);
        const StokesImage truth = fresh_image(fresh, table.scene);
        CAPTURE(step);
        // The shadow on the floor lags behind, the ball does not.
        CHECK(test::rms_difference(image, truth) < 0.8 * test::rms_difference(still, truth) + 1e-3);
    }
    const StokesImage image = studio(table.scene, options_with(0));
    CHECK(studio.statistics.vertices_pending == 0);
    Studio fresh(context);
    const StokesImage truth = fresh_image(fresh, table.scene);
    CHECK(test::rms_difference(image, truth) < 1e-5 * largest(truth));
}

IMAGE_TEST_CASE("a budget goes on from the bake of a first picture") {
    Table table;
    table.scene.set_mesh(table.ball, test::fine_sphere());
    Studio studio(context), fresh(context);
    const StokesImage first = studio(table.scene, options_with(0));
    CHECK(studio.statistics.vertices_unbaked > 0);
    const StokesImage next = studio(table.scene, options_with(kLeast));
    CHECK(studio.statistics.vertices_pending > 0);
    const StokesImage unshadowed = fresh(table.scene, options_with(kLeast));
    CHECK(test::rms_difference(next, first) < 0.01 * test::rms_difference(unshadowed, first));
    const StokesImage truth = fresh(table.scene, options_with(0));
    // The bake of a first picture spares rays on which neighbours agree.
    CHECK(test::rms_difference(studio(table.scene, options_with(0)), truth) < 1e-3 * largest(truth));
    CHECK(studio.statistics.vertices_pending == 0);
}

IMAGE_TEST_CASE("an object that deforms keeps its own shadow until it is baked") {
    Scene scene;
    scene.set_environment(test::falling_light(5, true, 3), glm::dmat3(1), 1);
    // The inside of a bowl shadows itself.
    Mesh bowl = *test::coarse_sphere(8);
    std::erase_if(bowl.triangles, [&](const glm::uvec3& t) { return bowl.positions[t.x].y > 0.3F; });
    bowl.texcoord_triangles.clear();
    bowl.texcoords.clear();
    const std::uint32_t id = scene.add({.mesh = std::make_shared<const Mesh>(bowl),
                                        .material = twosided(diffuse({0.6})),
                                        .to_world = at(0, 0, 0, 0.8)});
    Studio studio(context), adding(context);
    studio(scene, options_with(0));
    adding(scene, options_with(0));
    std::vector<glm::vec3> positions = bowl.positions;
    for (glm::vec3& p : positions) p.x *= 1.05F;
    const auto bent = std::make_shared<const Mesh>(deformed(bowl, std::move(positions), {}));
    Scene other = scene;
    scene.set_mesh(id, bent);
    const StokesImage image = studio(scene, options_with(kLeast));
    CHECK(studio.statistics.vertices_pending > 0);
    // Another instance in its place has no shadows yet.
    other.remove(id);
    other.add({.mesh = bent, .material = scene.at(id).material, .to_world = scene.at(id).to_world});
    const StokesImage without = adding(other, options_with(kLeast));
    Studio fresh(context);
    const StokesImage truth = fresh(scene, options_with(0));
    CHECK(test::rms_difference(image, truth) < 0.25 * test::rms_difference(without, truth));
    CHECK(converge(studio, scene, options_with(kLeast)) < 3000);
    // The axes of the bake are those of the mesh before it was bent.
    CHECK(test::rms_difference(studio(scene, options_with(kLeast)), truth) < 0.01 * largest(truth));
}
