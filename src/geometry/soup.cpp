// SPDX-License-Identifier: MIT
// From polygons to indexed triangles.
#include "geometry/soup.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace nicol::geometry {
namespace {

/// Beyond this many corners at one position creases are given up: comparing each with each would take for
/// ever.
constexpr std::size_t max_crease_corners = 512;

glm::dvec3 position(const Soup& soup, std::size_t corner) {
    return glm::dvec3(soup.positions[soup.corners[corner].position]);
}

/// The normal of a polygon, planar or not, its length twice the area (Newell).
glm::dvec3 area_normal(const Soup& soup, std::size_t begin, std::size_t end) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin = position(soup, begin);
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t next = i + 1 == end ? begin : i + 1;
        sum += glm::cross(position(soup, i) - origin, position(soup, next) - origin);
    }
    return sum;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// The corner from which a fan covers the polygon without a flat or a rotated triangle: a quadrilateral with
/// a notch must be cut from the notch. The first corner if there is none.
std::size_t fan_apex(const Soup& soup, std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    // Longer polygons would take n^2 steps; nobody writes them with notches.
    if (n == 3 || n > 64) return 0;
    const glm::dvec3 front = area_normal(soup, begin, end);
    for (std::size_t apex = 0; apex < n; ++apex) {
        bool covers = true;
        for (std::size_t i = 1; i + 1 < n && covers; ++i) {
            const glm::dvec3 a = position(soup, begin + apex);
            const glm::dvec3 b = position(soup, begin + (apex + i) % n) - a;
            const glm::dvec3 c = position(soup, begin + (apex + i + 1) % n) - a;
            covers = glm::dot(glm::cross(b, c), front) > 1e-12 * glm::dot(front, front);
        }
        if (covers) return apex;
    }
    return 0;
}

}  // namespace

void smooth_within_crease(Soup& soup, double degrees) {
    const double least_cosine = std::cos(degrees * std::numbers::pi / 180.0);
    // Of every corner: the normal of its face, and that times the angle of the face there.
    std::vector<glm::dvec3> normals(soup.corners.size());
    std::vector<double> angles(soup.corners.size());
    for (std::size_t f = 0, begin = 0; f < soup.face_ends.size(); begin = soup.face_ends[f++]) {
        const std::size_t end = soup.face_ends[f];
        const glm::dvec3 normal = unit_or_zero(area_normal(soup, begin, end));
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 to_next =
                unit_or_zero(position(soup, i + 1 == end ? begin : i + 1) - position(soup, i));
            const glm::dvec3 to_last =
                unit_or_zero(position(soup, i == begin ? end - 1 : i - 1) - position(soup, i));
            normals[i] = normal;
            angles[i] = std::acos(glm::clamp(glm::dot(to_next, to_last), -1.0, 1.0));
        }
    }
    std::vector<std::vector<std::size_t>> at(soup.positions.size());
    for (std::size_t i = 0; i < soup.corners.size(); ++i) at[soup.corners[i].position].push_back(i);
    for (const std::vector<std::size_t>& corners : at) {
        if (corners.size() > max_crease_corners) continue;
        for (const std::size_t i : corners) {
            glm::dvec3 sum(0.0);
            for (const std::size_t j : corners)
                if (glm::dot(normals[i], normals[j]) >= least_cosine) sum += normals[j] * angles[j];
            soup.corners[i].normal = glm::vec3(unit_or_zero(sum));
        }
    }
}

Mesh triangulated(const Soup& soup, std::vector<std::uint32_t>& faces) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Mesh mesh;
    mesh.positions = soup.positions;
    mesh.normals.assign(soup.positions.size(), glm::vec3(0.0f));
    // The vertices at one position with different normals, as a chain.
    std::vector<std::uint32_t> next(soup.positions.size(), none);
    std::vector<bool> used(soup.positions.size(), false);
    const auto vertex_of = [&](const Soup::Corner& corner) {
        std::uint32_t v = corner.position;
        if (!used[v]) {
            used[v] = true;
            mesh.normals[v] = corner.normal;
            return v;
        }
        while (mesh.normals[v] != corner.normal) {
            if (next[v] == none) {
                next[v] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(soup.positions[corner.position]);
                mesh.normals.push_back(corner.normal);
                next.push_back(none);
            }
            v = next[v];
        }
        return v;
    };
    std::vector<std::uint32_t> polygon;
    for (std::size_t f = 0, begin = 0; f < soup.face_ends.size(); begin = soup.face_ends[f++]) {
        polygon.clear();
        for (std::size_t i = begin; i < soup.face_ends[f]; ++i) polygon.push_back(vertex_of(soup.corners[i]));
        const std::size_t apex = fan_apex(soup, begin, soup.face_ends[f]);
        const std::size_t n = polygon.size();
        for (std::size_t i = 1; i + 1 < n; ++i) {
            mesh.triangles.emplace_back(polygon[apex], polygon[(apex + i) % n], polygon[(apex + i + 1) % n]);
            faces.push_back(static_cast<std::uint32_t>(f));
        }
    }
    return mesh;
}

}  // namespace nicol::geometry
