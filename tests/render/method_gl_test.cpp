// SPDX-License-Identifier: MIT
// The methods of transfer against each other.
#include "gl/contexts.hpp"
#include "harmonics/rotation.hpp"
#include "image_difference.hpp"
#include "material/conductor.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "render/renderer.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Light with every Stokes component, positive and physical at order 0.
EnvironmentPtr some_light(int order) {
    PshVector light(order, 3);
    for (int c = 0; c < 3; ++c) {
        light.at(c, 0, 0, 0) = 4 + c;
        for (int l = 1; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = 0; p < 4; ++p) {
                    if (l < 2 && (p == 1 || p == 2)) continue;
                    light.at(c, l, m, p) = 0.3 / l * std::sin(7 * l + 3 * m + 5 * p + c);
                }
            }
        }
    }
    return psh_environment(light);
}

/// The material as it is up to an order, on both sides.
MaterialPtr truncated(const Material& material, int order) {
    std::vector<IsotropicMatrix> channels;
    for (int c = 0; c < material.channels(); ++c) channels.push_back(project_material(material, c, order));
    return psh_matrix_material(channels);
}

/// Close enough to shadow each other.
Scene two_spheres(const MaterialPtr& first, const MaterialPtr& second, int order) {
    Scene scene;
    const auto mesh = test::coarse_sphere(6);
    scene.add({.mesh = mesh, .material = first, .to_world = glm::translate(glm::dmat4(1), {-1.1, 0, 0})});
    scene.add({.mesh = mesh, .material = second, .to_world = glm::translate(glm::dmat4(1), {1.1, 0, 0})});
    scene.set_environment(some_light(order), glm::dmat3(1), 1);
    return scene;
}

const Camera some_camera = test::camera_at({1, 2, 6});

}  // namespace

TEST_CASE("dense equals factored where factored truncates the outgoing side as well") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3});
        const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.3});
        for (const int order : {0, 3}) {
            Scene exact = two_spheres(plastic, metal, order);
            Scene cut = two_spheres(truncated(*plastic, order), truncated(*metal, order), order);
            Framebuffer dense(context, 64, 48, 3);
            Framebuffer factored(context, 64, 48, 3);
            Renderer dense_renderer(context, 0);
            Renderer factored_renderer(context, 0);
            RenderOptions options{.order_low = order, .order_high = order, .progress = {}};
            const auto check = [&] {
                options.method = Method::dense;
                dense_renderer.render(exact, some_camera, options, dense);
                options.method = Method::factored;
                factored_renderer.render(cut, some_camera, options, factored);
                const double scale = test::rms(factored.image());
                CHECK(scale > 0.1);
                // What remains is the linear interpolation between the angles of the response table, and
                // single vertices whose matrices of shadow lose most to the 16 bits that their entries are
                // kept in.
                CHECK(test::rms_difference(factored.image(), dense.image()) < 1e-5 * scale);
                CHECK(test::largest_difference(factored.image(), dense.image()) < 3e-4 * scale);
            };
            check();
            // Rotated light, then an object elsewhere: what depends on them follows.
            const glm::dmat3 turn = theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -1)));
            for (Scene* scene : {&exact, &cut}) scene->set_environment(scene->environment(), turn, 0.5);
            check();
            const glm::dmat4 moved =
                glm::rotate(glm::translate(glm::dmat4(1), {0, 1, 0}), 0.7, glm::dvec3(1, 1, 0));
            for (Scene* scene : {&exact, &cut}) scene->set_transform(0, moved);
            check();
        }
    });
}

TEST_CASE("dense says what it holds and skips") {
    gl::on_every_backend([](const std::shared_ptr<gl::Context>& context) {
        Scene scene = two_spheres(diffuse({0.5}), diffuse({0.2}), 4);
        scene.set_environment(constant_environment({1.0, 1.0, 1.0}), glm::dmat3(1), 1);
        Framebuffer target(context, 16, 16, 3);
        Renderer renderer(context, 0);
        renderer.render(scene, some_camera, {.method = Method::dense, .progress = {}}, target);
        const Statistics& first = target.statistics();
        const std::uint64_t vertices = first.vertices;
        CHECK(first.transfer_bytes > vertices * 25 * 24 * sizeof(float));
        CHECK(first.transfer_bytes < vertices * 25 * 50 * sizeof(float));
        CHECK(first.response_rows_skipped == 2 * 3 * 3);
        CHECK(first.bake_ms > 0);
        renderer.render(scene, some_camera, {.method = Method::dense, .progress = {}}, target);
        CHECK(target.statistics().bake_ms == 0);
        CHECK(target.statistics().relight_ms == 0);
    });
}
