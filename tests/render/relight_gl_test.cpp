// SPDX-License-Identifier: MIT
// Tests of the vertices that are relit: those that an image shows, each when an image first shows it.
#include "gl/contexts.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::at;
using test::camera_at;
using test::Studio;

namespace {

/// Returns balls above a floor, which shadow each other.
Scene balls_on_floor() {
    Scene scene;
    scene.set_environment(test::falling_light(5, true, 3), glm::dmat3(1), 1);
    const MaterialPtr shiny = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3});
    scene.add({.mesh = test::coarse_sphere(8), .material = shiny});
    scene.add({.mesh = test::rectangle(9), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    scene.add({.mesh = test::coarse_sphere(4), .material = shiny, .to_world = at(1.8, -0.5, 0.8, 0.5)});
    return scene;
}

/// Renders a scene twice: as usual, and with all vertices relit. The bakes of both are those of all rays.
struct Pair {
    explicit Pair(const std::shared_ptr<gl::Context>& context) : some(context), all(context) {}

    /// Checks that the images are equal, and returns the statistics of the first one.
    Statistics operator()(const Scene& scene, ShadeAt where, const Camera& camera) {
        RenderOptions options{
            .executor = Executor::cpu, .bake_directions = 256, .order_low = 2, .order_high = 5};
        options.shade_at = where;
        options.disabled_optimisations = skip_rays;
        const StokesImage image = some(scene, options, camera);
        options.disabled_optimisations |= skip_hidden;
        CHECK(image.data == all(scene, options, camera).data);
        return some.statistics;
    }

    Studio some, all;
};

}  // namespace

IMAGE_TEST_CASE("vertices are relit when an image first shows them") {
    const Camera front = camera_at({3, 4, 6}, {0, 0.3, 0});
    const Camera behind = camera_at({-3, -4, -6}, {0, 0.3, 0});
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
        Scene scene = balls_on_floor();
        Pair render(context);
        const Statistics first = render(scene, where, front);
        CHECK(first.vertices_relit < first.vertices);
        CHECK(render.all.statistics.vertices_relit == first.vertices);
        const std::uint64_t other = render(scene, where, behind).vertices_relit;
        CHECK(other > 0);
        CHECK(first.vertices_relit + other <= first.vertices);
        CHECK(render(scene, where, front).vertices_relit == 0);

        // A vertex that was not shown keeps no light of an earlier environment.
        scene.set_environment(test::falling_light(3, true, 3), glm::dmat3(1), 2);
        CHECK(render(scene, where, front).vertices_relit == first.vertices_relit);
        // An object that moves changes the numbers of vertices, some of which have no light yet.
        for (const double x : {1.7, 1.4, 1.2, 0.9}) {
            scene.set_transform(2, at(x, -0.4, 1.1, 0.5));
            render(scene, where, front);
        }
        render(scene, where, behind);
    }
}
