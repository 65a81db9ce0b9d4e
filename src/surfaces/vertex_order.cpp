// SPDX-License-Identifier: MIT
// Order of the vertices of a scene's surfaces.
#include <map>
#include <memory>
#include <vector>

#include "geometry/block_numbers.hpp"
#include "surfaces/scene_geometry.hpp"

namespace nicol {

void SceneGeometry::order_vertices(std::vector<Piece>& pieces) const {
    // Orders of meshes, each computed from this very mesh, so that a new instance has that of a fresh start.
    std::map<const Mesh*, VertexOrder> known;
    for (const Piece& former : pieces_)
        if (!former.divided && !former.deformed) known.try_emplace(former.mesh.get(), former.order);
    for (Piece& piece : pieces) {
        const std::size_t before = piece.former != kNone ? piece.former : piece.elsewhere;
        if (before != kNone && piece.divided == pieces_[before].divided &&
            (piece.former != kNone || !piece.divided)) {
            const Piece& former = pieces_[before];
            piece.order = former.order;
            piece.deformed = former.deformed || former.mesh != piece.mesh;
            continue;
        }
        const Mesh& mesh = piece.parts();
        const auto order = [&mesh] {
            return std::make_shared<const std::vector<std::uint32_t>>(
                block_numbers(mesh.positions, mesh.normals));
        };
        if (piece.divided) {
            piece.order = order();
            continue;
        }
        VertexOrder& of_mesh = known[&mesh];
        if (of_mesh == nullptr) of_mesh = order();
        piece.order = of_mesh;
    }
}

}  // namespace nicol
