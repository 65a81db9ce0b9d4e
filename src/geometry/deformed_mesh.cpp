// SPDX-License-Identifier: MIT
#include "geometry/deformed_mesh.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "geometry/finite.hpp"
#include "geometry/mesh_normals.hpp"

namespace nicol {
namespace {

void check(const std::vector<glm::vec3>& values, const char* what, std::size_t vertices) {
    if (values.size() != vertices)
        refuse(std::to_string(values.size()) + " " + what + "s for a mesh of " + std::to_string(vertices) +
               " vertices; give one for each");
    for (std::size_t v = 0; v < vertices; ++v)
        if (!is_finite(values[v]))
            refuse("the " + std::string(what) + " of vertex " + std::to_string(v) +
                   " (0-based) is not finite");
}

}  // namespace

Mesh deformed(const Mesh& mesh, std::vector<glm::vec3> positions, std::vector<glm::vec3> normals) {
    check(positions, "position", mesh.positions.size());
    if (!normals.empty()) check(normals, "normal", mesh.positions.size());
    Mesh out{.positions = std::move(positions),
             .normals = std::move(normals),
             .triangles = mesh.triangles,
             .colors = mesh.colors,
             .face_colors = mesh.face_colors,
             .texcoords = mesh.texcoords,
             .texcoord_triangles = mesh.texcoord_triangles,
             .tangents = {}};
    if (out.normals.empty())
        smooth_normals(out);
    else
        geometry::complete_normals(out);
    return out;
}

bool same_triangles(const Mesh& a, const Mesh& b) {
    return a.positions.size() == b.positions.size() && a.triangles == b.triangles;
}

}  // namespace nicol
