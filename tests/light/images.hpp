// SPDX-License-Identifier: MIT
// Shared images and integrals of the light tests, and directions in an image by definition.
#pragma once

#include "directions.hpp"
#include "harmonics/evaluate.hpp"
#include "light/environment.hpp"
#include "test.hpp"

/// Returns the direction towards the light of an image position, by the definition of EquirectImage.
inline glm::dvec3 towards(double u, double v) {
    return {std::sin(2 * pi * u) * std::sin(pi * v), std::cos(pi * v),
            -std::cos(2 * pi * u) * std::sin(pi * v)};
}

/// Returns the image's Stokes frame. Its x is a difference along u, independent of the library's formula.
inline nicol::Frame pixel_frame(double u, double v) {
    const glm::dvec3 z = -towards(u, v);
    const glm::dvec3 x = glm::normalize(towards(u + 1e-5, 0.5) - towards(u - 1e-5, 0.5));
    return {x, glm::cross(z, x), z};
}

/// Returns random coefficients of every order and component plus a constant that keeps the light physically
/// realizable.
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

/// Returns an image of physically realizable light without symmetry.
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

/// Adds the light that travels along a direction times the harmonics there, times a weight.
inline void add_products(nicol::PshVector& sum, const nicol::Environment& light, const glm::dvec3& along,
                         double weight) {
    std::vector<double> scalar(nicol::psh_count(sum.order()));
    std::vector<std::complex<double>> spin2(scalar.size());
    nicol::harmonics_at(sum.order(), along, scalar, spin2);
    for (int c = 0; c < light.channels(); ++c) {
        const nicol::Stokes s = light.radiance(c, -along);
        for (std::size_t k = 0; k < scalar.size(); ++k) {
            const auto spin = weight * std::conj(spin2[k]) * std::complex<double>(s[1], s[2]);
            sum.channel(c)[4 * k] += weight * scalar[k] * s[0];
            sum.channel(c)[4 * k + 1] += spin.real();
            sum.channel(c)[4 * k + 2] += spin.imag();
            sum.channel(c)[4 * k + 3] += weight * scalar[k] * s[3];
        }
    }
}
