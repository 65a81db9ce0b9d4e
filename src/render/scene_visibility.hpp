// SPDX-License-Identifier: MIT
// bake: the visibility of the environment at a scene's vertices, and the vertices at which a change keeps it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "material/response_cache.hpp"
#include "render/render.hpp"
#include "render/scene_geometry.hpp"
#include "render/surface_state.hpp"
#include "render/workers.hpp"
#include "versioned.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

class SceneVisibility {
public:
    /// Where to keep bakes; an empty folder: nowhere.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Bakes the surfaces, unless nothing casts shadows or `lit` is false, as far as changes make it
    /// necessary. Adds its times and counts to `statistics`.
    void update(const SceneGeometry& surfaces, bool lit, const RenderOptions& options, Workers& workers,
                Progress& progress, Statistics& statistics);

    /// The surfaces of the last update(); they must not have changed since.
    [[nodiscard]] SurfaceState state(const SceneGeometry& surfaces) const;

private:
    /// Returns whether the former bake was carried over. Then, if `narrow`, same_field_ keeps only vertices
    /// of unchanged visibility.
    bool bake(const SceneGeometry& surfaces, bool narrow, const RenderOptions& options, Workers& workers,
              Progress& progress, Statistics& statistics);

    std::filesystem::path folder_;
    CacheNotice notice_;
    Stage<int> spreading_;
    std::optional<DirectionSet> lattice_;
    Stage<int, glm::dmat3> rotating_;
    std::optional<DirectionSet> directions_;  // the lattice along the surfaces' own axes
    // Geometry, number of directions, their axes, whether unoccluded vertices count as occluded.
    Stage<Version, int, glm::dmat3, bool> baking_;
    Versioned<Visibility> visibility_;
    Version baked_ = 0;  // the geometry that visibility_ belongs to

    SurfaceVersions versions_;
    std::optional<SurfaceVersions> before_;  // that the vertices below are compared with
    std::vector<std::uint8_t> same_field_;
};

}  // namespace nicol
