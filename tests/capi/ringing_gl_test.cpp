// SPDX-License-Identifier: MIT
// Ringing of truncated light under the light of the demonstration, and what removes it.
#include <algorithm>

#include "capi.hpp"

using namespace capi_test;

TEST_CASE("de-ringing removes the negative light of the demonstration") {
    const nicol_context context = make_context(NICOL_BACKEND_EGL);
    nicol_scene scene = nullptr;
    OK(nicol_scene_load(context, NICOL_TEST_ASSETS "/snail_hdr.xml", nullptr, 0, &scene));
    // A sphere in place of the snail, whose grooves are darker than truncated shadows can hold.
    nicol_instance sphere = NICOL_INSTANCE_INIT;
    OK(nicol_scene_get_instance(scene, 0, nullptr, &sphere.material, nullptr));
    OK(nicol_mesh_create_sphere(context, &sphere.mesh));
    for (int i = 0; i < 4; ++i) sphere.to_world[5 * i] = 1;
    sphere.to_world[7] = 1;  // standing on y = 0
    OK(nicol_scene_remove_instance(scene, 0));
    OK(nicol_scene_add_instance(scene, &sphere, nullptr));
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_scene_get_camera(scene, &camera));
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, 200, 150, 3, &framebuffer));
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.order_low = 9;
    options.high_orders = NICOL_HIGH_ORDERS_NONE;
    // The least s0 over the mean.
    const auto least = [&] {
        OK(nicol_render(scene, &camera, &options, framebuffer));
        const std::vector<float> image = read_all(framebuffer);
        float least_s0 = 1;
        double sum = 0;
        for (std::size_t i = 0; i < image.size(); i += 4) {
            least_s0 = std::min(least_s0, image[i]);
            sum += static_cast<double>(image[i]);
        }
        return static_cast<double>(least_s0) / (sum / static_cast<double>(image.size() / 4));
    };

    options.shadows = -1;
    CHECK(least() < -0.02);
    options.dering = 0.003;
    CHECK(least() > 0);

    // Shadows are products of truncated light, too: a little is left, for the physical range to take.
    options.shadows = 1;
    const double windowed = least();
    CHECK(windowed > -0.02);
    options.dering = 0;
    CHECK(least() < 2 * windowed);
    options.dering = 0.003;
    options.physical = 1;
    CHECK(least() >= 0);

    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_mesh_release(sphere.mesh));
    OK(nicol_material_release(sphere.material));
    OK(nicol_scene_release(scene));
    OK(nicol_context_release(context));
}
