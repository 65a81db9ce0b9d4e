// SPDX-License-Identifier: MIT
#include "harmonics/energy.hpp"

namespace nicol {

std::vector<Stokes> energy_per_order(const PshVector& field, int channel) {
    std::vector<Stokes> energy;
    energy.reserve(static_cast<std::size_t>(field.order()) + 1);
    const double* value = field.channel(channel).data();
    for (int l = 0; l <= field.order(); ++l) {
        Stokes sum(0);
        for (int m = -l; m <= l; ++m)
            for (int p = 0; p < 4; ++p, ++value) sum[p] += *value * *value;
        energy.push_back(sum);
    }
    return energy;
}

}  // namespace nicol
