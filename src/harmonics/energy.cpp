// SPDX-License-Identifier: MIT
#include "harmonics/energy.hpp"

namespace nicol {

std::vector<Stokes> energy_per_order(const PshVector& field, int channel) {
    std::vector<Stokes> energy;
    for (int l = 0; l <= field.order(); ++l) {
        Stokes sum(0);
        for (int m = -l; m <= l; ++m) {
            for (int p = 0; p < 4; ++p) {
                const double value = field.at(channel, l, m, p);
                sum[p] += value * value;
            }
        }
        energy.push_back(sum);
    }
    return energy;
}

}  // namespace nicol
