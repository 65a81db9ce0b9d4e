// SPDX-License-Identifier: MIT
// project, bake, relight and shade for one scene, computing again only what changes make necessary.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "progress.hpp"
#include "render/dense_method.hpp"
#include "render/factored_method.hpp"
#include "render/gpu/compute_executor.hpp"
#include "render/high_orders.hpp"
#include "render/light_projection.hpp"
#include "render/order_selector.hpp"
#include "render/render.hpp"
#include "render/scene_geometry.hpp"
#include "render/shaded_vertices.hpp"
#include "render/transfer_input.hpp"
#include "render/workers.hpp"
#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

class TransferCache {
public:
    /// threads = 0: one a core.
    explicit TransferCache(int threads) : workers_(threads) {}

    /// Where to keep what takes long to compute; an empty folder: nowhere.
    void set_cache(const std::filesystem::path& folder, const CacheNotice& notice);

    /// Shades every vertex that can be seen; the result is in stokes(), or in the buffers of `device` where
    /// that is not null. High orders are at vertices where `options` leaves that open. Adds its times and
    /// counts to `statistics`.
    /// `projection`: of the world.
    void update(const Scene& scene, const Projection& projection, const RenderOptions& options,
                ComputeExecutor* device, Progress& progress, Statistics& statistics);

    /// What is drawn, in axes of its own.
    [[nodiscard]] const SceneGeometry& surfaces() const noexcept { return surfaces_; }
    [[nodiscard]] const VertexStokes& stokes() const noexcept { return stokes_; }
    /// What the last update() left for pixels to add; null where nothing.
    [[nodiscard]] const HighOrderTransfer* pixel_high_orders() const noexcept {
        return at_pixels_ ? &high_orders_ : nullptr;
    }

private:
    /// The bake and what it made of the vertices that a change of the scene left as they were.
    void follow_geometry(const Scene& scene, const RenderOptions& options, Progress& progress,
                         Statistics& statistics);
    /// The options with the orders that their tolerance allows.
    RenderOptions choose_orders(const Scene& scene, const RenderOptions& options, Statistics& statistics);
    void bake(const RenderOptions& options, Progress& progress, Statistics& statistics);

    Workers workers_;
    std::filesystem::path folder_;
    CacheNotice notice_;

    SceneGeometry surfaces_;

    std::optional<DirectionSet> lattice_;
    std::optional<DirectionSet> directions_;  // of the bake: the lattice along the surfaces' own axes
    glm::dmat3 directions_axes_{1.0};
    Visibility visibility_;
    bool shadow_all_ = false;                // vertices that see all count as occluded
    std::uint64_t baked_geometry_ = 0;       // revision of the surfaces that visibility_ belongs to
    std::uint64_t visibility_revision_ = 0;  // counts the bakes
    bool rebaked_ = false;                   // the last bake took over what it could of the one before
    bool shadowed_ = false;                  // anything is

    // Of the last update: revisions, the second 0 where nothing was shadowed.
    std::uint64_t last_geometry_ = 0;
    std::uint64_t last_visibility_ = 0;
    bool follows_ = false;                 // this update's state from that one
    std::vector<std::uint8_t> unchanged_;  // vertices, where it does

    OrderSelector budget_;
    LightProjection light_;

    FactoredMethod factored_;
    DenseMethod dense_;
    HighOrderTransfer high_orders_;
    bool at_pixels_ = false;

    std::vector<std::uint8_t> visible_;
    ShadedVertices shaded_;
    VertexStokes stokes_;
};

}  // namespace nicol
