// SPDX-License-Identifier: MIT
// Triangle meshes: files, analytic shapes, transforms, checks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"

namespace nicol {

/// Indexed triangles with one unit normal per vertex. Front faces are counter-clockwise seen from outside.
/// At a hard edge each face has vertices of its own: equal positions, different normals.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< as many as positions; unit length after validate()
    std::vector<glm::uvec3> triangles;
    /// As a file has them, integers n / 255.
    std::vector<glm::vec3> colors;       ///< of the vertices: as many as positions, or empty
    std::vector<glm::vec3> face_colors;  ///< as many as triangles, or empty
    /// u, v as a file has them. Light lives at vertices, which a seam of texture coordinates does not split:
    std::vector<glm::vec2> texcoords;
    std::vector<glm::uvec3> texcoord_triangles;  ///< of these, by triangle; none without texcoords
};

/// Reads Wavefront OBJ, PLY (text, binary), OFF (text), STL (text, binary) or Mitsuba's serialized meshes, of
/// which a file has several (`shape`, 0-based, is one of them), chosen by the suffix. Polygons,
/// concave ones too, become triangles. Every face with an area is kept, manifold or not; triangles without
/// one, vertices of no face, and what is not followed (materials of OBJ, unknown lines) are left out: one
/// call of `notice` then counts them.
/// - Normals in the file are kept. An OBJ vertex whose corners name different normals is split; the order of
///   the vertices is otherwise the file's.
/// - Missing normals are made by smooth_normals(). For STL, equal positions are merged and normals are smooth
///   over faces that meet at less than kStlCreaseDegrees.
/// Throws Error: file_not_found; unsupported (unknown suffix, UTF-16); invalid_file (truncated, malformed, no
/// triangle with an area), naming the line, vertex or face. Memory use is proportional to the size of the
/// file, whatever its header claims; of deflated ones, of what `budget` has.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file,
                             const std::function<void(const std::string&)>& notice = {},
                             std::size_t shape = 0, const LoadBudget& budget = {});

/// Faces of an STL file that meet at a larger angle have a hard edge between them.
inline constexpr double kStlCreaseDegrees = 40.0;

/// Checks a mesh and completes its normals; `name` begins every message. All indices are 0-based.
/// - No normals at all: smooth_normals() makes them. A normal of zero length is replaced by the smooth one
///   there (by +z where no face uses the vertex). Every normal ends up with unit length.
/// Triangles without area (two corners that share a vertex or a position, or three on one line) are removed;
/// returns how many. Throws Error(invalid_file): no vertices, no triangles with an area, a count of normals
/// or colours that is not the count of positions (of triangles, for those of faces), texture coordinates at
/// some faces only, a value that is not finite, an index out of range.
std::size_t validate(Mesh& mesh, std::string_view name);

/// Normals averaged over the faces at each vertex, weighted by the face's angle there, so that they do not
/// depend on the triangulation. Where faces cancel, the normal of the first.
void smooth_normals(Mesh& mesh);

/// The same triangles with vertices of their own and face normals: every edge is hard. The mesh must have
/// passed validate().
[[nodiscard]] Mesh with_face_normals(const Mesh& mesh);

/// Whether files of this kind count v from an image's last row upwards: OBJ, as Mitsuba takes it.
[[nodiscard]] bool has_upward_texcoords(const std::filesystem::path& file);

/// v becomes 1 - v: counted from the image's first row downwards where it was upwards.
void flip_texcoords(Mesh& mesh);

/// Swaps front and back: normals negated, winding reversed.
void flip_normals(Mesh& mesh);

/// Positions by `to_world`, normals by its inverse transpose; the winding is reversed where `to_world`
/// mirrors, so that the front stays
/// the front. Throws Error(invalid_argument) unless `to_world` is finite and
/// invertible with last row (0, 0, 0, 1).
[[nodiscard]] Mesh transformed(const Mesh& mesh, const glm::dmat4& to_world);

/// A sphere of 14,442 vertices: an icosahedron whose edges are cut in 38. Vertices lie on the sphere, its
/// points on the coordinate axes among them, and normals are exact. No edge spans more than 2.0 degrees, so
/// shading interpolated between vertices misses a function of order l by at most 1.6e-4 l^2 of its amplitude,
/// and the flat triangles lie at most 2.1e-4 radius below the sphere. u is the azimuth about z, from +x
/// towards +y, over 2 pi, and exceeds 1 in triangles that cross the seam; v is the angle from +z over pi.
/// Throws Error(invalid_argument) unless the centre is finite and the radius positive and finite.
[[nodiscard]] Mesh make_sphere(const glm::dvec3& center = glm::dvec3(0.0), double radius = 1.0);

/// The disc of radius 1 at z = 0 with normal +z: 180 sectors of 16 rings. u is the distance from the centre,
/// v the angle from +x towards +y over 2 pi.
[[nodiscard]] Mesh make_disk();

/// The cylinder around the line from p0 to p1, without its ends and with outward normals: 180 sides of 32
/// rows, whose flat sides lie at most 1.6e-4 radius below it. u is the angle around p1 - p0 over 2 pi, from
/// perpendicular(), v grows from 0 at p0 to 1 at p1. Throws Error(invalid_argument) unless
/// the points are finite and apart, and the radius is positive and finite.
[[nodiscard]] Mesh make_cylinder(const glm::dvec3& p0, const glm::dvec3& p1, double radius);

/// The square [-1, 1]^2 at z = 0 with normal +z as `cells` x `cells` squares of two triangles; u = (x + 1) /
/// 2, v = (y + 1) / 2. Throws Error(invalid_argument) unless 1 <= cells <= 1024.
[[nodiscard]] Mesh make_rectangle(int cells = 1);

/// The cube [-1, 1]^3 with hard edges and outward normals, each side as make_rectangle(cells). u and v run
/// over 0..1 on each side, in the directions of Mitsuba's cube. Throws Error(invalid_argument) unless 1 <=
/// cells <= 1024.
[[nodiscard]] Mesh make_cube(int cells = 1);

}  // namespace nicol
