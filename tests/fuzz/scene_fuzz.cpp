// SPDX-License-Identifier: MIT
// Fuzzer of scene files, without the files that they refer to.
#include <algorithm>

#include "import/load_scene.hpp"
#include "memory_file.hpp"

namespace {

bool is_image(const nicol::TextureSpecificationPtr& texture) {
    return texture && !texture->filename.empty();
}

bool has_image(const nicol::MaterialDescription& material) {
    return is_image(material.reflectance.texture) || is_image(material.diffuse_reflectance.texture) ||
           is_image(material.specular_reflectance.texture) || is_image(material.alpha_texture) ||
           is_image(material.scale.texture) || is_image(material.texture) ||
           std::ranges::any_of(material.parts, [](const nicol::MaterialDescription& part) {
               return !part.filename.empty() || has_image(part);
           });
}

/// Returns whether the scene can be built in milliseconds and without reading other files.
bool is_quick(const nicol::SceneDescription& scene) {
    const auto names_file = [](const auto& part) { return !part.filename.empty(); };
    return scene.shapes.size() < 4 && scene.files.size() == 1 &&
           std::ranges::all_of(scene.shapes,
                               [](const nicol::ShapeDescription& s) {
                                   return s.kind == nicol::ShapeDescription::Kind::rectangle &&
                                          !s.face_normals &&
                                          !(s.emission && is_image(s.emission->radiance.texture));
                               }) &&
           std::ranges::none_of(
               scene.lights, [](const nicol::LightDescription& light) { return is_image(light.texture); }) &&
           std::ranges::none_of(scene.materials, names_file) &&
           std::ranges::none_of(scene.materials, has_image) &&
           !(scene.environment && (names_file(*scene.environment) || scene.environment->turbidity > 0));
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
