// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "error.hpp"
#include "geometry/mesh.hpp"

namespace nicol {
namespace {

// Half the number of parts of an icosahedron's edge, at full detail.
constexpr double kHalfEdge = kSphereSegments / 2.0;

constexpr double kGolden = std::numbers::phi;

const std::array<glm::dvec3, 12> kIcosahedronCorners = {{{0, 1, kGolden},
                                                         {0, -1, kGolden},
                                                         {0, 1, -kGolden},
                                                         {0, -1, -kGolden},
                                                         {1, kGolden, 0},
                                                         {-1, kGolden, 0},
                                                         {1, -kGolden, 0},
                                                         {-1, -kGolden, 0},
                                                         {kGolden, 0, 1},
                                                         {kGolden, 0, -1},
                                                         {-kGolden, 0, 1},
                                                         {-kGolden, 0, -1}}};

/// Points on the unit sphere and triangles over them; no point is repeated.
class Icosphere {
public:
    /// cuts: number of parts of an icosahedron's edge. It must be even, so that the middle of each edge is a
    /// vertex; six of these middles are the points on the axes.
    explicit Icosphere(std::uint32_t cuts) : cuts_(cuts) {
        for (const glm::dvec3& corner : kIcosahedronCorners) points.push_back(glm::normalize(corner));
        // Corners of one face are 2 apart, all other corners further.
        const auto adjacent = [](std::uint32_t a, std::uint32_t b) {
            return glm::distance(kIcosahedronCorners[a], kIcosahedronCorners[b]) < 2.1;
        };
        for (std::uint32_t a = 0; a < 12; ++a)
            for (std::uint32_t b = a + 1; b < 12; ++b)
                for (std::uint32_t c = b + 1; c < 12; ++c) {
                    if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(c, a)) continue;
                    const glm::dvec3 normal = glm::cross(points[b] - points[a], points[c] - points[a]);
                    glm::dot(normal, points[a]) > 0.0 ? cut_face(a, b, c) : cut_face(a, c, b);
                }
    }

    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;

private:
    /// Returns the point `i` steps from `a` on the edge to `b`; both faces at the edge get one index.
    std::uint32_t on_edge(std::uint32_t a, std::uint32_t b, std::uint32_t i) {
        if (a > b) return on_edge(b, a, cuts_ - i);
        if (i == 0) return a;
        if (i == cuts_) return b;
        const auto [first, is_new] = edges_.try_emplace({a, b}, static_cast<std::uint32_t>(points.size()));
        if (is_new) {
            for (std::uint32_t k = 1; k < cuts_; ++k)
                points.push_back(glm::normalize(kIcosahedronCorners[a] * double(cuts_ - k) +
                                                kIcosahedronCorners[b] * double(k)));
        }
        return first->second + i - 1;
    }

    void cut_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        // Rows are parallel to bc; row i has i + 1 points.
        std::vector<std::vector<std::uint32_t>> rows(cuts_ + 1);
        for (std::uint32_t i = 0; i <= cuts_; ++i)
            for (std::uint32_t j = 0; j <= i; ++j) {
                std::uint32_t index = 0;
                if (j == 0)
                    index = on_edge(a, b, i);
                else if (j == i)
                    index = on_edge(a, c, i);
                else if (i == cuts_)
                    index = on_edge(b, c, j);
                else {
                    index = static_cast<std::uint32_t>(points.size());
                    points.push_back(glm::normalize(kIcosahedronCorners[a] * double(cuts_ - i) +
                                                    kIcosahedronCorners[b] * double(i - j) +
                                                    kIcosahedronCorners[c] * double(j)));
                }
                rows[i].push_back(index);
            }
        for (std::uint32_t i = 0; i < cuts_; ++i)
            for (std::uint32_t j = 0; j <= i; ++j) {
                triangles.emplace_back(rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]);
                if (j < i) triangles.emplace_back(rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]);
            }
    }

    std::uint32_t cuts_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges_;
};

/// Adds the square through `center` spanned by -s..s and -t..t; the normal is s x t. Texture coordinates grow
/// along u and v.
void append_square(Mesh& mesh, const glm::vec3& center, const glm::vec3& s, const glm::vec3& t,
                   const glm::vec3& u, const glm::vec3& v, int cells) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto n = static_cast<std::uint32_t>(cells);
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const glm::vec3 inside = float(2.0 * i / n - 1.0) * s + float(2.0 * j / n - 1.0) * t;
            mesh.positions.push_back(center + inside);
            mesh.normals.push_back(glm::cross(s, t));
            mesh.texcoords.push_back((1.0F + glm::vec2(glm::dot(inside, u), glm::dot(inside, v))) / 2.0F);
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t corner = first + j * (n + 1) + i;
            mesh.triangles.emplace_back(corner, corner + 1, corner + n + 2);
            mesh.triangles.emplace_back(corner, corner + n + 2, corner + n + 1);
        }
}

/// Adds texture coordinates of Mitsuba's sphere, from the vertices' unit directions.
void add_spherical_texcoords(Mesh& mesh, const std::vector<glm::dvec3>& directions) {
    const auto is_pole = [](const glm::dvec3& p) { return p.x == 0 && p.y == 0; };
    for (const glm::dvec3& p : directions) {
        const double azimuth = std::atan2(p.y, p.x) / (2 * std::numbers::pi);
        mesh.texcoords.emplace_back(azimuth < 0 ? azimuth + 1 : azimuth,
                                    std::atan2(std::hypot(p.x, p.y), p.z) / std::numbers::pi);
    }
    const auto with_u = [&](std::uint32_t vertex, float u) {
        mesh.texcoords.emplace_back(u, mesh.texcoords[vertex].y);
        return static_cast<std::uint32_t>(mesh.texcoords.size() - 1);
    };
    for (const glm::uvec3& t : mesh.triangles) {
        glm::uvec3 corners = t;
        float most = 0;
        for (glm::length_t k = 0; k < 3; ++k)
            if (!is_pole(directions[t[k]])) most = std::max(most, mesh.texcoords[t[k]].x);
        // A corner more than half a turn behind lies past the seam, because no triangle is that wide.
        for (glm::length_t k = 0; k < 3; ++k)
            if (!is_pole(directions[t[k]]) && mesh.texcoords[t[k]].x < most - 0.5F)
                corners[k] = with_u(t[k], mesh.texcoords[t[k]].x + 1);
        // u is undefined at a pole. The mean of the other corners' u distorts the image least.
        for (glm::length_t k = 0; k < 3; ++k)
            if (is_pole(directions[t[k]]))
                corners[k] = with_u(
                    t[k],
                    (mesh.texcoords[corners[(k + 1) % 3]].x + mesh.texcoords[corners[(k + 2) % 3]].x) / 2);
        mesh.texcoord_triangles.push_back(corners);
    }
}

void check_cells(int cells) {
    if (cells < 1 || cells > 1024)
        throw Error(ErrorCode::invalid_argument,
                    "cells is " + std::to_string(cells) + "; expected 1 to 1024");
}

}  // namespace

Mesh make_sphere(const glm::dvec3& center, double radius, double detail) {
    if (!std::isfinite(center.x + center.y + center.z) || !(radius > 0.0) || !std::isfinite(radius))
        throw Error(ErrorCode::invalid_argument,
                    "a sphere needs a finite center and a positive, finite radius");
    // A whole number of segments stays what it is when its quotient was rounded.
    const Icosphere sphere(2 * static_cast<std::uint32_t>(std::ceil(kHalfEdge * detail * (1 - 1e-12))));
    Mesh mesh;
    mesh.triangles = sphere.triangles;
    for (const glm::dvec3& p : sphere.points) {
        mesh.positions.emplace_back(center + radius * p);
        mesh.normals.emplace_back(p);
    }
    add_spherical_texcoords(mesh, sphere.points);
    return mesh;
}

Mesh make_rectangle(int cells) {
    check_cells(cells);
    Mesh mesh;
    append_square(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, cells);
    mesh.texcoord_triangles = mesh.triangles;
    return mesh;
}

Mesh make_cube(int cells) {
    check_cells(cells);
    Mesh mesh;
    struct Side {
        glm::vec3 normal, u, v;
    };
    constexpr Side sides[] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}},
                              {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}};
    for (const auto& [normal, u, v] : sides) {
        // The axis that follows the normal's axis.
        const glm::vec3 s(std::abs(normal.z), std::abs(normal.x), std::abs(normal.y));
        append_square(mesh, normal, s, glm::cross(normal, s), u, v, cells);
    }
    mesh.texcoord_triangles = mesh.triangles;
    return mesh;
}

}  // namespace nicol
