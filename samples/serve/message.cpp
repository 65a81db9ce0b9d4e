// SPDX-License-Identifier: MIT
#include "message.hpp"

namespace {

struct PackedScene {
    std::uint32_t channels, width, height, up;
    double fov;
    Orbit orbit;
};

}  // namespace

void put_text(std::string& to, const std::string& text) {
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

std::string pack(const Hello& hello) {
    std::string bytes;
    put_text(bytes, hello.renderer);
    for (const std::string& id : hello.scenes) put_text(bytes, id);
    return bytes;
}

bool unpack(std::string_view bytes, Hello& hello) {
    hello = {};
    if (!take_text(bytes, hello.renderer)) return false;
    while (!bytes.empty())
        if (!take_text(bytes, hello.scenes.emplace_back())) return false;
    return true;
}

std::string pack(const Loaded& loaded) {
    const SceneInfo& scene = loaded.info;
    std::string bytes;
    put_text(bytes, scene.id);
    put_text(bytes, scene.digest);
    put_text(bytes, loaded.reason);
    return bytes +=
           bytes_of(PackedScene{scene.channels, scene.width, scene.height, scene.up, scene.fov, scene.orbit});
}

bool unpack(std::string_view bytes, Loaded& loaded) {
    SceneInfo& scene = loaded.info;
    PackedScene packed{};
    if (!take_text(bytes, scene.id) || !take_text(bytes, scene.digest) || !take_text(bytes, loaded.reason) ||
        !take(bytes, packed))
        return false;
    scene.channels = packed.channels;
    scene.width = packed.width;
    scene.height = packed.height;
    scene.up = packed.up;
    scene.fov = packed.fov;
    scene.orbit = packed.orbit;
    return true;
}
