// SPDX-License-Identifier: MIT
// Light of local lights that smooth surfaces reflect or refract to other surfaces, kept as photons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "light/lane_light.hpp"

namespace nicol {

/// Part of the light, where it reaches a surface.
struct Photon {
    glm::vec3 position;
    glm::vec3 normal;   ///< unit normal of the surface, on the side that the light reaches
    glm::vec3 towards;  ///< unit vector towards the place that the light comes from
};

/// Density of photons on surfaces. Each photon is spread over a disc that reaches to its neighbours.
/// Immutable; threads share it.
class FocusedLight {
public:
    /// powers: [photon][channel], unpolarized. Runs on the calling thread's TBB arena.
    FocusedLight(std::vector<Photon> photons, std::vector<float> powers, std::size_t channels);

    /// Computes the unpolarized light at points of surfaces, at most kLanes, from its mean direction. `out`
    /// contains the points that light reaches; distances are infinite. normals: unit shading normals.
    void gather(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                LaneLight& out) const;

    [[nodiscard]] std::size_t photons() const noexcept { return photons_.size(); }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Returns the largest number of bytes for so many photons.
    [[nodiscard]] static std::size_t most_bytes(std::size_t photons, std::size_t channels);

private:
    /// Photons that reach into a cell of space: in_cells_[first] to in_cells_[last - 1]. first ==
    /// last: the bucket is empty.
    struct Bucket {
        std::uint64_t key;
        std::uint32_t first, last;
    };
    using Entry = std::pair<std::uint64_t, std::uint32_t>;  // key of a cell, index of a photon

    void find_radii();
    void fill_cells();
    /// Returns the photons of each cell, by key. coarser: binary exponent of the cells' sizes, beyond what
    /// the photons need.
    [[nodiscard]] std::vector<Entry> entries(int coarser);
    /// Returns the index of a cell's bucket, or of an empty one.
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const;

    std::vector<Photon> photons_;
    std::vector<float> powers_;
    std::size_t channels_;
    std::vector<float> radii_;
    std::vector<int> levels_;  // binary exponents of the sizes of cells
    std::vector<std::uint32_t> in_cells_;
    std::vector<Bucket> buckets_;  // a power of two; each at the place of its key or the next free one
};

}  // namespace nicol
