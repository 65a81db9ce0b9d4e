// SPDX-License-Identifier: MIT
// Quadrature nodes that resolve a lobe.
#pragma once

#include <vector>

namespace nicol {

class Material;

struct QuadratureNode {
    double x;
    double weight;
};

/// Returns composite Gauss-Legendre nodes on [low, high]. Panels are `narrow` wide next to `peak` and double
/// away from the peak up to `wide`. A feature of width `narrow` away from the peak is not resolved.
[[nodiscard]] std::vector<QuadratureNode> nodes_around(double peak, double low, double high, double narrow,
                                                       double wide);

/// Widths `narrow` of nodes_around() that resolve a lobe about the mirror direction to six digits.
struct LobePanels {
    double zenith;
    double azimuth;
};
/// Returns the widths for a lobe of angular radius `lobe` and light reflected to theta_out in [0, pi/2].
[[nodiscard]] LobePanels lobe_panels(double theta_out, double lobe);

/// Returns the smallest lobe_width() of a material's terms, at most 1.
[[nodiscard]] double narrowest_lobe(const Material& material);

}  // namespace nicol
