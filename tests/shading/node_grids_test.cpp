// SPDX-License-Identifier: MIT
#include "shading/node_grids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "test.hpp"

using namespace nicol;

namespace {

/// Returns the weighted mean of the products x^i y^j over every step-th pair from `first` on.
double moment(const NodeGrid& grid, int i, int j, std::size_t first = 0, std::size_t step = 1) {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < grid.size(); ++k) {
        if (k / 2 % step != first) continue;
        const auto weight = static_cast<double>(grid.weights[k]);
        sum += weight * std::pow(static_cast<double>(grid.x[k]), i) *
               std::pow(static_cast<double>(grid.y[k]), j);
        weights += weight;
    }
    return sum / weights;
}

/// Returns whether nodes k and k + 1 lie on one line along an axis without a node between them. along: places
/// on the axis. across: places on the other axis.
bool side_by_side(const std::vector<float>& along, const std::vector<float>& across, std::size_t k) {
    if (across[k] != across[k + 1]) return false;
    const auto [low, high] = std::minmax(along[k], along[k + 1]);
    for (std::size_t n = 0; n < along.size(); ++n)
        if (across[n] == across[k] && along[n] > low && along[n] < high) return false;
    return low < high;
}

}  // namespace

TEST_CASE("grids have the moments of what they stand for") {
    for (const std::size_t count : {1U, 4U, 7U, 16U, 32U, 100U}) {
        const NodeGrids grids(count);
        CHECK(grids.count() == count);
        for (const bool normal : {false, true}) {
            std::size_t largest = 0;
            for (const NodeGrid& grid : normal ? grids.normal() : grids.uniform()) {
                CAPTURES(count, normal, grid.size());
                CHECK(grid.size() >= largest);  // small ones first
                largest = grid.size();
                double total = 0;
                for (const float weight : grid.weights) total += static_cast<double>(weight);
                CHECK(total == doctest::Approx(1));
                const bool column = std::ranges::all_of(grid.y, [](float y) { return y == 0; });
                CHECK(std::abs(moment(grid, 1, 0)) < 1e-5);
                CHECK(std::abs(moment(grid, 0, 1)) < 1e-5);
                CHECK(std::abs(moment(grid, 1, 1)) < 1e-5);
                CHECK(moment(grid, 2, 0) == doctest::Approx(grid.size() > 1 ? 1 : 0).epsilon(1e-4));
                CHECK(moment(grid, 0, 2) == doctest::Approx(column ? 0 : 1).epsilon(1e-4));
                // Kurtosis: 3 of a normal distribution, 9/5 of a uniform one.
                if (grid.blob_x < 0.4F)
                    CHECK(moment(grid, 4, 0) == doctest::Approx(normal ? 2.75 : 1.78).epsilon(0.08));
            }
            CHECK(largest == count);
        }
    }
}

TEST_CASE("half of a grid's pairs of neighbours, and the first ones, are spread over it") {
    const NodeGrids grids(32);
    for (const NodeGrid& grid : grids.uniform()) {
        if (grid.size() < 12) continue;
        CAPTURES(grid.size(), grid.blob_x);
        double even = 0;
        for (std::size_t k = 0; k < grid.size(); ++k)
            if (k / 2 % 2 == 0) even += static_cast<double>(grid.weights[k]);
        CHECK(even == doctest::Approx(static_cast<double>(grid.even_share)).epsilon(1e-4));
        CHECK(std::abs(even - 0.5) < 0.08);
        for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
            CHECK(std::abs(moment(grid, 1, 0, first, 2)) < 0.5);
            CHECK(std::abs(moment(grid, 2, 0, first, 2) - 1) < 0.35);
        }
        const auto [low, high] = std::minmax_element(grid.x.begin(), grid.x.begin() + 8);
        CHECK(*high - *low > 0.7F);
        for (std::size_t k = 0; k + 1 < grid.size(); k += 2)
            CHECK((side_by_side(grid.x, grid.y, k) || side_by_side(grid.y, grid.x, k)));
    }
}

TEST_CASE("nodes and blobs of a row add up to a normal distribution") {
    const NodeGrids grids(48);
    for (const NodeGrid& grid : grids.normal()) {
        const bool row = std::ranges::all_of(grid.y, [](float y) { return y == 0; });
        if (!row || grid.size() < 4) continue;
        const auto blob = static_cast<double>(grid.blob_x), width = static_cast<double>(grid.width_x);
        CAPTURES(grid.size(), blob, width);
        CHECK(blob < 2.7 / static_cast<double>(grid.size()));
        const double nodes = std::sqrt(1 - blob * blob * width * width);
        const auto normal = [](double x, double deviation) {
            return std::exp(-x * x / (2 * deviation * deviation)) / (deviation * std::sqrt(2 * pi));
        };
        for (double x = -2.5; x < 2.51; x += 0.1) {
            double sum = 0;
            for (std::size_t k = 0; k < grid.size(); ++k)
                sum += static_cast<double>(grid.weights[k]) *
                       normal(x - nodes * static_cast<double>(grid.x[k]),
                              blob * static_cast<double>(grid.widths_x[k]));
            CHECK(std::abs(sum / normal(x, 1) - 1) < 0.25);
        }
    }
}
