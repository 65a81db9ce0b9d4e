// SPDX-License-Identifier: MIT
// Points that are shaded together, on threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/cpu/pixel_list.hpp"
#include "render/cpu/textured_pixels.hpp"
#include "shading/lane_surface.hpp"

namespace nicol {

/// Points of one group: where they lie, and what textures are there. Holds results; one object a thread.
class PixelBatch {
public:
    /// Points, so that what every call costs counts for many.
    static constexpr std::size_t kMost = 16 * kLanes;

    /// Takes the first of the points: those of one group, as many as there is room for.
    void take(const PixelInput& input, std::span<const PixelPoint> points);

    [[nodiscard]] std::span<const PixelPoint> points() const { return points_; }
    /// Of sixteen points each; their normals are those of textures.
    [[nodiscard]] std::span<const LaneSurface> surfaces() const {
        return std::span(surfaces_).first((points_.size() + kLanes - 1) / kLanes);
    }
    /// [sixteen points][layer] of a material that varies; empty: it does not.
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }

    /// Adds to out[c][pixel - first] the points' stokes[c][point], times their weights: the first so many
    /// components.
    void gather(std::span<const std::span<glm::vec4>> stokes, std::size_t components, std::size_t first,
                std::span<const std::span<glm::vec4>> out) const;

private:
    void find_surfaces(const PixelInput& input);
    void find_textures(const PixelInput& input, const VertexRange& range);

    std::span<const PixelPoint> points_;
    std::array<LaneSurface, kMost / kLanes> surfaces_;
    std::span<const LayerWeights> weights_;
    // Where the material varies.
    TexturedPixels textures_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace nicol
