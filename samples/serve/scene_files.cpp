// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <algorithm>

#include "common/failure.hpp"

namespace fs = std::filesystem;

std::vector<fs::path> find_scenes(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> scenes;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ".xml") scenes.push_back(it->path());
    if (error) throw Failure("--scenes: " + folder.string() + ": " + error.message());
    if (scenes.empty()) throw Failure("--scenes: " + folder.string() + ": holds no scene, no file *.xml");
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
    return scenes;
}
