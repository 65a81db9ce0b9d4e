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
///
/// For a material of lobe width w, panels of kPanelsOfLobe w resolve the lobe to six digits: eight nodes
/// follow a Gaussian or a facet distribution that far.
inline constexpr double kPanelsOfLobe = 3;
[[nodiscard]] std::vector<QuadratureNode> nodes_around(double peak, double low, double high, double narrow,
                                                       double wide);

}  // namespace nicol
