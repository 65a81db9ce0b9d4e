// SPDX-License-Identifier: MIT
// The first picture from C++.
#include <nicol.hpp>

#include <iostream>

int main() try {
    const auto context = nicol::Context::create();
    const auto scene = nicol::Scene::load(context, "samples/assets/snail_sky.xml");
    const auto image = nicol::Framebuffer::create(context, 640, 480, scene.get_channels());
    const nicol_camera camera = scene.get_camera();
    nicol::render(scene, &camera, nullptr, image);
    image.write_exr("first_cpp.exr");
} catch (const nicol::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
