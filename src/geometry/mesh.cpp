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
#include "geometry/polygon_mesh.hpp"

namespace nicol {
namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Normal of a triangle, its length twice the area. In double, so that rounding does not hide the area of a
/// thin triangle.
glm::dvec3 area_normal(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]);
    return glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
}

bool has_area(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]);
    const glm::dvec3 b(mesh.positions[t.y]);
    const glm::dvec3 c(mesh.positions[t.z]);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return glm::length(area_normal(mesh, t)) > 1e-12 * longest * longest;
}

std::vector<glm::vec3> averaged_normals(const Mesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    std::vector<glm::dvec3> firsts(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 area = area_normal(mesh, t);
        const double length = glm::length(area);
        if (!(length > 0.0)) continue;
        for (glm::length_t i = 0; i < 3; ++i) {
            const glm::dvec3 here(mesh.positions[t[i]]);
            const glm::dvec3 u = glm::dvec3(mesh.positions[t[(i + 1) % 3]]) - here;
            const glm::dvec3 v = glm::dvec3(mesh.positions[t[(i + 2) % 3]]) - here;
            // Twice the area is |u x v| at every corner.
            sums[t[i]] += area / length * std::atan2(length, glm::dot(u, v));
            if (firsts[t[i]] == glm::dvec3(0.0)) firsts[t[i]] = area / length;
        }
    }
    std::vector<glm::vec3> normals(mesh.positions.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const double length = glm::length(sums[v]);
        const bool used = firsts[v] != glm::dvec3(0.0);
        // Of faces that cancel only rounding errors remain.
        normals[v] = glm::vec3(length > 1e-9 ? sums[v] / length
                               : used        ? firsts[v]
                                             : glm::dvec3(0.0, 0.0, 1.0));
    }
    return normals;
}

void complete_normals(Mesh& mesh) {
    std::vector<glm::vec3> smooth;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        // In double: the squares of small and of large floats leave the range of float.
        const double length = glm::length(glm::dvec3(mesh.normals[v]));
        if (length > 0.0) {
            mesh.normals[v] = glm::vec3(glm::dvec3(mesh.normals[v]) / length);
            continue;
        }
        if (smooth.empty()) smooth = averaged_normals(mesh);
        mesh.normals[v] = smooth[v];
    }
}

}  // namespace

void geometry::validate(Mesh& mesh, std::string_view name, std::span<const std::uint32_t> faces) {
    const auto refuse = [&](const std::string& message) {
        throw Error(ErrorCode::invalid_file, std::string(name) + ": " + message);
    };
    const std::size_t count = mesh.positions.size();
    if (count == 0 || mesh.triangles.empty())
        refuse("an empty mesh: " + std::to_string(count) + " vertices and " +
               std::to_string(mesh.triangles.size()) + " faces; it needs at least 3 and 1");
    if (!mesh.normals.empty() && mesh.normals.size() != count)
        refuse(std::to_string(mesh.normals.size()) + " normals for " + std::to_string(count) +
               " vertices; give one each or none at all");
    for (std::size_t v = 0; v < count; ++v) {
        if (!finite(mesh.positions[v])) refuse("vertex " + std::to_string(v) + " (0-based) is not finite");
        if (!mesh.normals.empty() && !finite(mesh.normals[v]))
            refuse("the normal of vertex " + std::to_string(v) + " (0-based) is not finite");
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const std::string face = std::to_string(faces.empty() ? i : faces[i]) + " (0-based)";
        for (glm::length_t k = 0; k < 3; ++k)
            if (t[k] >= count)
                refuse("face " + face + " uses vertex " + std::to_string(t[k]) + ", but there are only " +
                       std::to_string(count));
        if (!has_area(mesh, t))
            refuse("degenerate face " + face +
                   " has no area: two of its corners coincide, or three lie on one line; remove it, for "
                   "instance "
                   "with \"merge by distance\" and \"degenerate dissolve\" of a mesh editor");
    }
    if (mesh.normals.empty())
        smooth_normals(mesh);
    else
        complete_normals(mesh);
}

void validate(Mesh& mesh, std::string_view name) {
    geometry::validate(mesh, name, {});
}

void smooth_normals(Mesh& mesh) {
    mesh.normals = averaged_normals(mesh);
}

Mesh with_face_normals(const Mesh& mesh) {
    Mesh out;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        const glm::vec3 normal(glm::normalize(area_normal(mesh, t)));
        for (glm::length_t i = 0; i < 3; ++i) {
            out.positions.push_back(mesh.positions[t[i]]);
            out.normals.push_back(normal);
        }
        out.triangles.emplace_back(first, first + 1, first + 2);
    }
    return out;
}

void flip_normals(Mesh& mesh) {
    for (glm::vec3& n : mesh.normals) n = -n;
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
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
        if (!finite(p))
            throw Error(ErrorCode::invalid_argument,
                        "a mesh's transform moves vertices out of the range of float");
    }
    for (glm::vec3& n : out.normals) n = glm::vec3(glm::normalize(for_normals * glm::dvec3(n)));
    if (glm::determinant(linear) < 0.0)
        for (glm::uvec3& t : out.triangles) std::swap(t.y, t.z);
    return out;
}

}  // namespace nicol
