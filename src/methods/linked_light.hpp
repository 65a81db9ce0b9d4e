// SPDX-License-Identifier: MIT
// Light that leaves surfaces along links, and arrives at vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "material/response_table.hpp"
#include "shading/local_lighting.hpp"
#include "shading/shade.hpp"
#include "surfaces/geometry.hpp"
#include "transfer/arriving_light.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/surface_links.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Links of a scene's vertices, grouped by the surfaces that they end at.
class LinkedSurfaces {
public:
    /// Links that end at one range, at most kMost.
    struct Batch {
        static constexpr std::size_t kMost = 16 * kLanes;

        std::uint32_t range;  ///< index of the geometry's range
        std::size_t first;    ///< numbers()[first .. first + count - 1] are the links
        std::size_t count;
        std::size_t weights;  ///< index of the batch's first weights
    };

    LinkedSurfaces() = default;
    /// links: in the order of their vertices.
    LinkedSurfaces(const WorldGeometry& geometry, std::vector<SurfaceLink> links);

    /// Computes the weights of textured materials' layers where links end.
    void find_weights(const WorldGeometry& geometry);

    [[nodiscard]] std::span<const SurfaceLink> links() const noexcept { return links_; }
    /// Returns the links of one vertex.
    [[nodiscard]] std::span<const SurfaceLink> links_of(std::size_t vertex) const {
        return std::span(links_).subspan(firsts_[vertex], firsts_[vertex + 1] - firsts_[vertex]);
    }
    [[nodiscard]] std::size_t first_of(std::size_t vertex) const { return firsts_[vertex]; }
    [[nodiscard]] std::span<const Batch> batches() const noexcept { return batches_; }
    /// Returns the indices of a batch's links.
    [[nodiscard]] std::span<const std::uint32_t> numbers(const Batch& batch) const {
        return std::span(numbers_).subspan(batch.first, batch.count);
    }
    /// Returns the weights of a batch's links, [sixteen links][layer]; empty: the material has no texture.
    [[nodiscard]] std::span<const LayerWeights> weights(const Batch& batch) const {
        return std::span(weights_).subspan(batch.weights);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return links_.size() * (sizeof(SurfaceLink) + sizeof(std::uint32_t)) +
               firsts_.size() * sizeof(std::size_t) + weights_.size() * sizeof(LayerWeights);
    }

private:
    std::vector<SurfaceLink> links_;
    std::vector<std::size_t> firsts_;     // first link of each vertex, and the number of links
    std::vector<std::uint32_t> numbers_;  // links by range
    std::vector<Batch> batches_;
    std::vector<LayerWeights> weights_;
};

/// Stokes vectors of links, [channel][link], in the frame field of link_frames().
using LinkStokes = std::vector<std::vector<glm::vec4>>;

/// Returns the viewpoint whose frame field the Stokes vectors of links have.
[[nodiscard]] Viewpoint link_frames();

/// Computes the reflection of local lights along the links of a batch. out: has room for all links.
LightingTally reflect_lights(const WorldGeometry& geometry, const DirectionSet& directions,
                             const LinkedSurfaces& surfaces, const LinkedSurfaces::Batch& batch,
                             const LocalLighting& lighting, LinkStokes& out);

/// One bounce: light at the vertices becomes light that arrives at them by links. Immutable; threads share
/// it. All lights have one layout and the image's channels.
class Bounce {
public:
    /// The arguments must outlive the object. tables: of plain_materials().
    Bounce(const WorldGeometry& geometry, const DirectionSet& directions, const LinkedSurfaces& surfaces,
           const std::map<MaterialPtr, ResponseTable>& tables, const LightLayout& layout);

    /// Computes the light that leaves surfaces along the links of a batch: the reflection of the vertices'
    /// light, and `lit` (empty: none). light: rows in the geometry's axes. out: has room for all links.
    void leave(const LinkedSurfaces::Batch& batch, const VertexLight& light, const LinkStokes& lit,
               LinkStokes& out) const;

    /// Computes the light that arrives at the sixteen vertices of a block, in their own frames.
    void arrive(std::size_t block, const LinkStokes& stokes, VertexLight& out) const;

private:
    const WorldGeometry& geometry_;
    const DirectionSet& directions_;
    const LinkedSurfaces& surfaces_;
    const std::map<MaterialPtr, ResponseTable>& tables_;
    Shade shade_;
    FrameRotation rotation_;
    ArrivingLight arriving_;
    Viewpoint frames_ = link_frames();
};

}  // namespace nicol
