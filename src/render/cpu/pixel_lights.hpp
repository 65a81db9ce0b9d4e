// SPDX-License-Identifier: MIT
// Small lights at pixels, on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "render/executor.hpp"
#include "render/small_lights.hpp"
#include "shading/lane_surface.hpp"

namespace nicol {

/// Points of one range that pixels show.
struct PixelPoints {
    std::span<const LaneSurface> surfaces;     ///< sixteen points each, as they are shaded
    std::span<const std::uint32_t> triangles;  ///< of each point
    std::span<const std::uint32_t> pixels;     ///< likewise
    std::span<const LayerWeights> weights;  ///< [sixteen points][layer] of a material that varies, or empty
    bool shadowed;                          ///< see LitPoints
};

class PixelLights {
public:
    /// Both must outlive this.
    PixelLights(const SmallLights& lights, const PixelInput& input) : lights_(lights), input_(input) {}

    /// Adds to out[c][point] what the points reflect of small lights, and what they emit. Returns the number
    /// of rays.
    std::uint64_t add(const VertexRange& range, const PixelPoints& points,
                      std::span<const std::span<glm::vec4>> out) const;

private:
    void add_emission(const VertexRange& range, const PixelPoints& points, std::size_t first,
                      std::span<const std::span<glm::vec4>> out) const;

    const SmallLights& lights_;
    const PixelInput& input_;
};

}  // namespace nicol
