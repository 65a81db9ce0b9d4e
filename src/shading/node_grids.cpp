// SPDX-License-Identifier: MIT
#include "shading/node_grids.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nicol {
namespace {

// Rows of a normal distribution that have more nodes are dense in the middle.
constexpr std::size_t kFewNodes = 10;

struct Row {
    std::vector<double> x, weights;
    std::vector<double> widths;  // of the gaps at the nodes, relative to those in the middle
    double blob;
};

double mean_square(const Row& row, const std::vector<double>& values) {
    double sum = 0, total = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        sum += row.weights[k] * values[k] * values[k];
        total += row.weights[k];
    }
    return sum / total;
}

void set_normal_weights(double sharpness, Row& row) {
    for (std::size_t k = 0; k < row.x.size(); ++k)
        row.weights[k] = row.widths[k] * std::exp(-0.5 * sharpness * row.x[k] * row.x[k]);
}

// Returns the number of standard deviations below which a normal distribution has this share.
double normal_quantile(double share) {
    double low = -8, high = 8;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < share ? low : high) = middle;
    }
    return low;
}

Row row_of(std::size_t count, bool normal) {
    if (count == 1) return {.x = {0}, .weights = {1}, .widths = {1}, .blob = 1};
    const auto n = static_cast<double>(count);
    // The more nodes a normal distribution has, the denser they are and the farther out they go.
    double step = normal ? 2 * std::pow(n / 2, -0.8) : std::sqrt(12 / (n * n - 1));
    Row out{.x = std::vector<double>(count),
            .weights = std::vector<double>(count, 1),
            .widths = std::vector<double>(count, 1),
            .blob = 0};
    for (std::size_t k = 0; k < count; ++k) out.x[k] = step * (static_cast<double>(k) - (n - 1) / 2);
    if (normal && count > kFewNodes) {
        // Blurring the tails more costs little. As many nodes a length as the cube root of the density gives
        // the least error.
        step = 2 * std::sqrt(2 * std::numbers::pi) / n;
        for (std::size_t k = 0; k < count; ++k) {
            const double z = normal_quantile((static_cast<double>(k) + 0.5) / n);
            out.x[k] = 2 * z;
            out.widths[k] = std::exp(0.5 * z * z);
        }
    }
    if (normal) {
        double low = 0, high = 4;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            set_normal_weights(middle, out);
            (mean_square(out, out.x) > 1 ? low : high) = middle;
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
    if (count == 0) return {};
    auto step = static_cast<std::size_t>(std::lround(static_cast<double>(count) / std::numbers::phi));
    while (std::gcd(step, count) != 1) ++step;
    std::vector<std::size_t> out(count);
    for (std::size_t k = 0; k < count; ++k) out[k] = k * step % count;
    return out;
}

// Returns nodes j across + i of a grid, in pairs of neighbours, row by row. Every other row begins at its
// end, so that neighbours of even pairs are odd. A node without a neighbour is the last one.
std::vector<std::size_t> paired(std::size_t across, std::size_t down) {
    std::vector<std::size_t> out;
    for (std::size_t j = 0; j < down; ++j)
        for (std::size_t k = 0; k < across / 2; ++k) {
            const std::size_t pair = j % 2 == 0 ? k : across / 2 - 1 - k;
            out.insert(out.end(), {j * across + 2 * pair, j * across + 2 * pair + 1});
        }
    for (std::size_t j = 0; j < down && across % 2 == 1; ++j) out.push_back(j * across + across - 1);
    return out;
}

NodeGrid grid_of(std::size_t across, std::size_t down, bool normal) {
    const Row row = row_of(across, normal), column = row_of(down, normal);
    NodeGrid out{.x = {},
                 .y = {},
                 .weights = {},
                 .blob_x = static_cast<float>(row.blob),
                 .blob_y = static_cast<float>(column.blob),
                 .widths_x = {},
                 .widths_y = {},
                 .width_x = static_cast<float>(std::sqrt(mean_square(row, row.widths))),
                 .width_y = static_cast<float>(std::sqrt(mean_square(column, column.widths))),
                 .even_share = 0};
    const std::vector<std::size_t> nodes = paired(across, down);
    const std::size_t pairs = nodes.size() / 2;
    const std::vector<std::size_t> even = spread((pairs + 1) / 2), odd = spread(pairs / 2);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t own = k / 2;
        std::size_t pair = own;
        if (own < pairs) pair = own % 2 == 0 ? 2 * even[own / 2] : 2 * odd[own / 2] + 1;
        const std::size_t node = nodes[2 * pair + k % 2];
        const std::size_t i = node % across, j = node / across;
        out.x.push_back(static_cast<float>(row.x[i]));
        out.y.push_back(static_cast<float>(column.x[j]));
        out.weights.push_back(static_cast<float>(row.weights[i] * column.weights[j]));
        out.widths_x.push_back(static_cast<float>(row.widths[i]));
        out.widths_y.push_back(static_cast<float>(column.widths[j]));
        if (own % 2 == 0) out.even_share += out.weights.back();
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
    // 4, 5, 6, 7, 8, 10, 12, 14, 16, 20 and so on.
    for (std::size_t size = 4; size < count; size += std::bit_floor(size) / 4) add(size);
    if (count > 1) add(count);
    std::ranges::stable_sort(normal_, {}, &NodeGrid::size);
    std::ranges::stable_sort(uniform_, {}, &NodeGrid::size);
}

}  // namespace nicol
