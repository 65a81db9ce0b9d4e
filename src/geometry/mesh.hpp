// SPDX-License-Identifier: MIT
// Triangle meshes: file reader, analytic shapes, transforms, checks.
#pragma once

#include <compare>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"

namespace nicol {

/// Indexed triangles with one unit normal per vertex. Front faces are counter-clockwise seen from outside.
/// At a hard edge each face has vertices of its own: equal positions, different normals.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< one per position; unit length after validate()
    std::vector<glm::uvec3> triangles;
    /// Colours as in the file; integers become n / 255.
    std::vector<glm::vec3> colors;       ///< colours of vertices: one per position, or empty
    std::vector<glm::vec3> face_colors;  ///< colours of faces: one per triangle, or empty
    /// Texture coordinates u, v as in the file. They have indices of their own because light is stored at
    /// vertices, which a seam of texture coordinates must not split.
    std::vector<glm::vec2> texcoords;
    std::vector<glm::uvec3> texcoord_triangles;  ///< indices into texcoords; empty without texcoords
    /// Tangents, one per texture coordinate, or empty: x, y and z are the x axis of normal maps and of
    /// anisotropic materials, unit after validate(), or 0 where the texture coordinates give that axis. The y
    /// axis is w cross(normal, x); w is 1 or -1.
    std::vector<glm::vec4> tangents;
};

/// Names of the attributes of vertices and of faces that become a mesh's colours. "color": the colours. Any
/// other attribute, of one number or three, is one of PLY: its properties are NAME_0, NAME_1, NAME_2, or with
/// other endings without "_", in this order. Properties NAME_r, NAME_g, NAME_b are the attribute NAME_color.
/// The numbers are those of the file, and one number becomes three equal ones.
struct MeshColorNames {
    std::string vertices = "color";
    std::string faces = "color";
    // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
    auto operator<=>(const MeshColorNames&) const = default;
};

/// Reads Wavefront OBJ, PLY (text, binary), OFF (text), STL (text, binary) or Mitsuba's serialized meshes,
/// chosen by the suffix, see mesh_format.hpp. A serialized file holds several meshes; `shape` (0-based)
/// selects one. Polygons, concave ones too, become triangles. Every face with an area is kept, manifold or
/// not. Triangles without area, vertices without a face, and elements that the reader ignores (materials of
/// OBJ, unknown lines) are left out; one call of `notice` then counts them.
/// - Normals in the file are kept. An OBJ vertex whose corners name different normals is split; apart from
///   this, vertices keep the order of the file.
/// - Missing normals are made by smooth_normals(). For STL, equal positions are merged and normals are smooth
///   over faces that meet at less than kStlCreaseDegrees.
/// `colors` names attributes that become the colours; a file without them gives no colours.
/// Throws Error: file_not_found; unsupported (unknown suffix, UTF-16); invalid_file (truncated, malformed, no
/// triangle with an area), naming the line, vertex or face. Memory use is proportional to the size of the
/// file, whatever its header claims; for deflated files, `budget` limits it.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file,
                             const std::function<void(const std::string&)>& notice = {},
                             std::size_t shape = 0, const LoadBudget& budget = {},
                             const MeshColorNames& colors = {});

/// Crease angle of STL files, in degrees: faces that meet at a larger angle have a hard edge between them.
inline constexpr double kStlCreaseDegrees = 40.0;

/// Checks a mesh and completes its normals; `name` begins every message. All indices are 0-based.
/// - If there are no normals at all, smooth_normals() makes them. A normal of zero length is replaced by the
///   smooth normal there, or by +z if no face uses the vertex. Every normal ends up with unit length.
/// - Tangents get unit length.
/// - Triangles without area (two corners that share a vertex or a position, or three on one line) are
///   removed.
/// Returns the number of removed triangles. Throws Error(invalid_file): no vertices, no triangles with an
/// area, a count of normals or vertex colours that differs from the count of positions, a count of face
/// colours that differs from the count of triangles, texture coordinates at some faces only, a value that is
/// not finite, an index out of range.
std::size_t validate(Mesh& mesh, std::string_view name);

/// Sets normals to the mean of the faces at each vertex, weighted by the face's angle there, so that they do
/// not depend on the triangulation. If the faces cancel, the first face's normal is taken.
void smooth_normals(Mesh& mesh);

/// Returns the triangles with vertices of their own and face normals: every edge is hard. The mesh must have
/// passed validate().
[[nodiscard]] Mesh with_face_normals(const Mesh& mesh);

/// Kinds of the curves of a file.
enum class CurveKind {
    linear,  ///< straight segments with balls at their points
    bspline  ///< uniform cubic B-splines, which end near their second and their last but one point
};
/// Reads curves of Mitsuba's text format, a point and a radius a line and an empty line between curves, as
/// tubes without ends: 48 sides, and 24 rows of each cubic segment. u is the angle around the curve over 2
/// pi, v grows from 0 to 1 along each curve. axes: moves the points; as in Mitsuba, radii stay. Throws
/// Error(invalid_file) that names the line, and what reading throws.
[[nodiscard]] Mesh load_curves(const std::filesystem::path& file, CurveKind kind,
                               const glm::dmat3& axes = glm::dmat3(1), const LoadBudget& budget = {});

/// Replaces v by 1 - v, which converts upward v to v counted from the image's first row downwards.
void flip_texcoords(Mesh& mesh);

/// Swaps front and back: negates normals and reverses the winding.
void flip_normals(Mesh& mesh);

/// Returns the mesh with positions transformed by `to_world` and normals by its inverse transpose. The
/// winding is reversed if `to_world` mirrors, so that the front stays the front. Throws
/// Error(invalid_argument) unless `to_world` is finite and invertible with last row (0, 0, 0, 1).
[[nodiscard]] Mesh transformed(const Mesh& mesh, const glm::dmat4& to_world);

/// Returns the tangents of transformed(); linear: the transform's first three rows and columns.
[[nodiscard]] std::vector<glm::vec4> transformed_tangents(const Mesh& mesh, const glm::dmat3& linear);

/// Parts of each edge of the icosahedron of make_sphere() at detail 1, and the most that readers accept.
inline constexpr int kSphereSegments = 38, kMaxSphereSegments = 512;

/// Returns a sphere of 14,442 vertices: an icosahedron whose edges are cut in kSphereSegments. Vertices lie
/// on the sphere, its points on the coordinate axes among them, and normals are exact. No edge spans more
/// than 2.0 degrees, so shading interpolated between vertices misses a function of order l by at most 1.6e-4
/// l^2 of its amplitude, and the flat triangles lie at most 2.1e-4 radius below the sphere. `detail`, above
/// 0, times kSphereSegments is rounded up to an even number of segments; the errors grow by 1 / detail^2. u
/// is the azimuth about z, from +x towards +y, over 2 pi, and exceeds 1 in triangles that cross the seam; v
/// is the angle from +z over pi. Throws Error(invalid_argument) unless the centre is finite and the radius
/// positive and finite.
[[nodiscard]] Mesh make_sphere(const glm::dvec3& center = glm::dvec3(0.0), double radius = 1.0,
                               double detail = 1.0);

/// Returns the disc of radius 1 at z = 0 with normal +z: 180 sectors of 16 rings, of which `detail` is the
/// part as in make_sphere(). u is the distance from the centre, v the angle from +x towards +y over 2 pi.
[[nodiscard]] Mesh make_disk(double detail = 1.0);

/// Returns the cylinder around the line from p0 to p1, without its ends and with outward normals: 180 sides
/// of 32 rows, of which `detail` is the part as in make_sphere(). At detail 1 the flat sides lie at most
/// 1.6e-4 radius below the cylinder. u is the angle around p1 - p0 over 2 pi, from perpendicular(); v grows
/// from 0 at p0 to 1 at p1. Throws Error(invalid_argument) unless the points are finite and apart, and the
/// radius is positive and finite.
[[nodiscard]] Mesh make_cylinder(const glm::dvec3& p0, const glm::dvec3& p1, double radius,
                                 double detail = 1.0);

/// Returns the square [-1, 1]^2 at z = 0 with normal +z as `cells` x `cells` squares of two triangles; u = (x
/// + 1) / 2, v = (y + 1) / 2. Throws Error(invalid_argument) unless 1 <= cells <= 1024.
[[nodiscard]] Mesh make_rectangle(int cells = 1);

/// Returns the cube [-1, 1]^3 with hard edges and outward normals, each side as make_rectangle(cells). u and
/// v run over 0..1 on each side, in the directions of Mitsuba's cube. Throws Error(invalid_argument) unless 1
/// <= cells <= 1024.
[[nodiscard]] Mesh make_cube(int cells = 1);

}  // namespace nicol
