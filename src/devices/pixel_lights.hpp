// SPDX-License-Identifier: MIT
// Local lights at pixels, on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "devices/mirrored_pixel.hpp"
#include "devices/pixel_batch.hpp"
#include "methods/executor.hpp"
#include "shading/pixel_origins.hpp"
#include "surfaces/local_lights.hpp"

namespace nicol {

class PixelLights {
public:
    /// Keeps references to both arguments, which must outlive the object.
    PixelLights(const LocalLighting& lighting, const PixelInput& input)
        : lighting_(lighting), input_(input) {}

    /// Adds to out[c][point] the batch's reflection of local lights.
    LightingTally add(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out) const;
    /// Adds to out[c][point] the batch's emission, if it is wanted. The input must have local lights.
    void add_emission(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out) const;

private:
    // Computes what the pixels of points show mirrored.
    void find_mirrored(std::span<const PixelPoint> points, const ShownPoints& shown,
                       MirroredPixels& out) const;
    // Returns what PixelOrigins needs of a point. lift: from the surface to its shadow rays' origins.
    [[nodiscard]] PixelOrigins::Part part_of(const PixelPoint& point, const Corners& triangle,
                                             const glm::vec3& lift) const;
    // Returns mirrored_parts() at a point. lane: of the point.
    [[nodiscard]] MirroredParts parts_at(const LaneSurface& surface, std::size_t lane,
                                         MirroredPixels& pixels) const;

    const LocalLighting& lighting_;
    const PixelInput& input_;
};

}  // namespace nicol
