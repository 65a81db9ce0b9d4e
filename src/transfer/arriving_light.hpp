// SPDX-License-Identifier: MIT
// Projection of light that arrives from single directions, such as that of links.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "polarization/viewpoint.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Numbers of LightLayout, in the axes of the directions, for light from each direction of a set. Immutable;
/// threads share it.
class ArrivingLight {
public:
    /// directions: unit vectors to where the light comes from. Stokes vectors are in the frame field of
    /// `frames`.
    ArrivingLight(const LightLayout& layout, std::span<const glm::vec3> directions, const Viewpoint& frames);

    /// Solid angles of a direction.
    struct SolidAngles {
        float scalar;     ///< solid angle for s0
        float polarized;  ///< solid angle for s1, s2 and s3
    };
    /// Adds lights from a direction, in solid angles, to their numbers, [number][Lanes of lights]. stokes:
    /// [component][Lanes of lights], as many components (1, 3 or 4) as `components`. With one component, only
    /// the numbers of s0 are changed.
    void add(std::size_t direction, const SolidAngles& solid_angles, std::size_t components,
             std::size_t lanes, const Lanes* stokes, Lanes* numbers) const;
    /// Returns how many numbers s0 has.
    [[nodiscard]] std::size_t scalars() const noexcept { return spin_; }

private:
    std::size_t spin_;
    std::size_t s3_;
    std::size_t size_;
    std::size_t stride_;
    /// [direction]: numbers of s0 = 1, then those of the spin-2 part for s1 = 1 and for s2 = 1.
    std::vector<float> data_;
};

/// Adds to each light its mirror image in the plane of its surface, in place: for light of the upper
/// hemisphere alone, which so loses its edge at the horizon. Reflection sees none of the image. Block of
/// sixteen lights in their surfaces' frames.
void add_mirror_image(const LightLayout& layout, VertexLight& light, std::size_t block);

/// Returns, for each number of a light of layout `part`, its index in a light of layout `whole`, which has at
/// least the order and the components of the part.
[[nodiscard]] std::vector<std::size_t> places_in(const LightLayout& part, const LightLayout& whole);

}  // namespace nicol
