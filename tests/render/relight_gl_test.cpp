// SPDX-License-Identifier: MIT
// Tests of the vertices that are relit: those that an image shows, each when an image first shows it.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
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
        const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 1, 0)));
        scene.set_environment(test::falling_light(5, true, 3), rotation, 2);
        CHECK(render(scene, where, front).vertices_relit == first.vertices_relit);
        // An object that moves changes the numbers of vertices, some of which have no light yet.
        for (const double x : {1.7, 1.4, 1.2, 0.9}) {
            scene.set_transform(2, at(x, -0.4, 1.1, 0.5));
            render(scene, where, front);
        }
        render(scene, where, behind);
    }
}

IMAGE_TEST_CASE("light stays for pixels while vertices are shaded, and for vertices while pixels are") {
    const Camera front = camera_at({3, 4, 6}, {0, 0.3, 0});
    Scene scene = balls_on_floor();
    Pair render(context);
    const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 1, 0)));
    for (const glm::dmat3& turned : {glm::dmat3(1), rotation}) {
        scene.set_environment(scene.environment(), turned, 1);
        CHECK(render(scene, ShadeAt::vertices, front).vertices_relit > 0);
        CHECK(render(scene, ShadeAt::pixels, front).vertices_relit > 0);
        CHECK(render(scene, ShadeAt::vertices, front).vertices_relit == 0);
        CHECK(render(scene, ShadeAt::pixels, front).vertices_relit == 0);
    }
    for (const double x : {1.7, 1.4}) {
        scene.set_transform(2, at(x, -0.4, 1.1, 0.5));
        render(scene, ShadeAt::pixels, front);
        render(scene, ShadeAt::vertices, front);
    }
}

IMAGE_TEST_CASE("another scale of the environment relights nothing") {
    const EnvironmentPtr light = test::falling_light(5, true, 3);
    const auto brighter = [&](double scale) {
        PshVector coefficients = light->project(5);
        for (double& value : coefficients.data()) value *= scale;
        return psh_environment(coefficients);
    };
    for (const Executor executor : {Executor::cpu, Executor::compute}) {
        for (const Method method : {Method::factored, Method::dense}) {
            for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
                const RenderOptions options{.method = method,
                                            .executor = executor,
                                            .bake_directions = 256,
                                            .order_low = 2,
                                            .order_high = 5,
                                            .shade_at = where,
                                            .physical = true};
                Scene scene = balls_on_floor();
                scene.add_light({.kind = LocalLight::Kind::point, .value = {30}, .to_world = at(1, 3, 2)});
                Studio render(context), other(context);
                render(scene, options);
                CHECK(render.statistics.vertices_relit > 0);
                for (const double scale : {7.0, 1e-6, 1e6}) {
                    CAPTURES(static_cast<int>(executor), static_cast<int>(method), where, scale);
                    scene.set_environment(light, glm::dmat3(1), scale);
                    const StokesImage image = render(scene, options);
                    // Light is kept in single precision, whose range extreme scales would leave.
                    CHECK((render.statistics.vertices_relit == 0) == (scale > 1e-3 && scale < 1e3));
                    scene.set_environment(brighter(scale), glm::dmat3(1), 1);
                    const StokesImage truth = other(scene, options);
                    CHECK(test::rms_difference(image, truth) < 1e-6 * test::rms(truth));
                }
            }
        }
    }
}

IMAGE_TEST_CASE("a rotation that leaves the low orders as they are relights nothing, and shades high ones") {
    struct Case {
        const char* name;
        int order, degree;  // of the only coefficient beside the mean
        bool changes;       // whether the rotation, about the axis of the harmonics, changes the light
    };
    const Case cases[] = {{"symmetric low order", 2, 0, false},
                          {"symmetric high order", 5, 0, false},
                          {"high order", 5, 3, true}};
    for (const Case& of : cases) {
        CAPTURE(of.name);
        PshVector light(5, 1);
        light.at(0, 0, 0, 0) = 6;
        light.at(0, of.order, of.degree, 0) = 1;
        Scene scene = balls_on_floor();
        scene.set_environment(psh_environment(light), glm::dmat3(1), 1);
        const RenderOptions options{.executor = Executor::cpu,
                                    .bake_directions = 256,
                                    .order_low = 2,
                                    .order_high = 5,
                                    .shade_at = ShadeAt::vertices};
        const Camera camera = camera_at({3, 4, 6}, {0, 0.3, 0});
        Studio studio(context);
        const StokesImage before = studio(scene, options, camera);
        const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 0, 1)));
        scene.set_environment(scene.environment(), rotation, 1);
        const StokesImage after = studio(scene, options, camera);
        CHECK(studio.statistics.vertices_relit == 0);
        Studio fresh(context);
        const StokesImage truth = fresh(scene, options, camera);
        CHECK(test::rms_difference(after, truth) < 1e-6 * test::rms(truth));
        CHECK((test::rms_difference(before, truth) > 1e-3 * test::rms(truth)) == of.changes);
    }
}
