// SPDX-License-Identifier: MIT
// Rays at pixels that show smooth surfaces, on threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "devices/cpu/surface_shading.hpp"
#include "geometry/ray_scene.hpp"
#include "shading/ray_spread.hpp"

namespace nicol {

/// Chains of mirrored and refracted rays. A chain begins at each sample of a pixel that shows a smooth
/// surface. It ends at surfaces that are not smooth, whose light SurfaceShading computes, and at the
/// environment, which is looked up in its image. A Mueller matrix for each event takes the light to the
/// camera. Calls for different pixels may run in parallel.
class SmoothChains {
public:
    /// Largest number of reflections and refractions in a chain. Light of longer chains is left out.
    static constexpr int kMostEvents = 8;
    /// A chain has both branches of an event if each carries at least this fraction of its sample's light;
    /// otherwise one of them, chosen at random by the light that it carries.
    static constexpr double kBothCarry = 0.01;

    /// Keeps a reference. The input must have smooth surfaces.
    explicit SmoothChains(const SurfaceShading& surfaces);

    /// Adds to out[c][pixel], for first <= pixel < last, the light of the pixel's chains.
    void add(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out,
             PointCounts& counts) const;

private:
    /// Way of light from the end of a chain to the pixel.
    struct Way {
        std::uint32_t pixel;
        std::uint32_t matrices;  ///< index in Ends::matrices of the matrix of the first channel
    };
    /// Chain that goes on along a ray.
    struct Chain {
        Way way;
        Ray ray;
        RaySpread spread;
        Frame received;  ///< frame of the light that travels against the ray
        double carried;  ///< fraction of the sample's light
        int events;      ///< number of events so far
        bool lit;        ///< whether the surfaces before have reflected the lights on the ray already
        std::uint32_t seed;
    };
    struct Place;
    struct Ends;

    [[nodiscard]] Chain first_chain(std::size_t pixel, std::size_t sample, Ends& ends) const;
    /// Traces a chain's ray. Adds the chains that go on to `rest`.
    void follow(const Chain& chain, std::vector<Chain>& rest, Ends& ends) const;
    void pass(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const;
    void mirror(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const;
    void add_surfaces(Ends& ends, std::span<const std::span<glm::vec4>> out, PointCounts& counts) const;
    void add_sky(const Ends& ends, std::span<const std::span<glm::vec4>> out) const;
    void add_arriving(const Ends& ends, const Way& way, std::size_t channel, const glm::vec4& stokes,
                      std::span<const std::span<glm::vec4>> out) const;
    [[nodiscard]] Place place_at(const RayHit& hit, const Ray& ray, Ends& ends) const;
    /// Moves a chain's spread to the place, and returns the changes of the normal along it.
    [[nodiscard]] std::array<glm::dvec3, 2> bends_at(const Place& place, const glm::dvec3& normal,
                                                     const Ray& ray, RaySpread& spread) const;

    const SurfaceShading& surfaces_;
    const PixelInput& input_;
    glm::vec4 wanted_;  // 1 for the image's components, else 0
};

}  // namespace nicol
