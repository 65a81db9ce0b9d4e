// SPDX-License-Identifier: MIT
// The reflection integral in the angular domain. The only harmonics in it are those of the light.
#pragma once

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "harmonics/evaluate.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/light_coefficients.hpp"
#include "harmonics/psh.hpp"
#include "material/material.hpp"
#include "material/response_table.hpp"

namespace nicol::test {

/// Returns the light reflected towards `towards_viewer` (unit, world) by a surface whose normal is frame[2].
/// The Stokes vector is in the theta-phi frame of `towards_viewer` about the world's z. `light` is a field
/// over propagation directions in the world.
inline Stokes reflected(const Material& material, int channel, const PshVector& light, const Frame& frame,
                        const glm::dvec3& towards_viewer, int zeniths = 96, int azimuths = 192) {
    const LatitudeRows rows = gauss_legendre_rows(zeniths);
    const glm::dvec3 viewer = towards_viewer * frame;
    std::vector<glm::dvec3> directions;
    std::vector<Mueller> responses;
    for (int j = 0; j < zeniths; ++j) {
        const double cosine = (std::cos(rows.theta[static_cast<std::size_t>(j)]) + 1) / 2;
        const double sine = std::sqrt(1 - cosine * cosine);
        const double weight =
            rows.weight[static_cast<std::size_t>(j)] / 2 * cosine * 2 * std::numbers::pi / azimuths;
        for (int k = 0; k < azimuths; ++k) {
            const double phi = 2 * std::numbers::pi * (k + 0.5) / azimuths;
            const glm::dvec3 incident(sine * std::cos(phi), sine * std::sin(phi), cosine);
            Mueller m;
            for (int t = 0; t < material.terms(); ++t) {
                m = m + material.weight(t, channel) * material.evaluate(t, incident, viewer);
            }
            // Angle from the theta-phi frame of the propagation in the world to that of the surface.
            const glm::dvec3 propagation = -(frame * incident);
            const double angle =
                angle_between(theta_phi_frame(propagation), frame * theta_phi_frame(-incident));
            directions.push_back(propagation);
            responses.push_back(weight * m * frame_rotation(angle));
        }
    }
    std::vector<Stokes> radiance(directions.size());
    evaluate(light, channel, directions, radiance);
    Stokes out(0.0);
    for (std::size_t i = 0; i < directions.size(); ++i) out += responses[i] * radiance[i];
    return rotated(out, angle_between(frame * theta_phi_frame(viewer), theta_phi_frame(towards_viewer)));
}

/// Applies rows of the table to light in the surface's frame, for a viewer at that table angle and azimuth 0.
inline Stokes respond(const ResponseTable& table, const LightLayout& layout, const PshVector& light,
                      int angle) {
    return rows_times_light(table.rows(angle, 0), light_pairs(layout, light.channel(0)));
}

/// Returns light with every coefficient that `components` (1, 3 or 4) allows, decaying with the order.
inline PshVector random_light(int order, int channels, int components, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    PshVector light(order, channels);
    for (int c = 0; c < channels; ++c) {
        for (int l = 0; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = 0; p < components; ++p) {
                    if (l < 2 && (p == 1 || p == 2)) continue;
                    light.at(c, l, m, p) = normal(random) / (1 + l);
                }
            }
        }
    }
    return light;
}

}  // namespace nicol::test
