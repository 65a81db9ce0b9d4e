// SPDX-License-Identifier: MIT
// Directions and rotations for tests.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "polarization/mueller.hpp"

/// Returns the unit vector at angle `zenith` from the z axis and `azimuth` about it.
inline glm::dvec3 direction(double zenith, double azimuth) {
    return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith)};
}

/// Returns a random direction. The three numbers are drawn one by one, because compilers evaluate the
/// arguments of a call in different orders and would test different numbers.
template <class Random, class Normal = std::normal_distribution<double>>
glm::dvec3 random_direction(Random& random, Normal&& normal = Normal()) {
    const double z = normal(random), y = normal(random), x = normal(random);
    return glm::normalize(glm::dvec3(x, y, z));
}

/// Returns a random direction up to angle `largest_zenith` from the z axis.
template <class Random>
glm::dvec3 random_direction_within(Random& random, double largest_zenith) {
    std::uniform_real_distribution<double> uniform;
    const double zenith = largest_zenith * uniform(random);
    return direction(zenith, 2 * std::numbers::pi * uniform(random));
}

inline std::vector<glm::dvec3> random_directions(int count, unsigned seed = 1) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> result;
    for (int i = 0; i < count; ++i) result.push_back(random_direction(engine, normal));
    return result;
}

namespace nicol {

/// Returns the 16 elements row by row, for largest() and largest_difference().
inline std::array<double, 16> numbers_in(const Mueller& m) {
    std::array<double, 16> out;
    for (std::size_t i = 0; i < 16; ++i) out[i] = m(i / 4, i % 4);
    return out;
}

}  // namespace nicol

/// Returns an arbitrary rotation: the axes of the frame at a random direction, rotated about it.
inline glm::dmat3 some_rotation(unsigned seed = 1) {
    const auto d = random_directions(2, seed);
    return nicol::frame_with_x(d[0], d[1]);
}
