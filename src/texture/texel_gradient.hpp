// SPDX-License-Identifier: MIT
// Gradients by the texels of an image texture.
#pragma once

#include <tbb/spin_mutex.h>

#include <array>
#include <cstdint>
#include <vector>

#include "simd/lanes.hpp"
#include "texture/footprint.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Sums of gradients by texels: the transpose of Texture::at_lanes() and of image_levels().
class TexelGradient {
public:
    /// image: the texture of an image, which must outlive the object.
    explicit TexelGradient(const Texture& image);

    /// Adds gradients by the channels of the texture's values at the points, of those with a bit in `chosen`.
    /// Threads may call it side by side.
    void add(const TexturePoints& points, std::uint32_t chosen, const std::array<Lanes, 4>& values);

    /// Returns the gradient by the image's values, [row][column][channel], once.
    [[nodiscard]] std::vector<double> take();

    /// Returns the most bytes that an object for an image takes, what take() returns included.
    [[nodiscard]] static std::uint64_t bytes(const Texture& image);

private:
    /// Adds gradients times factors to the texels of each point's level.
    void add_between(const LaneTexels& texels, const LaneIntegers& level, std::uint32_t chosen,
                     const Lanes& factors, const std::array<Lanes, 4>& values);

    TextureSampling sampling_;
    MipmapShape shape_;
    std::size_t channels_;
    std::vector<std::vector<double>> levels_;  // [level][row][column][channel]
    tbb::spin_mutex mutex_;
};

}  // namespace nicol
