// SPDX-License-Identifier: MIT
#include "sphere.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace {

// Returns the number of rows between the poles. Rows have twice as many columns; a pole is one vertex.
std::uint32_t rows_of(std::uint32_t vertices) {
    return static_cast<std::uint32_t>(std::lround(std::sqrt(vertices / 2.0)));
}

}  // namespace

std::vector<float> sphere_positions(std::uint32_t vertices, double amplitude) {
    const std::uint32_t rows = rows_of(vertices), columns = 2 * rows;
    std::vector<float> positions;
    const auto add = [&](double theta, double phi) {
        const double radius = 1 + amplitude * std::sin(7 * theta) * std::sin(6 * phi) * std::sin(theta);
        positions.push_back(static_cast<float>(radius * std::sin(theta) * std::cos(phi)));
        positions.push_back(static_cast<float>(radius * std::cos(theta)));
        positions.push_back(static_cast<float>(-radius * std::sin(theta) * std::sin(phi)));
    };
    add(0, 0);
    add(std::numbers::pi, 0);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column)
            add((row + 1) * std::numbers::pi / (rows + 1), column * 2 * std::numbers::pi / columns);
    return positions;
}

Mesh make_sphere(nicol_context context, std::uint32_t vertices, double amplitude) {
    const std::uint32_t rows = rows_of(vertices), columns = 2 * rows;
    const std::vector<float> positions = sphere_positions(vertices, amplitude);
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return 2 + row * columns + column % columns;
    };
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t here = at(row, column), beside = at(row, column + 1);
            if (row == 0) indices.insert(indices.end(), {0, here, beside});
            if (row + 1 == rows) indices.insert(indices.end(), {1, beside, here});
            if (row + 1 < rows) {
                const std::uint32_t below = at(row + 1, column), across = at(row + 1, column + 1);
                indices.insert(indices.end(), {here, below, across, here, across, beside});
            }
        }
    }
    nicol_mesh_data data = NICOL_MESH_DATA_INIT;
    data.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
    data.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
    data.positions = positions.data();
    data.indices = indices.data();
    nicol_mesh mesh = nullptr;
    check(nicol_mesh_create(context, &data, &mesh));
    return Mesh(mesh);
}
