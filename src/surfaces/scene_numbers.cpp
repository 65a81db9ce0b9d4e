// SPDX-License-Identifier: MIT
// Order of the vertices of a scene's surfaces.
#include <map>
#include <memory>
#include <vector>

#include "geometry/block_numbers.hpp"
#include "surfaces/scene_geometry.hpp"

namespace nicol {

void SceneGeometry::number(std::vector<Piece>& pieces) const {
    std::map<const Mesh*, Numbers> known;
    for (const Piece& former : pieces_)
        if (!former.divided) known.try_emplace(former.mesh.get(), former.numbers);
    for (Piece& piece : pieces) {
        const std::size_t before = piece.former != kNone ? piece.former : piece.elsewhere;
        // A deformed mesh keeps its numbers, so that its vertices can be followed.
        if (before != kNone && piece.divided == pieces_[before].divided &&
            (piece.former != kNone || !piece.divided)) {
            piece.numbers = pieces_[before].numbers;
            continue;
        }
        const Mesh& mesh = piece.parts();
        const auto numbers = [&mesh] {
            return std::make_shared<const std::vector<std::uint32_t>>(
                block_numbers(mesh.positions, mesh.normals));
        };
        if (piece.divided) {
            piece.numbers = numbers();
            continue;
        }
        Numbers& of_mesh = known[&mesh];
        if (of_mesh == nullptr) of_mesh = numbers();
        piece.numbers = of_mesh;
    }
}

}  // namespace nicol
