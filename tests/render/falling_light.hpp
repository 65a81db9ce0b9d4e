// SPDX-License-Identifier: MIT
// Light for tests of high orders.
#pragma once

#include <cmath>

#include "light/environment.hpp"

namespace nicol::test {

/// Light of all orders up to the last, falling as that of images does.
inline EnvironmentPtr falling_light(int order, bool polarized, int channels = 3) {
    PshVector light(order, channels);
    for (int c = 0; c < channels; ++c) {
        light.at(c, 0, 0, 0) = 6 + c;
        for (int l = 1; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = 0; p < (polarized ? 4 : 1); ++p) {
                    if (l < 2 && (p == 1 || p == 2)) continue;
                    light.at(c, l, m, p) = std::sin(7.1 * l + 3.3 * m + 5 * p + 0.2 * c) / (l + 1);
                }
            }
        }
    }
    return psh_environment(light);
}

}  // namespace nicol::test
