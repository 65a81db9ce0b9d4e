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

constexpr std::uint32_t kSectors = 180;
constexpr std::uint32_t kRings = 16;  // rings of a disc
constexpr std::uint32_t kRows = 32;   // rows of a cylinder

glm::dvec2 direction_of(std::uint32_t sector) {
    const double angle = 2 * std::numbers::pi * sector / kSectors;
    return {std::cos(angle), std::sin(angle)};
}

double turned(std::uint32_t sector) {
    return static_cast<double>(sector) / kSectors;
}

/// Adds the triangles between `rows` + 1 rows of kSectors vertices and of kSectors + 1 texture coordinates.
/// The last texture coordinate of a row lies at the first vertex, one turn further.
void join_rows(Mesh& mesh, std::uint32_t rows) {
    const auto add = [&](glm::uvec3 row, glm::uvec3 sector) {
        glm::uvec3 vertices, texcoords;
        for (glm::length_t k = 0; k < 3; ++k) {
            vertices[k] = row[k] * kSectors + sector[k] % kSectors;
            texcoords[k] = row[k] * (kSectors + 1) + sector[k];
        }
        mesh.triangles.push_back(vertices);
        mesh.texcoord_triangles.push_back(texcoords);
    };
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
            add({row, row, row + 1}, {sector, sector + 1, sector + 1});
            add({row, row + 1, row + 1}, {sector, sector + 1, sector});
        }
}

}  // namespace

Mesh make_disk() {
    Mesh mesh;
    for (std::uint32_t ring = 0; ring < kRings; ++ring) {  // from the edge inwards
        const double radius = 1 - static_cast<double>(ring) / kRings;
        for (std::uint32_t sector = 0; sector < kSectors; ++sector)
            mesh.positions.emplace_back(radius * direction_of(sector), 0);
        for (std::uint32_t sector = 0; sector <= kSectors; ++sector)
            mesh.texcoords.emplace_back(radius, turned(sector));
    }
    join_rows(mesh, kRings - 1);
    const auto center = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0);
    const std::uint32_t innermost = center - kSectors;
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
        const std::uint32_t corner = (kRings - 1) * (kSectors + 1) + sector;
        mesh.triangles.emplace_back(innermost + sector, innermost + (sector + 1) % kSectors, center);
        mesh.texcoord_triangles.emplace_back(corner, corner + 1, mesh.texcoords.size());
        // v is undefined at the centre. The mean of the other corners' v distorts the image least.
        mesh.texcoords.emplace_back(0, turned(sector) + 0.5 / kSectors);
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    return mesh;
}

Mesh make_cylinder(const glm::dvec3& p0, const glm::dvec3& p1, double radius) {
    const double length = glm::distance(p0, p1);
    if (!(length > 0) || !std::isfinite(length) || !(radius > 0) || !std::isfinite(radius))
        throw Error(ErrorCode::invalid_argument,
                    "a cylinder needs two finite points that differ and a positive, finite radius");
    const glm::dvec3 axis = (p1 - p0) / length;
    const glm::dvec3 s = perpendicular(axis);
    const glm::dvec3 t = glm::cross(axis, s);
    Mesh mesh;
    for (std::uint32_t row = 0; row <= kRows; ++row) {
        const double v = static_cast<double>(row) / kRows;
        for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
            const glm::dvec2 around = direction_of(sector);
            const glm::dvec3 normal = around.x * s + around.y * t;
            mesh.positions.emplace_back(p0 + v * (p1 - p0) + radius * normal);
            mesh.normals.emplace_back(normal);
        }
        for (std::uint32_t sector = 0; sector <= kSectors; ++sector)
            mesh.texcoords.emplace_back(turned(sector), v);
    }
    join_rows(mesh, kRows);
    return mesh;
}

}  // namespace nicol
