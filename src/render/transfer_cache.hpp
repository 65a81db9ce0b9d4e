// SPDX-License-Identifier: MIT
// project, bake, relight and shade for one scene, computing again only what changes make necessary.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "nicol/light_layout.hpp"
#include "nicol/render.hpp"
#include "nicol/scene.hpp"
#include "render/dense_method.hpp"
#include "render/factored_method.hpp"
#include "render/geometry.hpp"
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

    /// Shades every vertex that can be seen; the result is in stokes(). Adds its times and counts to
    /// `statistics`.
    void update(const Scene& scene, const Projection& projection, const RenderOptions& options,
                Progress& progress, Statistics& statistics);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return geometry_; }
    /// Counts the times geometry() changed.
    [[nodiscard]] std::uint64_t geometry_revision() const noexcept { return geometry_revision_; }
    [[nodiscard]] const VertexStokes& stokes() const noexcept { return stokes_; }

private:
    void project_light(const Scene& scene, int order, Statistics& statistics);
    void turn_light(const Scene& scene, Statistics& statistics);

    void bake(const Scene& scene, const RenderOptions& options, Progress& progress, Statistics& statistics);

    Workers workers_;
    std::filesystem::path folder_;
    CacheNotice notice_;

    WorldGeometry geometry_;
    std::uint64_t geometry_revision_ = 0;

    std::optional<DirectionSet> directions_;
    Visibility visibility_;
    std::uint64_t visibility_revision_ = 0;  // geometry_revision_ that visibility_ belongs to

    EnvironmentPtr environment_;  // that light_ was projected from
    PshVector light_;             // in the environment's axes, unscaled; one channel where all are equal
    std::optional<LightLayout> layout_;
    std::uint64_t scene_light_revision_ = 0;  // that turned_ belongs to
    PshVector turned_;                        // in the world's axes, scaled
    std::uint64_t light_revision_ = 0;        // counts the changes of turned_

    FactoredMethod factored_;
    DenseMethod dense_;

    std::vector<std::uint8_t> visible_;
    VertexStokes stokes_;
};

}  // namespace nicol
