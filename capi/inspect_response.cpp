// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "inspect_material.hpp"
#include "material/matrix_rows.hpp"

namespace nicol::capi {

std::vector<IsotropicMatrix> matrices_of(const StoredResponse& file) {
    const int order = file.layout.order();
    const LightLayout all(order, LightKind::full);
    const int channels = file.table.channels();
    std::vector<IsotropicMatrix> out(static_cast<std::size_t>(channels), IsotropicMatrix(order, order));
    std::vector<double> rows(4 * all.size());
    constexpr int last = ResponseTable::kAngles - 1;
    constexpr double step = std::numbers::pi / 2 / last;
    for (int angle = 0; angle <= last; ++angle) {
        // Simpson's rule over the zenith angle.
        const double simpson = step / 3 * (angle == 0 || angle == last ? 1 : angle % 2 == 1 ? 4 : 2);
        const double theta = angle * step;
        for (int c = 0; c < channels; ++c) {
            const std::span<const float> from = file.table.rows(angle, c);
            // A layout for less light is the beginning of the one for all.
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t j = 0; j < file.layout.size(); ++j)
                    rows[p * all.size() + j] = static_cast<double>(from[p * file.layout.size() + j]);
            add_circle(out[static_cast<std::size_t>(c)], theta, simpson * std::sin(theta), all, rows);
        }
    }
    return out;
}

}  // namespace nicol::capi
