// SPDX-License-Identifier: MIT
// Quadrature nodes that resolve a lobe.
#pragma once

#include <vector>

namespace nicol {

struct QuadratureNode {
    double x;
    double weight;
};

/// Returns composite Gauss-Legendre nodes on [low, high]. Panels are `narrow` wide next to `peak` and double
/// away from the peak up to `wide`. A feature of width `narrow` away from the peak is not resolved.
[[nodiscard]] std::vector<QuadratureNode> nodes_around(double peak, double low, double high, double narrow,
                                                       double wide);

}  // namespace nicol
