// SPDX-License-Identifier: MIT
#include "geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "error.hpp"
#include "geometry/finite.hpp"
#include "geometry/mesh_normals.hpp"

namespace nicol {
namespace {

/// Reverses the winding of every triangle.
void reverse(Mesh& mesh) {
    for (std::vector<glm::uvec3>* triangles : {&mesh.triangles, &mesh.texcoord_triangles})
        for (glm::uvec3& t : *triangles) std::swap(t.y, t.z);
}

[[noreturn]] void refuse(std::string_view name, const std::string& message) {
    throw Error(ErrorCode::invalid_file, std::string(name) + ": " + message);
}

/// Throws Error(invalid_file) unless there is one value per vertex or face, or no value at all.
void check_count(std::size_t values, const char* what, std::size_t count, const char* of,
                 std::string_view name) {
    if (values != 0 && values != count)
        refuse(name, std::to_string(values) + " " + what + " for " + std::to_string(count) + " " + of +
                         "; give one each or none at all");
}

template <class Vector>
void check_finite(const std::vector<Vector>& values, const char* what, std::string_view name) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!is_finite(values[i])) refuse(name, what + std::to_string(i) + " (0-based) is not finite");
}

void check_vertices(const Mesh& mesh, std::string_view name) {
    const std::size_t count = mesh.positions.size();
    if (count == 0 || mesh.triangles.empty())
        refuse(name, "an empty mesh: " + std::to_string(count) + " vertices and " +
                         std::to_string(mesh.triangles.size()) + " faces; it needs at least 3 and 1");
    check_count(mesh.normals.size(), "normals", count, "vertices", name);
    check_count(mesh.colors.size(), "colours", count, "vertices", name);
    check_count(mesh.face_colors.size(), "colours", mesh.triangles.size(), "faces", name);
    check_finite(mesh.positions, "vertex ", name);
    check_finite(mesh.normals, "the normal of vertex ", name);
    check_finite(mesh.colors, "the colour of vertex ", name);
    check_finite(mesh.face_colors, "the colour of face ", name);
    check_finite(mesh.texcoords, "texture coordinate ", name);
    check_finite(mesh.tangents, "the tangent of texture coordinate ", name);
}

void check_indices(const std::vector<glm::uvec3>& triangles, std::size_t count, const char* what,
                   std::string_view name) {
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (glm::length_t k = 0; k < 3; ++k)
            if (triangles[i][k] >= count)
                refuse(name, "face " + std::to_string(i) + " (0-based) uses " + what +
                                 std::to_string(triangles[i][k]) + ", but there are only " +
                                 std::to_string(count));
}

}  // namespace

std::size_t validate(Mesh& mesh, std::string_view name) {
    check_vertices(mesh, name);
    check_indices(mesh.triangles, mesh.positions.size(), "vertex ", name);
    const std::size_t with_texcoords = mesh.texcoord_triangles.size();
    if (with_texcoords != mesh.triangles.size() && with_texcoords + mesh.texcoords.size() != 0)
        refuse(name, "texture coordinates at " + std::to_string(with_texcoords) + " faces of " +
                         std::to_string(mesh.triangles.size()) + "; give them at each or at none");
    check_indices(mesh.texcoord_triangles, mesh.texcoords.size(), "texture coordinate ", name);
    mesh.tangents = transformed_tangents(mesh, glm::dmat3(1.0));
    const std::size_t flat = geometry::remove_flat_triangles(mesh);
    if (mesh.triangles.empty())
        refuse(name,
               "none of the " + std::to_string(flat) + " triangles has an area; a mesh needs one that has");
    if (mesh.normals.empty())
        smooth_normals(mesh);
    else
        geometry::complete_normals(mesh);
    return flat;
}

void flip_texcoords(Mesh& mesh) {
    for (glm::vec2& uv : mesh.texcoords) uv.y = 1 - uv.y;
}

void flip_normals(Mesh& mesh) {
    for (glm::vec3& n : mesh.normals) n = -n;
    for (glm::vec4& t : mesh.tangents) t.w = -t.w;
    reverse(mesh);
}

std::vector<glm::vec4> transformed_tangents(const Mesh& mesh, const glm::dmat3& linear) {
    const float side = glm::determinant(linear) < 0.0 ? -1.0F : 1.0F;
    std::vector<glm::vec4> out;
    out.reserve(mesh.tangents.size());
    for (const glm::vec4& tangent : mesh.tangents) {
        const glm::dvec3 along = linear * glm::dvec3(tangent);
        const double length = glm::length(along);
        out.emplace_back(length > 0 ? along / length : along, tangent.w < 0 ? -side : side);
    }
    return out;
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& to_world) {
    const glm::dmat3 linear(to_world);
    const double volume = std::abs(glm::determinant(linear));
    const double box = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    bool valid = std::isfinite(box) && volume > 1e-12 * box;
    for (glm::length_t i = 0; i < 4; ++i)
        valid = valid && std::isfinite(to_world[3][i]) && to_world[i][3] == (i == 3 ? 1.0 : 0.0);
    if (!valid)
        throw Error(ErrorCode::invalid_argument,
                    "a mesh's transform must be finite, invertible and affine (last row 0 0 0 1)");
    Mesh out = mesh;
    const glm::dmat3 for_normals = glm::transpose(glm::inverse(linear));
    for (glm::vec3& p : out.positions) {
        p = glm::vec3(to_world * glm::dvec4(p, 1.0));
        if (!is_finite(p))
            throw Error(ErrorCode::invalid_argument,
                        "a mesh's transform moves vertices out of the range of float");
    }
    for (glm::vec3& n : out.normals) n = glm::vec3(glm::normalize(for_normals * glm::dvec3(n)));
    out.tangents = transformed_tangents(mesh, linear);
    if (glm::determinant(linear) < 0.0) reverse(out);
    return out;
}

}  // namespace nicol
