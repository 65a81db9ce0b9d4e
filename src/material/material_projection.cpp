// SPDX-License-Identifier: MIT
#include "material/material_projection.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "error.hpp"
#include "material/lobe_quadrature.hpp"
#include "material/matrix_rows.hpp"
#include "material/row_integral.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

IsotropicMatrix resized(const IsotropicMatrix& from, int order) {
    IsotropicMatrix out(order, order);
    for (int m = 0; m <= std::min({order, from.order_in(), from.order_out()}); ++m) {
        for (int l = m; l <= std::min(order, from.order_out()); ++l)
            for (int k = m; k <= std::min(order, from.order_in()); ++k)
                out.block(m, l, k) = from.block(m, l, k);
    }
    return out;
}

}  // namespace

IsotropicMatrix project_material(const Material& material, int channel, int order) {
    if (channel < 0 || (channel >= material.channels() && material.channels() != 1))
        throw Error(ErrorCode::invalid_argument, "channel is " + std::to_string(channel) +
                                                     "; the material has " +
                                                     std::to_string(material.channels()));
    if (const IsotropicMatrix* own = material.matrix(channel)) return resized(*own, order);

    const LightLayout layout(order, LightKind::full);
    IsotropicMatrix matrix(order, order);
    // Rows vary as fast as the harmonics, and faster within a lobe's width of the horizon, because the
    // horizon cuts the lobe off.
    const std::vector<QuadratureNode> nodes =
        nodes_around(pi / 2, 0, pi / 2, narrowest_lobe(material) / 4, std::min(pi / 8, 2 * pi / (order + 1)));
    const std::size_t set = 4 * material.pairings() * layout.row_size();
    std::vector<double> rows(nodes.size() * set);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size()), [&](const auto& range) {
        RowIntegral integral(material, layout);
        for (std::size_t n = range.begin(); n < range.end(); ++n) {
            const double* of_term = integral.integrate(nodes[n].x).data();
            for (int t = 0; t < material.terms(); ++t, of_term += set) {
                const double weight = material.weight(t, channel);
                for (std::size_t j = 0; j < set; ++j) rows[n * set + j] += weight * of_term[j];
            }
        }
    });
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        add_circle(matrix, nodes[n].x, nodes[n].weight * std::sin(nodes[n].x), layout, material.pairings(),
                   std::span(rows).subspan(n * set, set));
    }
    return matrix;
}

}  // namespace nicol
