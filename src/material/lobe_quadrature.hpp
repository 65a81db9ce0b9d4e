// SPDX-License-Identifier: MIT
// Quadrature nodes that resolve a lobe.
#pragma once

#include <vector>

namespace nicol {

struct QuadratureNode {
    double x;
    double weight;
};

/// Composite Gauss-Legendre nodes on [low, high]: panels of `narrow` next to `peak`, doubling away from it up
/// to `wide`. A feature of that width anywhere else than at the peak is not resolved.
[[nodiscard]] std::vector<QuadratureNode> nodes_around(double peak, double low, double high, double narrow,
                                                       double wide);

}  // namespace nicol
