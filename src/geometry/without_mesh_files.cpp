// SPDX-License-Identifier: MIT
// Mesh files in builds without them.
#include "files/file_error.hpp"
#include "geometry/mesh.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/sdf_grid.hpp"

namespace nicol {

std::span<const MeshFormat* const> mesh_formats() {
    return {};
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& /*notice*/,
               std::size_t /*shape*/, const LoadBudget& /*budget*/, const MeshColorNames& /*colors*/) {
    refuse_left_out_format(file, "mesh files", "NICOL_MESH_FILES");
}

Mesh load_curves(const std::filesystem::path& file, CurveKind /*kind*/, const glm::dmat3& /*axes*/,
                 const LoadBudget& /*budget*/) {
    refuse_left_out_format(file, "mesh files", "NICOL_MESH_FILES");
}

Mesh load_sdf_grid(const std::filesystem::path& file, SdfNormals /*normals*/, const LoadBudget& /*budget*/) {
    refuse_left_out_format(file, "mesh files", "NICOL_MESH_FILES");
}

}  // namespace nicol
