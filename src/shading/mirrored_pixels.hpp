// SPDX-License-Identifier: MIT
// What the pixels of sixteen points see mirrored.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <span>

#include "polarization/lane_points.hpp"

namespace nicol {

/// Directions that pixels see mirrored: parallelograms around the directions of their middles.
struct MirroredPixels {
    void set(std::span<const std::array<glm::vec3, 2>> steps) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                across[k].x[i] = steps[i][k].x;
                across[k].y[i] = steps[i][k].y;
                across[k].z[i] = steps[i][k].z;
            }
            solid_angles[i] = glm::length(glm::cross(steps[i][0], steps[i][1]));
        }
    }

    /// Returns which part of the pixel's width its samples are spread over, by the solid angle of the lobe.
    /// The samples of a lobe that is wider than the pixel would only be noisier for it.
    [[nodiscard]] float part(std::size_t i, float lobe) const {
        return std::clamp(2 * solid_angles[i] - lobe, 0.0F, lobe) / std::max(lobe, kLeast);
    }
    /// Returns the solid angle that one of so many samples of a lobe looks up, spread over that part.
    [[nodiscard]] float solid_angle(std::size_t i, float lobe, float spread, float samples) const {
        constexpr float overlap = 2;  // measured best
        return lobe / samples + solid_angles[i] * (1 - spread + spread * overlap / samples);
    }

    /// Moves directions from the middles to the place (u, v), each in [0, 1), of these parts of the pixels,
    /// and makes them unit vectors.
    void move(const Lanes& u, const Lanes& v, const Lanes& parts, LaneVectors& directions) const {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float right = parts[i] * (u[i] - 0.5F), down = parts[i] * (v[i] - 0.5F);
            const float x = directions.x[i] + right * across[0].x[i] + down * across[1].x[i];
            const float y = directions.y[i] + right * across[0].y[i] + down * across[1].y[i];
            const float z = directions.z[i] + right * across[0].z[i] + down * across[1].z[i];
            const float length = std::sqrt(x * x + y * y + z * z);
            directions.x[i] = x / length;
            directions.y[i] = y / length;
            directions.z[i] = z / length;
        }
    }

    static constexpr float kLeast = 1e-12F;  ///< solid angle of a mirror's lobe

    std::array<LaneVectors, 2> across{};
    Lanes solid_angles{};
};

}  // namespace nicol
