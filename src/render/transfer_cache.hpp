// SPDX-License-Identifier: MIT
// project, bake, relight and shade for one scene, computing again only what changes make necessary.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "nicol/render.hpp"
#include "nicol/scene.hpp"
#include "render/compute/compute_executor.hpp"
#include "render/dense_method.hpp"
#include "render/error_budget.hpp"
#include "render/factored_method.hpp"
#include "render/geometry.hpp"
#include "render/high_orders.hpp"
#include "render/light_projection.hpp"
#include "render/progress.hpp"
#include "render/transfer_input.hpp"
#include "render/workers.hpp"
#include "transfer/visibility.hpp"

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
    void update(const Scene& scene, const Projection& projection, const RenderOptions& options,
                ComputeExecutor* device, Progress& progress, Statistics& statistics);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return geometry_; }
    /// Counts the times geometry() changed.
    [[nodiscard]] std::uint64_t geometry_revision() const noexcept { return geometry_revision_; }
    [[nodiscard]] const VertexStokes& stokes() const noexcept { return stokes_; }
    /// What the last update() left for pixels to add; null where nothing.
    [[nodiscard]] const HighOrderTransfer* pixel_high_orders() const noexcept {
        return at_pixels_ ? &high_orders_ : nullptr;
    }

private:
    /// The options with the orders that their tolerance allows.
    RenderOptions choose_orders(const Scene& scene, const RenderOptions& options, bool shadowed,
                                Statistics& statistics);
    void bake(const Scene& scene, const RenderOptions& options, Progress& progress, Statistics& statistics);

    Workers workers_;
    std::filesystem::path folder_;
    CacheNotice notice_;

    WorldGeometry geometry_;
    std::uint64_t geometry_revision_ = 0;

    std::optional<DirectionSet> lattice_;
    std::optional<DirectionSet> directions_;  // of the bake: the lattice along the scene's own axes
    Visibility visibility_;
    bool shadow_all_ = false;                // vertices that see all count as occluded
    std::uint64_t baked_geometry_ = 0;       // geometry_revision_ that visibility_ belongs to
    std::uint64_t visibility_revision_ = 0;  // counts the bakes

    ErrorBudget budget_;
    LightProjection light_;

    FactoredMethod factored_;
    DenseMethod dense_;
    HighOrderTransfer high_orders_;
    bool at_pixels_ = false;

    std::vector<std::uint8_t> visible_;
    VertexStokes stokes_;
};

}  // namespace nicol
