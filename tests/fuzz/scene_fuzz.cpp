// SPDX-License-Identifier: MIT
// Fuzzer of scene files, without the files that they refer to.
#include <algorithm>

#include "import/load_scene.hpp"
#include "memory_file.hpp"

namespace {

/// Returns whether the scene can be built in milliseconds and without reading other files.
bool is_quick(const nicol::SceneDescription& scene, std::string_view text) {
    return scene.shapes.size() < 4 && scene.files.size() == 1 &&
           text.find("filename") == std::string_view::npos &&
           std::ranges::all_of(scene.shapes,
                               [](const nicol::ShapeDescription& s) {
                                   return s.kind == nicol::ShapeDescription::Kind::rectangle &&
                                          !s.face_normals;
                               }) &&
           !(scene.environment && scene.environment->turbidity > 0);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = "input.xml";
    const std::string_view text = nicol::fuzz::text_of(bytes, size);
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, text);
    nicol::fuzz::may_refuse(file, [&] {
        if (is_quick(nicol::read_mitsuba_scene(file, {}, limits), text))
            static_cast<void>(nicol::load_scene(file, {}, limits));
    });
    return 0;
}
