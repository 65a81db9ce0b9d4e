// SPDX-License-Identifier: MIT
// Differences of images over all pixels, channels and components.
#pragma once

#include "image/stokes_image.hpp"
#include "test.hpp"

namespace nicol::test {

/// Returns the root mean square.
inline double rms(const StokesImage& image) {
    double sum = 0;
    for (const float value : image.data) sum += std::pow(static_cast<double>(value), 2);
    return std::sqrt(sum / static_cast<double>(image.data.size()));
}

inline StokesImage minus(StokesImage a, const StokesImage& b) {
    REQUIRE(a.data.size() == b.data.size());
    for (std::size_t i = 0; i < a.data.size(); ++i) a.data[i] -= b.data[i];
    return a;
}

inline double rms_difference(const StokesImage& a, const StokesImage& b) {
    return rms(minus(a, b));
}

/// Returns the number of pixels with a component that differs by more than `most`.
inline int differing_pixels(const StokesImage& a, const StokesImage& b, double most) {
    const StokesImage difference = minus(a, b);
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            bool differs = false;
            for (int c = 0; c < a.channels; ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    differs = differs || std::abs(static_cast<double>(difference.at(c, y, x)[p])) > most;
            count += differs ? 1 : 0;
        }
    return count;
}

}  // namespace nicol::test
