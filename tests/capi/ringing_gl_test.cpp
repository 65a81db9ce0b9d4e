// SPDX-License-Identifier: MIT
// A test of ringing of truncated light in the demonstration scene, and of its removal.
#include "capi.hpp"

using namespace capi_test;

TEST_CASE("de-ringing removes the negative light of the demonstration") {
    const Owned context(make_context(NICOL_BACKEND_EGL));
    const LoadedScene loaded(context, NICOL_TEST_ASSETS "/snail_hdr.xml");
    // A sphere on y = 0 replaces the snail, whose grooves are darker than truncated shadows can represent.
    Owned<nicol_material> material;
    OK(nicol_scene_get_instance(loaded.scene, 0, nullptr, &material, nullptr));
    OK(nicol_scene_remove_instance(loaded.scene, 0));
    add(loaded.scene, Owned(sphere(context)), material, placed(0, 1, 0));
    const Owned framebuffer(framebuffer_of(context, 200, 150, 3));
    nicol_render_options options = plain_options();
    options.order_low = 9;
    options.high_orders = NICOL_HIGH_ORDERS_NONE;
    // Least s0 divided by the mean s0.
    const auto least = [&] {
        OK(nicol_render(loaded.scene, &loaded.camera, &options, framebuffer));
        const std::vector<float> image = read_all(framebuffer);
        float least_s0 = 1;
        double sum = 0;
        for (std::size_t i = 0; i < image.size(); i += 4) {
            least_s0 = std::min(least_s0, image[i]);
            sum += static_cast<double>(image[i]);
        }
        return static_cast<double>(least_s0) / (sum / static_cast<double>(image.size() / 4));
    };

    options.shadows = 0;
    CHECK(least() < -0.02);
    options.dering = 0.003;
    CHECK(least() > 0);

    // Shadows are products of truncated light, too. Slight ringing remains, which clamping to the physically
    // realizable range removes.
    options.shadows = 1;
    const double windowed = least();
    CHECK(windowed > -0.02);
    options.dering = 0;
    CHECK(least() < 2 * windowed);
    options.dering = 0.003;
    options.physical = 1;
    CHECK(least() >= 0);
}
