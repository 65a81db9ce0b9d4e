// SPDX-License-Identifier: MIT
// Shading at pixels on threads.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "devices/cpu/smooth_chains.hpp"
#include "devices/cpu/surface_shading.hpp"
#include "methods/executor.hpp"
#include "shading/background.hpp"

namespace nicol {

/// Adds the background of an image, if the input has one, to out[c][pixel] for pixels first <= i < last,
/// behind surfaces that cover the part coverage[i - first].
void add_background(const PixelInput& input, std::size_t first, std::size_t last,
                    std::span<const float> coverage, std::span<const std::span<glm::vec4>> out);

/// Shading of the pixels of an image that show a surface. Calls for different pixels may run in parallel.
class PixelShading {
public:
    /// Keeps references to both arguments.
    PixelShading(const PixelInput& input, const SurfaceShading& surfaces)
        : input_(input), surfaces_(surfaces) {
        if (input.smooth != nullptr) chains_.emplace(surfaces);
    }

    /// Writes to out[c][pixel], for first <= pixel < last, the mean of channel c's Stokes vectors over the
    /// samples. Samples without a surface show the background.
    PointCounts run(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out) const;

private:
    const PixelInput& input_;
    const SurfaceShading& surfaces_;
    std::optional<SmoothChains> chains_;
};

}  // namespace nicol
