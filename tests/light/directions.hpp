// SPDX-License-Identifier: MIT
// Directions, rotations and images that the light tests share.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "light/environment.hpp"

inline std::vector<glm::dvec3> random_directions(int count, unsigned seed = 1) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> result;
    for (int i = 0; i < count; ++i)
        result.push_back(glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine))));
    return result;
}

/// Any rotation: the axes of the frame at a random direction, rotated about it.
inline glm::dmat3 some_rotation(unsigned seed) {
    const auto d = random_directions(2, seed);
    return nicol::frame_with_x(d[0], d[1]);
}

/// The direction towards the light of an image position, written out from the definition of EquirectImage.
inline glm::dvec3 towards(double u, double v) {
    const double pi = std::numbers::pi;
    return {std::sin(2 * pi * u) * std::sin(pi * v), std::cos(pi * v),
            -std::cos(2 * pi * u) * std::sin(pi * v)};
}

/// The image's Stokes frame: x by a difference along u, so independent of the library's formula.
inline nicol::Frame pixel_frame(double u, double v) {
    const glm::dvec3 z = -towards(u, v);
    const glm::dvec3 x = glm::normalize(towards(u + 1e-5, 0.5) - towards(u - 1e-5, 0.5));
    return {x, glm::cross(z, x), z};
}

/// Physical light without any symmetry.
inline nicol::EquirectImage random_image(int width, int height, int channels, unsigned seed,
                                         bool polarized = true) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-0.55f, 0.55f);
    nicol::EquirectImage image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); i += 4) {
        image.data[i] = 1 + uniform(engine);
        const float share = image.data[i];
        if (!polarized) continue;
        for (std::size_t p = 1; p < 4; ++p) image.data[i + p] = share * uniform(engine);
    }
    return image;
}
