// SPDX-License-Identifier: MIT
// glTF files, text and binary.
#include <cmath>
#include <glm/geometric.hpp>

#include "memory_file.hpp"
#include "scene/scene_description.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using nicol::fuzz::require;
    static nicol::fuzz::MemoryFile memory;
    const std::filesystem::path& file = memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::SceneDescription scene =
            nicol::read_gltf_scene(file, {}, {.vertices = 1 << 16, .triangles = 1 << 16});
        require(!scene.shapes.empty(), "something to draw");
        for (const nicol::ShapeDescription& shape : scene.shapes) {
            require(shape.material < scene.materials.size(), "a material for each shape");
            const nicol::Mesh& mesh = *shape.mesh;
            require(mesh.normals.size() == mesh.positions.size(), "a normal for each vertex");
            for (const glm::vec3& n : mesh.normals)
                require(std::abs(glm::length(n) - 1.0F) < 1e-3F, "normals have length 1");
            for (const glm::uvec3& t : mesh.triangles)
                for (glm::length_t i = 0; i < 3; ++i)
                    require(t[i] < mesh.positions.size(), "triangles use vertices that exist");
        }
    });
    return 0;
}
