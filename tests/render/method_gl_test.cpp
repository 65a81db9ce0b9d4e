// SPDX-License-Identifier: MIT
// Tests of the transfer methods against each other.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/chiral_material.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "render/scenes.hpp"

using namespace nicol;

namespace {

/// Returns the material truncated to an order on the incoming and outgoing sides.
MaterialPtr truncated(const Material& material, int order) {
    std::vector<IsotropicMatrix> channels;
    for (int c = 0; c < material.channels(); ++c) channels.push_back(project_material(material, c, order));
    return psh_matrix_material(channels);
}

/// Returns two spheres close enough to shadow each other.
Scene two_spheres(const MaterialPtr& first, const MaterialPtr& second, int order) {
    Scene scene;
    const auto mesh = test::coarse_sphere(6);
    scene.add({.mesh = mesh, .material = first, .to_world = test::at(-1.1, 0, 0)});
    scene.add({.mesh = mesh, .material = second, .to_world = test::at(1.1, 0, 0)});
    scene.set_environment(test::falling_light(order, true), glm::dmat3(1), 1);
    return scene;
}

const Camera some_camera = test::camera_at({1, 2, 6});

}  // namespace

IMAGE_TEST_CASE("dense equals factored where factored truncates the outgoing side as well") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3});
    const MaterialPtr metal = test::chiral(test::some_metal(0.3));
    for (const int order : {0, 3}) {
        Scene exact = two_spheres(plastic, metal, order);
        Scene cut = two_spheres(truncated(*plastic, order), truncated(*metal, order), order);
        test::Studio render_dense(context), render_factored(context);
        const auto check = [&] {
            // By default a first image, of the factored method alone, refines what it shows alone.
            RenderOptions options{.method = Method::dense,
                                  .order_low = order,
                                  .order_high = order,
                                  .disabled_optimisations = skip_rays};
            const StokesImage dense = render_dense(exact, options, some_camera);
            options.method = Method::factored;
            const StokesImage factored = render_factored(cut, options, some_camera);
            const double scale = test::rms(factored);
            CHECK(scale > 0.1);
            // The remaining difference is the linear interpolation between angles of the response table, plus
            // single vertices whose shadow matrices lose most from storage in 16 bits.
            CHECK(test::rms_difference(factored, dense) < 1e-5 * scale);
            CHECK(largest_difference(factored, dense) < 3e-4 * scale);
        };
        check();
        // Rotates the light, then moves an object, and compares again.
        const glm::dmat3 rotation = theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -1)));
        for (Scene* scene : {&exact, &cut}) scene->set_environment(scene->environment(), rotation, 0.5);
        check();
        const glm::dmat4 moved =
            glm::rotate(glm::translate(glm::dmat4(1), {0, 1, 0}), 0.7, glm::dvec3(1, 1, 0));
        for (Scene* scene : {&exact, &cut}) scene->set_transform(0, moved);
        check();
    }
}

IMAGE_TEST_CASE("dense reports what it holds and skips") {
    Scene scene = two_spheres(diffuse({0.5}), diffuse({0.2}), 4);
    scene.set_environment(constant_environment({1.0, 1.0, 1.0}), glm::dmat3(1), 1);
    Framebuffer target(context, 16, 16, 3);
    Renderer renderer(context);
    renderer.render(scene, some_camera, {.method = Method::dense}, target);
    const Statistics& first = target.statistics();
    const std::uint64_t vertices = first.vertices;
    CHECK(first.transfer_bytes > vertices * 25 * 24 * sizeof(float));
    CHECK(first.transfer_bytes < vertices * 25 * 50 * sizeof(float));
    CHECK(first.response_rows_skipped == 2 * 3 * 3);
    CHECK(first.bake_ms > 0);
    renderer.render(scene, some_camera, {.method = Method::dense}, target);
    CHECK(target.statistics().bake_ms == 0);
    CHECK(target.statistics().relight_ms == 0);
}
