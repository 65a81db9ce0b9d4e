// SPDX-License-Identifier: MIT
// Quadrature over a plane by nodes on grids.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nicol {

/// Nodes on a grid, as many along x as along y or more. Along each axis, nodes and weights have the mean 0
/// and the variance 1 (0 if there is one node), and the weights add up to 1. Nodes 2k and 2k + 1 are a pair
/// of neighbours; the last node may have none. The even pairs are spread over the grid, and so are the odd
/// ones and the first ones of both.
struct NodeGrid {
    std::vector<float> x, y, weights;
    /// Along x and along y: standard deviation of round blobs that fill the gaps between the nodes in the
    /// middle, relative to that of nodes and blobs together.
    float blob_x, blob_y;
    /// Along x and along y: how much wider the gaps at a node are than in the middle, 1 or more, and the root
    /// mean square over all nodes.
    std::vector<float> widths_x, widths_y;
    float width_x, width_y;
    float even_share;  ///< sum of the weights of even pairs

    [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
};

/// Grids of at most `count` nodes, small ones first.
class NodeGrids {
public:
    explicit NodeGrids(std::size_t count);

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    /// Returns grids whose weights are those of a normal distribution.
    [[nodiscard]] std::span<const NodeGrid> normal() const noexcept { return normal_; }
    /// Returns grids of equal weights, as of a square that is covered evenly.
    [[nodiscard]] std::span<const NodeGrid> uniform() const noexcept { return uniform_; }

private:
    std::size_t count_;
    std::vector<NodeGrid> normal_, uniform_;
};

}  // namespace nicol
