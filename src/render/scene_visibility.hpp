// SPDX-License-Identifier: MIT
// Bake of a scene: vertices added for shadows, the visibility of all vertices, and the parts that a change
// keeps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "material/response_cache.hpp"
#include "render/needed_vertices.hpp"
#include "render/progressive_bake.hpp"
#include "render/shown_visibility.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_rays.hpp"
#include "surfaces/surface_state.hpp"
#include "versioned.hpp"
#include "visibility/disturbance_record.hpp"
#include "visibility/refine.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Images that a bake is for.
struct BakedImages {
    ImageNeeds needs = ImageNeeds::all;
    std::span<const Projection> views = {};    ///< of the surfaces' axes
    std::span<const glm::dvec2> samples = {};  ///< as for needed_vertices()
    bool lobes = false;                        ///< whether rays follow lobes, as for shows_others()
};

class SceneVisibility {
public:
    /// Sets the cache folder of bakes; an empty folder disables the cache.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Bakes and refines the surfaces, unless nothing casts shadows or `lit` is false; repeats only what
    /// changes require, within the options' budget. rays: of the surfaces. images: of this render; more is
    /// baked once an image needs it. Adds times and counts to `statistics`.
    void update(const SceneGeometry& surfaces, SurfaceRays& rays, bool lit, const BakedImages& images,
                const RenderOptions& options, Workers& workers, Progress& progress, Statistics& statistics);
    /// Bakes vertices that the last update() left out although images show them: an image that is drawn may
    /// show another triangle beside an outline than rays do. Bakes all if a triangle among them is smooth.
    /// find_shown: returns, by vertex of surfaces(), whether an image shows it; called if that may matter.
    /// lobes: as for shows_others(). The rest is of the last update().
    void bake_shown(const SceneGeometry& surfaces, SurfaceRays& rays,
                    const std::function<std::span<const std::uint8_t>()>& find_shown, bool lobes,
                    const RenderOptions& options, RenderRun& run);
    /// Sets numbers of vertices and bytes in `statistics`. surfaces: of the last update().
    void count(const SceneGeometry& surfaces, Statistics& statistics) const;
    /// Tells how long later steps took for the vertices that update() changed.
    void count_later_steps(double milliseconds);
    /// Returns the number of vertices whose visibility is not final.
    [[nodiscard]] std::size_t pending() const noexcept { return progressive_ ? progressive_->pending() : 0; }

    /// Returns whether the last update() added to the bake what a further view shows.
    [[nodiscard]] bool grew() const noexcept { return grew_; }

    /// Returns the state of the last update().
    [[nodiscard]] SurfaceState state() const;
    [[nodiscard]] const RefinedSurfaces& surfaces() const noexcept { return surfaces_; }

private:
    void find_directions(const SceneGeometry& surfaces, const RenderOptions& options);
    /// Updates by slices: as much as the budget allows.
    void update_progressively(const SceneGeometry& surfaces, SurfaceRays& rays,
                              std::span<const Projection> views, const RenderOptions& options,
                              Workers& workers, Progress& progress, Statistics& statistics);
    /// Returns whether images need the vertices that were found in the last search.
    [[nodiscard]] bool found_for(const BakedImages& images) const;
    /// Returns whether the last update() left out vertices that no sample of the images was found to show.
    [[nodiscard]] bool left_out_unsampled() const;
    /// Hands the current bake to progressive_.
    void begin_progressively(const SceneGeometry& surfaces, const RenderOptions& options);
    /// Returns whether the bake of a part holds what images need.
    [[nodiscard]] bool is_enough(const NeededVertices& needed) const;
    /// Returns whether further views are baked one by one. Otherwise the next one bakes all that is left out.
    [[nodiscard]] bool grows() const;
    /// Bakes the vertices that a further view needs, and has the triangles that it shows refined.
    void grow(const SceneGeometry& surfaces, SurfaceRays& rays, const NeededVertices& needed,
              const RenderOptions& options, Workers& workers, Progress& progress, Statistics& statistics);
    /// Bakes some vertices, and adds them to the bake. `missing` holds their states then, see
    /// baked_vertices(). pixel: see vertices_in_pixels(); 0: none shares what it sees. shared: whether
    /// vertices that were baked as others in the same pixel before they became outdated remain so.
    void bake_missing(const SceneGeometry& surfaces, SurfaceRays& rays, double pixel, bool shared,
                      const RenderOptions& options, const BakeProgress& report,
                      std::vector<std::uint8_t>& missing, BakeStatistics& baked);
    /// Returns the state in needed_ that vertices which have become outdated have once they are baked again.
    /// Empty: none are outdated. shared: as for bake_missing().
    [[nodiscard]] std::vector<std::uint8_t> outdated(bool shared) const;
    /// Returns whether vertices and points that took what others in their pixel see keep it in images that
    /// need edges of this length.
    [[nodiscard]] bool shares(double edge) const;
    /// Returns the pixel in which vertices may share what they see in an image of some pixels, so that
    /// shares() stays true for images like those before.
    [[nodiscard]] double shared_pixel(double pixel) const;
    /// Takes over that images need edges of this length.
    void come_nearer(double edge);
    /// Has all triangles refined, however small edges are in images.
    void refine_all();
    /// Drops the points of the last refinement.
    void forget_points();
    /// Bakes surfaces that a change has left in part, from the former bake: the vertices that images need.
    /// The others become outdated. needed: of the surfaces; its flags are used up.
    [[nodiscard]] Visibility bake_carried(BakeGeometry geometry, const SceneGeometry& surfaces,
                                          NeededVertices& needed, const RenderOptions& options,
                                          const BakeProgress& report, BakeStatistics& baked);
    /// Bakes the surfaces before refinement. Returns whether the former bake was carried over.
    bool bake(const SceneGeometry& surfaces, SurfaceRays& rays, const BakedImages& images,
              const RenderOptions& options, Workers& workers, Progress& progress, Statistics& statistics);
    /// Returns the surfaces as a bake takes them, whose bakes and refinements share possible_blockers_.
    [[nodiscard]] BakeGeometry geometry_of(const SceneGeometry& surfaces, SurfaceRays& rays,
                                           std::span<const std::uint8_t> needed,
                                           const RenderOptions& options);
    /// Bakes the vertices of `more`, and returns their visibility with that of the others in baked_.
    /// outdated: of outdated().
    [[nodiscard]] Visibility with_more(BakeGeometry geometry, const SceneGeometry& surfaces,
                                       std::span<const std::uint8_t> more,
                                       std::span<const std::uint8_t> outdated, const BakeProgress& report,
                                       BakeStatistics& baked) const;
    /// Bakes the vertices that the bake of a part has left out.
    [[nodiscard]] Visibility bake_rest(const BakeGeometry& geometry, const SceneGeometry& surfaces,
                                       const BakeProgress& report, BakeStatistics& baked) const;
    /// Sets that all vertices are those of before_, in the same places.
    void keep_vertices(std::size_t vertices);
    void refine(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
                Workers& workers, Progress& progress, Statistics& statistics);
    /// Refines the surfaces, whose bake is `visible`; from the points of the former refinement if they
    /// follow.
    [[nodiscard]] Refinement refinement_of(const SceneGeometry& surfaces, const BakeGeometry& geometry,
                                           const Visibility& visible, const RenderOptions& options,
                                           const BakeProgress& report, BakeStatistics& baked) const;

    std::filesystem::path folder_;
    CacheNotice notice_;
    // Set once a render has had a budget. It then holds what the members below hold otherwise.
    std::unique_ptr<ProgressiveBake> progressive_;
    Stage<int> spreading_;
    std::optional<DirectionSet> lattice_;
    Stage<int, glm::dmat3> rotating_;
    std::optional<DirectionSet> directions_;                     // lattice_ along the surfaces' own axes
    Version axes_ = 0;                                           // version of directions_
    std::shared_ptr<const PossibleBlockers> possible_blockers_;  // of an update() that runs
    // Inputs: geometry, number of directions, their axes.
    Stage<Version, int, glm::dmat3> baking_;
    Versioned<std::shared_ptr<const Visibility>> baked_;
    Version baked_geometry_ = 0;         // version of the geometry that baked_ belongs to
    Version carried_ = 0;                // version of the bake that baked_ was made from; 0: none
    Stage<Version, Version> seeing_;     // inputs: geometry, materials
    NeededVertices seen_;                // needed_vertices() of the last views that were searched
    std::vector<Projection> seen_from_;  // views of that search
    std::vector<glm::dvec2> seen_at_;    // and its samples
    // 0: not baked; 1: baked as the vertex in the same pixel; kTraced: baked by rays of its own; by vertex of
    // baked_. Empty: all are kTraced. And the same of the vertices of surfaces_.
    std::vector<std::uint8_t> needed_, baked_vertices_;
    // State in needed_, by vertex of baked_, before changes of the scene that the vertex has not followed
    // because no image needs it; 0: none. needed_ is 0 for such vertices. Empty: there are none.
    std::vector<std::uint8_t> outdated_;
    DisturbanceRecord since_outdated_;  // disturbances since the first of these changes
    double shortest_edge_ = 0;          // RefineOptions::shortest_edge of the bake of a part; 0: of all
    double traced_edge_ = 0;            // shortest_edge_ when its points were traced
    std::vector<std::uint8_t> wanted_;  // RefineOptions::wanted of the bake of a part
    bool grew_ = false;                 // whether the last update() called grow()
    std::size_t views_since_ = 0;       // views that were searched since the first one of a part
    // Inputs: bake, tolerance, largest number of vertices, whether unoccluded vertices count as occluded,
    // shortest edge.
    Stage<Version, double, std::uint64_t, bool, double> refining_;
    TracedPoints points_;                                   // of the last refinement
    Version points_bake_ = 0;                               // version of the bake that points_ belong to
    Refinement topology_;                                   // the refinement without visibility and points
    std::shared_ptr<WorldGeometry> refined_;                // null: no triangle was split
    std::vector<TrianglePart> parts_;                       // triangles of refined_
    VertexNumbers numbers_;                                 // numbers of its vertices
    Versioned<std::shared_ptr<const Visibility>> visible_;  // visibility of the vertices of surfaces_
    ShownVisibility shown_;                                 // of visible_
    RefinedSurfaces surfaces_;
    bool uses_bake_ = false;  // whether the last update() ended with the bake in the members above

    SurfaceVersions versions_;
    std::optional<SurfaceVersions> before_;  // versions that former_ refers to
    std::vector<std::uint32_t> former_;
    std::vector<std::uint8_t> same_places_, same_normals_;
};

}  // namespace nicol
