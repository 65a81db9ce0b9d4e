// SPDX-License-Identifier: MIT
// Parsers of mesh files.
#pragma once

#include <cstddef>
#include <string_view>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {

// `name` begins every message. All throw Error(invalid_file), or Error(unsupported) for a well-formed file
// that holds something other than polygons; the message names the line, vertex or face (0-based). Indices of
// the result are in range, positions finite, normals finite or zero. What has no meaning here is counted in
// `left_out`. Memory is proportional to the bytes, whatever they claim. `budget` is asked at every
// line, vertex or face.

/// v, vt, vn and f. Three numbers behind a position are its colour.
[[nodiscard]] PolygonMesh parse_obj(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Of the vertices x y z, nx ny nz, u v (or s t, texture_u texture_v) and red green blue (or r g b; integers
/// are n / 255); of the faces vertex_indices, at their corners texcoord, and colours by the same names.
[[nodiscard]] PolygonMesh parse_ply(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Text, with normals (N), colours (C) and texture coordinates (ST) of vertices, and colours of faces, white
/// where a face has none and others have.
[[nodiscard]] PolygonMesh parse_off(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// Text or binary. Equal positions are merged; normals follow from the triangles, see crease_normals.hpp.
[[nodiscard]] PolygonMesh parse_stl(std::string_view name, std::string_view bytes, LeftOut& left_out,
                                    const LoadBudget& budget);
/// One of the meshes of a file of Mitsuba's, 0-based. Texture coordinates and colours that are not finite
/// stay.
[[nodiscard]] PolygonMesh parse_serialized(std::string_view name, std::string_view bytes, std::size_t shape,
                                           LeftOut& left_out, const LoadBudget& budget);

}  // namespace nicol::geometry
