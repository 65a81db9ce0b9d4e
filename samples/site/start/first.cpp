// SPDX-License-Identifier: MIT
// The first picture from C++.
#include <nicol.hpp>

#include <iostream>

int main() try {
    const auto context = nicol::create<nicol::Context>(nicol_context_create, nullptr);
    const auto scene = nicol::create<nicol::Scene>(nicol_scene_load, context.get(),
                                                   "samples/assets/snail_sky.xml", nullptr, 0U);
    const auto image =
        nicol::create<nicol::Framebuffer>(nicol_framebuffer_create, context.get(), 640U, 480U, 3U);
    nicol_camera camera = NICOL_CAMERA_INIT;
    nicol::check(nicol_scene_get_camera(scene.get(), &camera));
    nicol::check(nicol_render(scene.get(), &camera, nullptr, image.get()));
    nicol::check(nicol_framebuffer_write_exr(image.get(), "first_cpp.exr"));
} catch (const nicol::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
