// SPDX-License-Identifier: MIT
// How far images are from each other, over all pixels, channels and components.
#pragma once

#include "image/stokes_image.hpp"
#include "test.hpp"

namespace nicol::test {

inline double largest(const StokesImage& image) {
    float most = 0;
    for (const float value : image.data) most = std::max(most, std::abs(value));
    return static_cast<double>(most);
}

inline double largest_difference(const StokesImage& a, const StokesImage& b) {
    REQUIRE(a.data.size() == b.data.size());
    double most = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a.data[i]) - static_cast<double>(b.data[i])));
    return most;
}

/// Root of the mean square.
inline double rms(const StokesImage& image) {
    double sum = 0;
    for (const float value : image.data) sum += std::pow(static_cast<double>(value), 2);
    return std::sqrt(sum / static_cast<double>(image.data.size()));
}

inline double rms_difference(const StokesImage& a, StokesImage b) {
    REQUIRE(a.data.size() == b.data.size());
    for (std::size_t i = 0; i < a.data.size(); ++i) b.data[i] -= a.data[i];
    return rms(b);
}

inline bool finite(const StokesImage& image) {
    return std::ranges::all_of(image.data, [](float value) { return std::isfinite(value); });
}

}  // namespace nicol::test
