// SPDX-License-Identifier: MIT
#include "geometry/polygon_mesh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace nicol::geometry {
namespace {

/// Positions with more corners than this keep no creases: the comparison is quadratic in the corners.
constexpr std::size_t kMaxCreaseCorners = 512;

glm::dvec3 position(const PolygonMesh& polygons, std::size_t corner) {
    return {polygons.positions[polygons.corners[corner].position]};
}

/// The normal of a polygon, planar or not, its length twice the area (Newell).
glm::dvec3 area_normal(const PolygonMesh& polygons, std::size_t begin, std::size_t end) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin = position(polygons, begin);
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t next = i + 1 == end ? begin : i + 1;
        sum += glm::cross(position(polygons, i) - origin, position(polygons, next) - origin);
    }
    return sum;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// The corner from which a fan covers the polygon without flat or flipped triangles: for a concave
/// quadrilateral, its reflex corner. The first corner if there is none.
std::size_t fan_apex(const PolygonMesh& polygons, std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    // The search is quadratic; long polygons are rarely concave.
    if (n == 3 || n > 64) return 0;
    const glm::dvec3 front = area_normal(polygons, begin, end);
    for (std::size_t apex = 0; apex < n; ++apex) {
        bool covers = true;
        for (std::size_t i = 1; i + 1 < n && covers; ++i) {
            const glm::dvec3 a = position(polygons, begin + apex);
            const glm::dvec3 b = position(polygons, begin + (apex + i) % n) - a;
            const glm::dvec3 c = position(polygons, begin + (apex + i + 1) % n) - a;
            covers = glm::dot(glm::cross(b, c), front) > 1e-12 * glm::dot(front, front);
        }
        if (covers) return apex;
    }
    return 0;
}

}  // namespace

void smooth_within_crease(PolygonMesh& polygons, double degrees) {
    const double least_cosine = std::cos(degrees * std::numbers::pi / 180.0);
    // Of every corner: the normal of its face, and that times the angle of the face there.
    std::vector<glm::dvec3> normals(polygons.corners.size());
    std::vector<double> angles(polygons.corners.size());
    for (std::size_t f = 0, begin = 0; f < polygons.face_ends.size(); begin = polygons.face_ends[f++]) {
        const std::size_t end = polygons.face_ends[f];
        const glm::dvec3 normal = unit_or_zero(area_normal(polygons, begin, end));
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 to_next =
                unit_or_zero(position(polygons, i + 1 == end ? begin : i + 1) - position(polygons, i));
            const glm::dvec3 to_last =
                unit_or_zero(position(polygons, i == begin ? end - 1 : i - 1) - position(polygons, i));
            normals[i] = normal;
            angles[i] = std::acos(glm::clamp(glm::dot(to_next, to_last), -1.0, 1.0));
        }
    }
    std::vector<std::vector<std::size_t>> at(polygons.positions.size());
    for (std::size_t i = 0; i < polygons.corners.size(); ++i) at[polygons.corners[i].position].push_back(i);
    for (const std::vector<std::size_t>& corners : at) {
        if (corners.size() > kMaxCreaseCorners) continue;
        for (const std::size_t i : corners) {
            glm::dvec3 sum(0.0);
            for (const std::size_t j : corners)
                if (glm::dot(normals[i], normals[j]) >= least_cosine) sum += normals[j] * angles[j];
            polygons.corners[i].normal = glm::vec3(unit_or_zero(sum));
        }
    }
}

Mesh triangulated(const PolygonMesh& polygons, std::vector<std::uint32_t>& faces) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Mesh mesh;
    mesh.positions = polygons.positions;
    mesh.normals.assign(polygons.positions.size(), glm::vec3(0.0f));
    // The vertices at one position with different normals, as a linked list.
    std::vector<std::uint32_t> next(polygons.positions.size(), none);
    std::vector<bool> used(polygons.positions.size(), false);
    const auto vertex_of = [&](const PolygonMesh::Corner& corner) {
        std::uint32_t v = corner.position;
        if (!used[v]) {
            used[v] = true;
            mesh.normals[v] = corner.normal;
            return v;
        }
        while (mesh.normals[v] != corner.normal) {
            if (next[v] == none) {
                next[v] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(polygons.positions[corner.position]);
                mesh.normals.push_back(corner.normal);
                next.push_back(none);
            }
            v = next[v];
        }
        return v;
    };
    std::vector<std::uint32_t> polygon;
    for (std::size_t f = 0, begin = 0; f < polygons.face_ends.size(); begin = polygons.face_ends[f++]) {
        polygon.clear();
        for (std::size_t i = begin; i < polygons.face_ends[f]; ++i)
            polygon.push_back(vertex_of(polygons.corners[i]));
        const std::size_t apex = fan_apex(polygons, begin, polygons.face_ends[f]);
        const std::size_t n = polygon.size();
        for (std::size_t i = 1; i + 1 < n; ++i) {
            mesh.triangles.emplace_back(polygon[apex], polygon[(apex + i) % n], polygon[(apex + i + 1) % n]);
            faces.push_back(static_cast<std::uint32_t>(f));
        }
    }
    return mesh;
}

}  // namespace nicol::geometry
