// SPDX-License-Identifier: MIT
#include "naive.hpp"

Doubles to_scalars(const Doubles& stokes) {
    Doubles out(stokes.size());
    for (std::size_t i = 0; i < out.size(); i += 4) {
        out[i] = stokes[i + 1];
        out[i + 3] = stokes[i + 2];
    }
    return out;
}

Doubles from_scalars(const Doubles& scalars) {
    Doubles out(scalars.size());
    for (std::size_t i = 0; i < out.size(); i += 4) {
        out[i + 1] = scalars[i];
        out[i + 2] = scalars[i + 3];
    }
    return out;
}

Doubles rotated_samples(const Grid& grid, const Rotation& rotation, const Expansion& at) {
    const Rotation back = transposed(rotation);
    std::vector<Vec3> sources;
    for (const double theta : grid.theta)
        for (std::size_t c = 0; c < grid.columns; ++c)
            sources.push_back(back * direction(theta, grid.phi(c)));
    const Doubles values = at(sources);
    Doubles out(values.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        // x is the x axis of the point's frame in the source's coordinates.
        const Vec3 x = back * theta_hat(grid.theta[i / grid.columns], grid.phi(i % grid.columns));
        const auto s =
            std::complex(values[4 * i + 1], values[4 * i + 2]) * std::conj(frame_phase(x, sources[i]));
        out[4 * i + 1] = s.real();
        out[4 * i + 2] = s.imag();
    }
    return out;
}
