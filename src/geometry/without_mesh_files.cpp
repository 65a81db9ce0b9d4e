// SPDX-License-Identifier: MIT
// Mesh files in builds without them.
#include "files/file_error.hpp"
#include "geometry/mesh.hpp"

namespace nicol {

std::string mesh_format_names() {
    return {};
}

bool is_mesh_format(std::string_view /*name*/) {
    return false;
}

bool holds_several_meshes(const std::filesystem::path& /*file*/) {
    return false;
}

bool has_upward_texcoords(const std::filesystem::path& /*file*/) {
    return false;
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& /*notice*/,
               std::size_t /*shape*/, const LoadBudget& /*budget*/, const MeshColorNames& /*colors*/) {
    refuse_left_out_format(file, "mesh files", "NICOL_MESH_FILES");
}

Mesh load_curves(const std::filesystem::path& file, CurveKind /*kind*/, const glm::dmat3& /*axes*/,
                 const LoadBudget& /*budget*/) {
    refuse_left_out_format(file, "mesh files", "NICOL_MESH_FILES");
}

}  // namespace nicol
