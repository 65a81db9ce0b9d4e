// SPDX-License-Identifier: MIT
// Mesh files; NICOL_FUZZ_MESH is a name that says the format.
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/polygon_mesh.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using nicol::fuzz::require;
    static const std::filesystem::path name = NICOL_FUZZ_MESH;
    nicol::fuzz::may_refuse(name, [&] {
        const nicol::Mesh mesh = nicol::geometry::mesh_of(name, nicol::fuzz::text_of(bytes, size));
        require(mesh.normals.size() == mesh.positions.size(), "a normal for each vertex");
        for (const glm::vec3& n : mesh.normals)
            require(std::abs(glm::length(n) - 1.0F) < 1e-3F, "normals have length 1");
        for (const glm::uvec3& t : mesh.triangles)
            for (glm::length_t i = 0; i < 3; ++i)
                require(t[i] < mesh.positions.size(), "triangles use vertices that exist");
    });
    return 0;
}
