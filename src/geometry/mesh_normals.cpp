// SPDX-License-Identifier: MIT
#include "geometry/mesh_normals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace nicol {
namespace {

/// Returns the normal of a triangle; its length is twice the area. Double precision is needed because
/// rounding to float hides the area of a thin triangle.
glm::dvec3 area_normal(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]);
    return glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
}

bool is_flat(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]);
    const glm::dvec3 b(mesh.positions[t.y]);
    const glm::dvec3 c(mesh.positions[t.z]);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return !(glm::length(area_normal(mesh, t)) > 1e-12 * longest * longest);
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
            const std::uint32_t at = t[i];
            // |u x v| is twice the area at every corner.
            sums[at] += area / length * std::atan2(length, glm::dot(u, v));
            if (firsts[at] == glm::dvec3(0.0)) firsts[at] = area / length;
        }
    }
    std::vector<glm::vec3> normals(mesh.positions.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const double length = glm::length(sums[v]);
        const bool used = firsts[v] != glm::dvec3(0.0);
        // Only rounding errors remain if the faces cancel.
        normals[v] = glm::vec3(length > 1e-9 ? sums[v] / length
                               : used        ? firsts[v]
                                             : glm::dvec3(0.0, 0.0, 1.0));
    }
    return normals;
}

}  // namespace

std::size_t geometry::remove_flat_triangles(Mesh& mesh) {
    const std::size_t before = mesh.triangles.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < before; ++i) {
        if (is_flat(mesh, mesh.triangles[i])) continue;
        mesh.triangles[kept] = mesh.triangles[i];
        if (!mesh.texcoord_triangles.empty()) mesh.texcoord_triangles[kept] = mesh.texcoord_triangles[i];
        if (!mesh.face_colors.empty()) mesh.face_colors[kept] = mesh.face_colors[i];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (!mesh.texcoord_triangles.empty()) mesh.texcoord_triangles.resize(kept);
    if (!mesh.face_colors.empty()) mesh.face_colors.resize(kept);
    return before - kept;
}

void geometry::complete_normals(Mesh& mesh) {
    std::vector<glm::vec3> smooth;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        // Double precision is needed because the squares of small and of large floats leave the range of
        // float.
        const double length = glm::length(glm::dvec3(mesh.normals[v]));
        if (length > 0.0) {
            mesh.normals[v] = glm::vec3(glm::dvec3(mesh.normals[v]) / length);
            continue;
        }
        if (smooth.empty()) smooth = averaged_normals(mesh);
        mesh.normals[v] = smooth[v];
    }
}

void smooth_normals(Mesh& mesh) {
    mesh.normals = averaged_normals(mesh);
}

Mesh with_face_normals(const Mesh& mesh) {
    Mesh out;
    out.texcoords = mesh.texcoords;
    out.texcoord_triangles = mesh.texcoord_triangles;
    out.tangents = mesh.tangents;
    out.face_colors = mesh.face_colors;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        const glm::vec3 normal(glm::normalize(area_normal(mesh, t)));
        for (glm::length_t i = 0; i < 3; ++i) {
            out.positions.push_back(mesh.positions[t[i]]);
            out.normals.push_back(normal);
            if (!mesh.colors.empty()) out.colors.push_back(mesh.colors[t[i]]);
        }
        out.triangles.emplace_back(first, first + 1, first + 2);
    }
    return out;
}

}  // namespace nicol
