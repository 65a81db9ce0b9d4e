// SPDX-License-Identifier: MIT
// Links of receivers, grouped by the materials that they end at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "polarization/viewpoint.hpp"
#include "shading/local_lighting.hpp"
#include "surfaces/geometry.hpp"
#include "transfer/receivers.hpp"

namespace nicol {

/// Receivers of a scene and their links, sixteen receivers a block.
class LinkedSurfaces {
public:
    /// Links of one block that end at one material, at most kLanes. Either all or none are coarse.
    struct Batch {
        std::uint32_t range;  ///< index of a range of the material
        std::uint32_t count;
        std::size_t first;  ///< links()[first .. first + count - 1] are the batch's
    };

    LinkedSurfaces() = default;
    LinkedSurfaces(const WorldGeometry& geometry, Receivers receivers);

    /// Computes the weights of textured materials' layers where links end.
    void find_weights(const WorldGeometry& geometry);

    [[nodiscard]] std::size_t receivers() const noexcept { return receivers_.vertices.size(); }
    [[nodiscard]] std::size_t blocks() const noexcept { return (receivers() + kLanes - 1) / kLanes; }
    /// Returns the vertex of each receiver.
    [[nodiscard]] std::span<const std::uint32_t> vertices() const noexcept { return receivers_.vertices; }
    [[nodiscard]] std::span<const Receivers::Blend> blends() const noexcept { return receivers_.blends; }
    /// Returns the links, block by block.
    [[nodiscard]] std::span<const SurfaceLink> links() const noexcept { return receivers_.links; }
    /// Returns the receiver that stands for the bounced light where a link ends, chosen as if by chance among
    /// those that interpolation there would blend; kNoVertex: no bounced light arrives there.
    [[nodiscard]] std::uint32_t receiver_at(std::size_t link) const { return ends_[link]; }
    [[nodiscard]] std::span<const Batch> batches(std::size_t block) const {
        return std::span(batches_).subspan(firsts_[block], firsts_[block + 1] - firsts_[block]);
    }
    /// Returns the leading batches of a block, those of coarse links.
    [[nodiscard]] std::span<const Batch> coarse_batches(std::size_t block) const {
        return batches(block).first(coarse_[block]);
    }
    /// Returns the weights of the layers where a batch's links end; empty: the material has no texture.
    [[nodiscard]] std::span<const LayerWeights> weights(const Batch& batch) const;
    /// Returns whether all weights are equal in all channels.
    [[nodiscard]] bool grey() const noexcept { return grey_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    Receivers receivers_;
    std::vector<std::uint32_t> ends_;
    std::vector<Batch> batches_;
    std::vector<std::size_t> firsts_;  // first batch of each block, and the number of batches
    std::vector<std::size_t> coarse_;  // number of batches of coarse links of each block
    std::vector<LayerWeights> weights_;
    std::vector<std::size_t> first_weights_;  // of each batch, and the number of weights
    bool grey_ = true;
};

/// Returns what links are searched in: a geometry that must outlive the result.
[[nodiscard]] BakeGeometry link_geometry(const WorldGeometry& geometry);
/// Returns the triangles of a geometry by the side that they show.
[[nodiscard]] TriangleSides sides_of(const WorldGeometry& geometry);
/// Returns the weights of the corners of a link's triangle at its end.
[[nodiscard]] inline glm::vec3 corner_weights(const SurfaceLink& link) {
    return {1 - link.b1 - link.b2, link.b1, link.b2};
}
/// Returns the normal where a link ends, interpolated between the corners of its triangle. direction: of the
/// link.
[[nodiscard]] glm::vec3 normal_at_end(const WorldGeometry& geometry, const SurfaceLink& link,
                                      const glm::vec3& direction);

/// Stokes vectors of links, [channel][link], in the frame field of link_frames().
using LinkStokes = std::vector<std::vector<glm::vec4>>;

/// Returns the viewpoint whose frame field the Stokes vectors of links have.
[[nodiscard]] Viewpoint link_frames();

/// Computes the reflection of local lights along the links of a batch. out: has room for all links.
LightingTally reflect_lights(const WorldGeometry& geometry, const DirectionSet& directions,
                             const LinkedSurfaces& surfaces, const LinkedSurfaces::Batch& batch,
                             const LocalLighting& lighting, LinkStokes& out);

}  // namespace nicol
