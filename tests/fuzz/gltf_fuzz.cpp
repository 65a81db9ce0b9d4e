// SPDX-License-Identifier: MIT
// Fuzzer of the glTF reader, text and binary.
#include "drawable_mesh.hpp"
#include "import/scene_description.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using nicol::fuzz::require;
    const std::filesystem::path file = "input.gltf";
    nicol::LoadLimits limits = nicol::fuzz::in_memory(file, nicol::fuzz::text_of(bytes, size));
    limits.vertices = limits.triangles = 1 << 16;
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::SceneDescription scene = nicol::read_gltf_scene(file, {}, limits);
        require(!scene.shapes.empty(), "something to draw");
        for (const nicol::ShapeDescription& shape : scene.shapes) {
            require(shape.material < scene.materials.size(), "a material for each shape");
            nicol::fuzz::require_drawable(*shape.mesh);
        }
    });
    return 0;
}
