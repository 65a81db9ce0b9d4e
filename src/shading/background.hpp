// SPDX-License-Identifier: MIT
// The environment as the background of an image.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "light/equirect_texels.hpp"

namespace nicol {

/// Rays through the centres of an image's pixels, in a light's axes: first + column * right + row * down, of
/// any length. `up` is the camera's.
struct PixelRays {
    glm::vec3 first, right, down, up;
    std::size_t width;  ///< width of the image, in pixels
};

/// Image of an environment, interpolated bilinearly as EquirectImage defines. Immutable; threads share it.
class Background {
public:
    /// channels: those of the images that it is added to; an environment of one channel serves all.
    Background(const Environment& environment, int channels);

    /// Adds the environment's Stokes vectors to out[c][pixel], row by row for first <= pixel < last: channel
    /// c's light in the camera's frame field, times the scale and 1 - coverage[pixel - first]. Only the first
    /// `components` Stokes components are added.
    void add(const PixelRays& rays, float scale, std::size_t components, std::size_t first, std::size_t last,
             std::span<const float> coverage, std::span<const std::span<glm::vec4>> out) const;

private:
    struct Pixels;

    [[nodiscard]] glm::vec4 at(std::size_t plane, const Pixels& pixels, std::size_t lane) const;
    void add(const Pixels& pixels, std::size_t components, std::span<const std::span<glm::vec4>> out) const;

    bool polarized_;
    EquirectTexels texels_;
};

}  // namespace nicol
