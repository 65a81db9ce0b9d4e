// SPDX-License-Identifier: MIT
// Parsers of mesh files.
#pragma once

#include <cstddef>
#include <string_view>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {

// `name` begins every message. All parsers throw Error(invalid_file), or Error(unsupported) for a well-formed
// file that holds something other than polygons; the message names the line, vertex or face (0-based).
// Indices of the result are in range, positions finite, normals finite or zero. Ignored elements are counted
// in `left_out`. Memory is proportional to the bytes, whatever they claim. Parsers call `budget` at every
// line, vertex or face.

/// Parses Wavefront OBJ: v, vt, vn and f. Three numbers behind a position are its colour.
[[nodiscard]] PolygonMesh parse_obj(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Parses PLY. Vertices: x y z, nx ny nz, u v (or s t, texture_u texture_v) and red green blue (or r g b;
/// integers are n / 255). Faces: vertex_indices, texcoord at their corners, and colours by the names that
/// vertices use. `colors` may name other attributes that become the colours.
[[nodiscard]] PolygonMesh parse_ply(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget, const MeshColorNames& colors = {});
/// Parses text OFF with normals (N), colours (C) and texture coordinates (ST) of vertices, and colours of
/// faces. A face without a colour is white if other faces have one.
[[nodiscard]] PolygonMesh parse_off(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Parses text or binary STL. Equal positions are merged; normals follow from the triangles, see
/// crease_normals.hpp.
[[nodiscard]] PolygonMesh parse_stl(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Parses mesh `shape` (0-based) of a serialized file of Mitsuba's. Texture coordinates and colours that are
/// not finite stay.
[[nodiscard]] PolygonMesh parse_serialized(std::string_view name, std::string_view bytes, std::size_t shape,
                                           LeftOut& left_out, const LoadBudget& budget);

}  // namespace nicol::geometry
