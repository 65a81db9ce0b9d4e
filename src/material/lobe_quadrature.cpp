// SPDX-License-Identifier: MIT
#include "material/lobe_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "material/material.hpp"

namespace nicol {
namespace {

// Positive half of the Gauss-Legendre rule on [-1, 1] with eight nodes.
constexpr std::array<QuadratureNode, 4> kRule{{{0.1834346424956498, 0.3626837833783620},
                                               {0.5255324099163290, 0.3137066458778873},
                                               {0.7966664774136267, 0.2223810344533745},
                                               {0.9602898564975363, 0.1012285362903763}}};

void add_panel(std::vector<QuadratureNode>& nodes, double from, double to) {
    const double middle = (from + to) / 2;
    const double half = std::abs(to - from) / 2;
    for (const QuadratureNode& node : kRule) {
        nodes.push_back({middle - half * node.x, half * node.weight});
        nodes.push_back({middle + half * node.x, half * node.weight});
    }
}

// Adds panels from the peak outwards to `end`.
void add_side(std::vector<QuadratureNode>& nodes, double peak, double end, double narrow, double wide) {
    const double direction = end < peak ? -1 : 1;
    double done = 0;
    double width = std::min(narrow, wide);
    const double length = std::abs(end - peak);
    while (done < length) {
        // A rest shorter than two panels is cut into halves instead of a whole panel and a sliver.
        const double left = length - done;
        const double step = left < 1.1 * width ? left : left < 2 * width ? left / 2 : width;
        const double next = step == left ? length : done + step;
        add_panel(nodes, peak + direction * done, peak + direction * next);
        done = next;
        width = std::min(2 * width, wide);
    }
}

}  // namespace

std::vector<QuadratureNode> nodes_around(double peak, double low, double high, double narrow, double wide) {
    std::vector<QuadratureNode> nodes;
    add_side(nodes, std::clamp(peak, low, high), low, narrow, wide);
    add_side(nodes, std::clamp(peak, low, high), high, narrow, wide);
    return nodes;
}

LobePanels lobe_panels(double theta_out, double lobe) {
    // Eight nodes follow a Gaussian or a facet distribution over this many widths.
    const double narrow = 3 * lobe;
    // A tilt of a facet across the plane of incidence turns reflected light by less the lower the light is.
    return {narrow, narrow * std::max(lobe, std::cos(theta_out)) / std::max(lobe, std::sin(theta_out))};
}

double narrowest_lobe(const Material& material) {
    double narrowest = 1;
    for (int t = 0; t < material.terms(); ++t) narrowest = std::min(narrowest, material.lobe_width(t));
    return narrowest;
}

}  // namespace nicol
