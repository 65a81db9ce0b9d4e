// SPDX-License-Identifier: MIT
#include "message.hpp"

namespace {

struct PackedScene {
    std::uint32_t channels, width, height, up;
    double fov;
    Orbit orbit;
};

void put(std::string& to, const std::string& text) {
    to += bytes_of(static_cast<std::uint32_t>(text.size()));
    to += text;
}

bool take_text(std::string_view& from, std::string& into) {
    std::uint32_t length = 0;
    if (!take(from, length) || from.size() < length) return false;
    into = from.substr(0, length);
    from.remove_prefix(length);
    return true;
}

}  // namespace

std::string pack(const Hello& hello) {
    std::string bytes;
    put(bytes, hello.renderer);
    for (const SceneInfo& scene : hello.scenes) {
        put(bytes, scene.id);
        put(bytes, scene.digest);
        bytes += bytes_of(
            PackedScene{scene.channels, scene.width, scene.height, scene.up, scene.fov, scene.orbit});
    }
    return bytes;
}

bool unpack(std::string_view bytes, Hello& hello) {
    hello = {};
    if (!take_text(bytes, hello.renderer)) return false;
    while (!bytes.empty()) {
        SceneInfo scene;
        PackedScene packed{};
        if (!take_text(bytes, scene.id) || !take_text(bytes, scene.digest) || !take(bytes, packed))
            return false;
        scene.channels = packed.channels;
        scene.width = packed.width;
        scene.height = packed.height;
        scene.up = packed.up;
        scene.fov = packed.fov;
        scene.orbit = packed.orbit;
        hello.scenes.push_back(scene);
    }
    return true;
}
