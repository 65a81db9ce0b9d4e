// SPDX-License-Identifier: MIT
#include "shading/node_grids.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nicol {
namespace {

// Nodes at equal distances.
struct Row {
    std::vector<double> x, weights;
    double blob;
};

double variance(const Row& row) {
    double sum = 0, total = 0;
    for (std::size_t k = 0; k < row.x.size(); ++k) {
        sum += row.weights[k] * row.x[k] * row.x[k];
        total += row.weights[k];
    }
    return sum / total;
}

void set_normal_weights(double sharpness, Row& row) {
    for (std::size_t k = 0; k < row.x.size(); ++k)
        row.weights[k] = std::exp(-0.5 * sharpness * row.x[k] * row.x[k]);
}

Row row_of(std::size_t count, bool normal) {
    if (count == 1) return {.x = {0}, .weights = {1}, .blob = 1};
    const auto n = static_cast<double>(count);
    // The more nodes a normal distribution has, the denser they are and the farther out they go.
    const double step = normal ? 2 * std::pow(n / 2, -0.8) : std::sqrt(12 / (n * n - 1));
    Row out{.x = std::vector<double>(count), .weights = std::vector<double>(count, 1), .blob = 0};
    for (std::size_t k = 0; k < count; ++k) out.x[k] = step * (static_cast<double>(k) - (n - 1) / 2);
    if (normal) {
        double low = 0, high = 4;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            set_normal_weights(middle, out);
            (variance(out) > 1 ? low : high) = middle;
        }
    }
    const double total = std::accumulate(out.weights.begin(), out.weights.end(), 0.0);
    for (double& weight : out.weights) weight /= total;
    // Neighbouring blobs are two standard deviations apart.
    out.blob = step / std::sqrt(4 + step * step);
    return out;
}

// Returns the numbers below `count` in an order whose beginnings are spread evenly.
std::vector<std::size_t> spread(std::size_t count) {
    auto step = static_cast<std::size_t>(std::lround(static_cast<double>(count) / std::numbers::phi));
    while (std::gcd(step, count) != 1) ++step;
    std::vector<std::size_t> out(count);
    for (std::size_t k = 0; k < count; ++k) out[k] = k * step % count;
    return out;
}

NodeGrid grid_of(std::size_t across, std::size_t down, bool normal) {
    const Row row = row_of(across, normal), column = row_of(down, normal);
    NodeGrid out{.x = {},
                 .y = {},
                 .weights = {},
                 .blob_x = static_cast<float>(row.blob),
                 .blob_y = static_cast<float>(column.blob),
                 .even_share = 0};
    const std::size_t count = across * down;
    const std::vector<std::size_t> even = spread((count + 1) / 2), odd = spread(count / 2);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t node = k % 2 == 0 ? 2 * even[k / 2] : 2 * odd[k / 2] + 1;
        const std::size_t i = node % across, j = node / across;
        out.x.push_back(static_cast<float>(row.x[i]));
        out.y.push_back(static_cast<float>(column.x[j]));
        out.weights.push_back(static_cast<float>(row.weights[i] * column.weights[j]));
        if (k % 2 == 0) out.even_share += out.weights.back();
    }
    return out;
}

std::vector<NodeGrid> grids_of(std::size_t count, bool normal) {
    std::vector<NodeGrid> out;
    for (std::size_t down = 1; down * down <= count; ++down)
        out.push_back(grid_of(count / down, down, normal));
    return out;
}

}  // namespace

NodeGrids::NodeGrids(std::size_t count) : count_(count) {
    const auto add = [this](std::size_t size) {
        std::ranges::move(grids_of(size, true), std::back_inserter(normal_));
        std::ranges::move(grids_of(size, false), std::back_inserter(uniform_));
    };
    add(1);
    // 4, 6, 8, 12, 16, 24 and so on.
    for (std::size_t size = 4; size < count; size += std::has_single_bit(size) ? size / 2 : size / 3)
        add(size);
    if (count > 1) add(count);
    std::ranges::stable_sort(normal_, {}, &NodeGrid::size);
    std::ranges::stable_sort(uniform_, {}, &NodeGrid::size);
}

}  // namespace nicol
