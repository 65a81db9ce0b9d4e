// SPDX-License-Identifier: MIT
// Cube maps.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "harmonics/evaluate.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/require.hpp"

namespace nicol {
namespace {

/// Solid angle between a face's centre and its point (x, y).
double corner_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

/// The point (u, v) of a face, u to the right and v down as OpenGL stores its rows.
glm::dvec3 on_face(int face, double u, double v) {
    switch (face) {
        case 0:
            return {1, -v, -u};
        case 1:
            return {-1, -v, u};
        case 2:
            return {u, 1, v};
        case 3:
            return {u, -1, -v};
        case 4:
            return {u, -v, 1};
        default:
            return {-u, -v, -1};
    }
}

}  // namespace

CubeGrid cube_grid(int size) {
    require(size >= 1 && size <= kMaxCubeSize,
            "cube size is " + std::to_string(size) + ", expected 1 to " + std::to_string(kMaxCubeSize));
    CubeGrid grid;
    grid.size = size;
    const auto edge = [&](int i) { return 2.0 * i / size - 1; };
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                grid.direction.push_back(
                    glm::normalize(on_face(face, (2.0 * column + 1) / size - 1, (2.0 * row + 1) / size - 1)));
                grid.solid_angle.push_back(corner_angle(edge(column + 1), edge(row + 1)) -
                                           corner_angle(edge(column), edge(row + 1)) -
                                           corner_angle(edge(column + 1), edge(row)) +
                                           corner_angle(edge(column), edge(row)));
            }
    return grid;
}

void analyze_cube(const CubeGrid& grid, std::span<const Stokes> samples, int order,
                  std::span<double> coefficients) {
    require_order(order);
    require(grid.size > order, "a cube of size " + std::to_string(grid.size) + " does not resolve order " +
                                   std::to_string(order));
    require_size(samples.size(), grid.direction.size(), "samples");
    require_size(coefficients.size(), 4 * psh_count(order), "coefficients");
    std::vector<Stokes> rest(samples.begin(), samples.end());
    std::vector<Stokes> values(samples.size());
    PshVector step(order, 1);
    std::ranges::fill(coefficients, 0.0);
    double largest = 0;
    for (int round = 0; round < 60; ++round) {
        project_samples(order, grid.direction, rest, grid.solid_angle, step.channel(0));
        double change = 0;
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            coefficients[i] += step.data()[i];
            largest = std::max(largest, std::abs(coefficients[i]));
            change = std::max(change, std::abs(step.data()[i]));
        }
        if (change <= 1e-15 * largest) return;
        evaluate(step, 0, grid.direction, values);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= values[i];
    }
}

}  // namespace nicol
