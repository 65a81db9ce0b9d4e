// SPDX-License-Identifier: MIT
// bake: vertices where shadows need them, what of the environment each sees, and where a change keeps that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "material/response_cache.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_rays.hpp"
#include "surfaces/surface_state.hpp"
#include "versioned.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

class SceneVisibility {
public:
    /// Where to keep bakes; an empty folder: nowhere.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Bakes and refines the surfaces, unless nothing casts shadows or `lit` is false, as far as changes make
    /// it necessary. `rays` are the surfaces'. Adds its times and counts to `statistics`.
    void update(const SceneGeometry& surfaces, SurfaceRays& rays, bool lit, const RenderOptions& options,
                Workers& workers, Progress& progress, Statistics& statistics);

    /// Of the last update().
    [[nodiscard]] SurfaceState state() const;
    [[nodiscard]] const RefinedSurfaces& surfaces() const noexcept { return surfaces_; }

private:
    /// Of the surfaces as they are. Returns whether the former bake was carried over.
    bool bake(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
              Workers& workers, Progress& progress, Statistics& statistics);
    void refine(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
                Workers& workers, Progress& progress, Statistics& statistics);

    std::filesystem::path folder_;
    CacheNotice notice_;
    Stage<int> spreading_;
    std::optional<DirectionSet> lattice_;
    Stage<int, glm::dmat3> rotating_;
    std::optional<DirectionSet> directions_;  // the lattice along the surfaces' own axes
    // Geometry, number of directions, their axes.
    Stage<Version, int, glm::dmat3> baking_;
    Versioned<std::shared_ptr<const Visibility>> baked_;
    Version baked_geometry_ = 0;  // that it belongs to
    // Bake, tolerance, bound, whether unoccluded vertices count as occluded.
    Stage<Version, double, std::uint64_t, bool> refining_;
    std::shared_ptr<WorldGeometry> refined_;                // null: nothing was split
    std::vector<TrianglePart> parts_;                       // its triangles
    Versioned<std::shared_ptr<const Visibility>> visible_;  // from surfaces_
    RefinedSurfaces surfaces_;

    SurfaceVersions versions_;
    std::optional<SurfaceVersions> before_;  // that the vertices below are compared with
    std::vector<std::uint8_t> same_field_;
};

}  // namespace nicol
