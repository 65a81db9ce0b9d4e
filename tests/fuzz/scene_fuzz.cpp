// SPDX-License-Identifier: MIT
// Scene files, without the files that they name.
#include <algorithm>

#include "memory_file.hpp"
#include "scene/load_scene.hpp"

namespace {

/// Whether making what the file describes reads nothing else and is a matter of milliseconds.
bool is_quick(const nicol::SceneDescription& scene) {
    const auto names_file = [](const auto& part) { return !part.filename.empty(); };
    return scene.shapes.size() < 4 && scene.files.size() == 1 &&
           std::ranges::all_of(scene.shapes,
                               [](const nicol::ShapeDescription& s) {
                                   return s.kind == nicol::ShapeDescription::Kind::rectangle &&
                                          !s.face_normals;
                               }) &&
           std::ranges::none_of(scene.materials, names_file) &&
           !(scene.emitter && (names_file(*scene.emitter) || scene.emitter->turbidity > 0));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static nicol::fuzz::MemoryFile memory;
    const std::filesystem::path& file = memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        if (is_quick(nicol::read_mitsuba_scene(file, {}))) static_cast<void>(nicol::load_scene(file, {}));
    });
    return 0;
}
