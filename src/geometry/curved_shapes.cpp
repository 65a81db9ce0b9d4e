// SPDX-License-Identifier: MIT
// Disc and cylinder: rows of points around an axis.
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>

#include "error.hpp"
#include "geometry/mesh.hpp"
#include "geometry/perpendicular.hpp"

namespace nicol {
namespace {

// Numbers of segments at full detail.
constexpr double kSectors = 180;
constexpr double kRings = 16;  // of a disc
constexpr double kRows = 32;   // of a cylinder

// Returns the number of segments at a detail in (0, 1].
std::uint32_t segments(double most, double detail) {
    return static_cast<std::uint32_t>(std::ceil(most * detail));
}

// A circle that is cut into sectors.
struct Circle {
    std::uint32_t sectors;

    [[nodiscard]] glm::dvec2 direction(std::uint32_t sector) const {
        const double angle = 2 * std::numbers::pi * sector / sectors;
        return {std::cos(angle), std::sin(angle)};
    }
    // Returns a sector's place on the circle, in turns.
    [[nodiscard]] double turned(std::uint32_t sector) const { return static_cast<double>(sector) / sectors; }
};

/// Adds the triangles between `rows` + 1 rows of `sectors` vertices and of `sectors` + 1 texture coordinates.
/// The last texture coordinate of a row lies at the first vertex, one turn further.
void join_rows(Mesh& mesh, std::uint32_t rows, std::uint32_t sectors) {
    const auto add = [&](glm::uvec3 row, glm::uvec3 sector) {
        glm::uvec3 vertices, texcoords;
        for (glm::length_t k = 0; k < 3; ++k) {
            vertices[k] = row[k] * sectors + sector[k] % sectors;
            texcoords[k] = row[k] * (sectors + 1) + sector[k];
        }
        mesh.triangles.push_back(vertices);
        mesh.texcoord_triangles.push_back(texcoords);
    };
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            add({row, row, row + 1}, {sector, sector + 1, sector + 1});
            add({row, row + 1, row + 1}, {sector, sector + 1, sector});
        }
}

}  // namespace

Mesh make_disk(double detail) {
    const Circle circle{segments(kSectors, detail)};
    const std::uint32_t rings = segments(kRings, detail);
    Mesh mesh;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {  // from the edge inwards
        const double radius = 1 - static_cast<double>(ring) / rings;
        for (std::uint32_t sector = 0; sector < circle.sectors; ++sector)
            mesh.positions.emplace_back(radius * circle.direction(sector), 0);
        for (std::uint32_t sector = 0; sector <= circle.sectors; ++sector)
            mesh.texcoords.emplace_back(radius, circle.turned(sector));
    }
    join_rows(mesh, rings - 1, circle.sectors);
    const auto center = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0);
    const std::uint32_t innermost = center - circle.sectors;
    for (std::uint32_t sector = 0; sector < circle.sectors; ++sector) {
        const std::uint32_t corner = (rings - 1) * (circle.sectors + 1) + sector;
        mesh.triangles.emplace_back(innermost + sector, innermost + (sector + 1) % circle.sectors, center);
        mesh.texcoord_triangles.emplace_back(corner, corner + 1, mesh.texcoords.size());
        // v is undefined at the centre. The mean of the other corners' v distorts the image least.
        mesh.texcoords.emplace_back(0, circle.turned(sector) + 0.5 / circle.sectors);
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    return mesh;
}

Mesh make_cylinder(const glm::dvec3& p0, const glm::dvec3& p1, double radius, double detail) {
    const double length = glm::distance(p0, p1);
    if (!(length > 0) || !std::isfinite(length) || !(radius > 0) || !std::isfinite(radius))
        throw Error(ErrorCode::invalid_argument,
                    "a cylinder needs two finite points that differ and a positive, finite radius");
    const glm::dvec3 axis = (p1 - p0) / length;
    const glm::dvec3 s = perpendicular(axis);
    const glm::dvec3 t = glm::cross(axis, s);
    const Circle circle{segments(kSectors, detail)};
    const std::uint32_t rows = segments(kRows, detail);
    Mesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        const double v = static_cast<double>(row) / rows;
        for (std::uint32_t sector = 0; sector < circle.sectors; ++sector) {
            const glm::dvec2 around = circle.direction(sector);
            const glm::dvec3 normal = around.x * s + around.y * t;
            mesh.positions.emplace_back(p0 + v * (p1 - p0) + radius * normal);
            mesh.normals.emplace_back(normal);
        }
        for (std::uint32_t sector = 0; sector <= circle.sectors; ++sector)
            mesh.texcoords.emplace_back(circle.turned(sector), v);
    }
    join_rows(mesh, rows, circle.sectors);
    return mesh;
}

}  // namespace nicol
