// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "common/failure.hpp"

namespace fs = std::filesystem;

namespace {

bool is_scene(const fs::path& path) {
    const std::string suffix = path.extension();
    return suffix == ".xml" || suffix == ".gltf" || suffix == ".glb";
}

}  // namespace

std::vector<fs::path> find_scenes(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> scenes;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (is_scene(it->path())) scenes.push_back(it->path());
    if (error) throw Failure("--scenes: " + folder.string() + ": " + error.message());
    if (scenes.empty())
        throw Failure("--scenes: " + folder.string() + ": holds no scene, no file *.xml, *.gltf or *.glb");
    for (const fs::path& scene : scenes) {
        const std::string id = scene.stem();
        const bool plain = std::ranges::all_of(id, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                   c == '_' || c == '-';
        });
        if (!plain || id.size() > 64 || id.front() == '.')
            throw Failure("--scenes: " + scene.string() +
                          ": the name must be of letters, digits, '.', '_' and '-', at most 64");
    }
    std::ranges::sort(scenes);
    std::map<std::string, fs::path> by_id;
    for (const fs::path& scene : scenes) {
        const auto [other, is_new] = by_id.emplace(scene.stem(), scene);
        if (!is_new)
            throw Failure("--scenes: " + other->second.string() + " and " + scene.filename().string() +
                          ": scenes must differ in their names without the ending");
    }
    return scenes;
}
