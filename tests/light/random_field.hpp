// SPDX-License-Identifier: MIT
// Light without symmetry whose coefficients are known.
#pragma once

#include <random>

#include "harmonics/psh.hpp"

/// Random coefficients of every order and component on a constant that is large enough to keep the light
/// physical.
inline nicol::PshVector random_field(int order, int channels, unsigned seed = 1) {
    nicol::PshVector field(order, channels);
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-0.03, 0.03);
    for (int c = 0; c < channels; ++c) {
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p)
                    if (l >= 2 || p == 0 || p == 3) field.at(c, l, m, p) = uniform(engine);
        field.at(c, 0, 0, 0) = 4 + c;
    }
    return field;
}
