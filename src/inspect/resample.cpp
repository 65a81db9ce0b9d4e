// SPDX-License-Identifier: MIT
#include "inspect/resample.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "light/equirect.hpp"

namespace nicol {

EquirectImage resample_image(const Environment& light, const glm::dmat3& rotation, int source_width,
                             int width, int height) {
    EquirectImage image(width, height, light.channels());
    image.wavelengths = light.wavelengths();
    const int steps = std::clamp((source_width + width - 1) / width, 1, 64);
    std::vector<Stokes> sums(static_cast<std::size_t>(light.channels()));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::ranges::fill(sums, Stokes(0));
            double area = 0;
            for (int j = 0; j < steps; ++j) {
                const double v = (y + (j + 0.5) / steps - 0.5) / (height - 1);
                // Beyond a pole lies the opposite meridian; its frame is the one continued across the pole.
                const double weight = steps == 1 ? 1 : std::abs(std::sin(std::numbers::pi * v));
                for (int i = 0; i < steps; ++i) {
                    const double u = (x + (i + 0.5) / steps) / width;
                    const glm::dvec3 from =
                        glm::normalize(glm::transpose(rotation) * equirect_direction(u, v));
                    const double angle =
                        angle_between(rotation * theta_phi_frame(-from), equirect_frame(u, v));
                    for (std::size_t c = 0; c < sums.size(); ++c)
                        sums[c] += weight * rotated(light.radiance(static_cast<int>(c), from), angle);
                    area += weight;
                }
            }
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(static_cast<int>(c), y, x)[p] =
                        static_cast<float>(sums[c][static_cast<glm::length_t>(p)] / area);
        }
    }
    return image;
}

}  // namespace nicol
