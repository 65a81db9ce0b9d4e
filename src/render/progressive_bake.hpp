// SPDX-License-Identifier: MIT
// A bake in slices of time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/used_normals.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "surfaces/given_origins.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_rays.hpp"
#include "visibility/disturbance_record.hpp"
#include "visibility/stepwise_refinement.hpp"

namespace nicol {

/// Visibility of a scene's vertices that improves by slices of time, and in the end equals that of bake() and
/// refine(). Until a vertex is traced again, it keeps its former visibility; a moved object's own shadow
/// moves with it, and a vertex without former visibility is unoccluded. The former refinement is kept until
/// all vertices are traced, and is then replaced.
class ProgressiveBake {
public:
    struct Input {
        const SceneGeometry& surfaces;
        const DirectionSet& directions;
        Version axes;  ///< version of the directions
        const RenderOptions& options;
        std::span<const Projection> views;  ///< of the surfaces' axes
    };
    /// A bake of the surfaces' version `surfaces`.
    struct Baked {
        Version surfaces;
        Version axes;
        std::size_t given;  ///< number of vertices before refinement
        Refinement topology;
        Visibility visibility;
        std::shared_ptr<WorldGeometry> refined;
        std::vector<TrianglePart> parts;
        VertexNumbers numbers;
        TracedPoints points;
        bool fine;         ///< whether the refinement had no RefineOptions::shortest_edge
        double tolerance;  ///< RenderOptions::refine_tolerance
        std::uint64_t most_vertices;
        /// 1 for each vertex that was baked since the last change; others have what they saw before, or
        /// count as unoccluded if they were never baked. Empty: all were.
        std::vector<std::uint8_t> baked;
        std::span<const glm::vec3> normals;  ///< normals of the vertices
        /// 1 for each vertex whose last light belongs to another visibility. Empty: there are none.
        std::span<const std::uint8_t> lagging;
    };

    /// Begins with a bake. Vertices that it has left out are pending, and so is the refinement then.
    void begin(Baked given);
    /// Takes over changes of the surfaces, directions or options. Work that they affect is pending then.
    void follow(const Input& input);
    /// Works for about `milliseconds`, which include those that later steps take for changed vertices; at
    /// least one step. rays: of the surfaces.
    void advance(const Input& input, SurfaceRays& rays, double milliseconds, Workers& workers,
                 Progress& progress, BakeStatistics& statistics);
    /// Tells how long later steps took for the vertices that the last advance() changed.
    void count_later_steps(double milliseconds);

    /// Returns the number of vertices whose visibility is not final; at least 1 until the refinement is.
    [[nodiscard]] std::size_t pending() const noexcept { return pending_ + (finished_ ? 0 : 1); }
    [[nodiscard]] const Visibility& visibility() const noexcept { return visible_; }
    [[nodiscard]] const std::shared_ptr<WorldGeometry>& refined() const noexcept { return refined_; }
    [[nodiscard]] std::span<const TrianglePart> parts() const noexcept { return parts_; }
    [[nodiscard]] std::span<const std::uint32_t> numbers() const noexcept { return numbers_.numbers; }
    [[nodiscard]] std::size_t bytes() const noexcept { return visible_.bytes() + points_.bytes(); }

    /// Returns, for each vertex, the index before follow() and advance() of a vertex with equal visibility,
    /// or kNoVertex. Visibility also counts as equal if it has turned a little with the vertex's normal,
    /// until it is traced.
    [[nodiscard]] std::span<const std::uint32_t> former() const noexcept { return former_; }
    /// Returns 0 for each vertex of an object that has deformed since then, with whose normal its visibility
    /// has turned, else 1.
    [[nodiscard]] std::span<const std::uint8_t> same_normals() const noexcept { return same_normals_; }
    [[nodiscard]] bool any_changed() const noexcept { return any_changed_; }
    /// Must be called once the caller has taken over former(). Otherwise, after an exception, all vertices
    /// count as changed in the next follow().
    void published() noexcept { unpublished_ = false; }

private:
    void follow_geometry(const Input& input);
    void take_over(const Input& input, std::span<const std::uint32_t> former,
                   std::span<const std::uint32_t> moved, const VertexNumbers& numbers_before);
    // Splits triangles as a refinement says. Returns the visibility of the vertices.
    Visibility split(const WorldGeometry& geometry, const Refinement& refinement);
    [[nodiscard]] const WorldGeometry& geometry(const Input& input) const {
        return refined_ ? *refined_ : input.surfaces.geometry();
    }
    void find_order(const Input& input);
    void find_origins(const Input& input);
    void trace(const Input& input, std::span<const std::uint32_t> vertices, const DisturbedRays& since_last,
               const DisturbedRays& since_all, BakeStatistics& statistics);
    void begin_refinement(const Input& input);
    void end_refinement(const Input& input, Refinement next);
    void finish(const Input& input);

    Version surfaces_ = 0;
    Version axes_ = 0;
    double tolerance_ = 0;
    std::uint64_t most_vertices_ = 0;
    std::size_t given_ = 0;
    Refinement topology_;  // without visibility and points
    std::shared_ptr<WorldGeometry> refined_;
    std::vector<TrianglePart> parts_;
    VertexNumbers numbers_;

    Visibility visible_;
    // By vertex: the state of the scene that its visibility belongs to; 0: none. state_ is the current one.
    std::vector<std::uint32_t> states_;
    std::uint32_t state_ = 1;
    std::vector<std::uint8_t> receivers_;           // receivers_of() the vertices
    std::vector<std::uint8_t> refining_receivers_;  // receivers_of() what refinement_ uses
    std::vector<std::uint8_t> waits_;  // by vertex: changes since it was traced, up to kLongestWait
    // A vertex that counts as occluded does so until the end, because blocks of unoccluded vertices are kept
    // apart in later steps.
    std::vector<std::uint8_t> unoccluded_;
    DisturbanceRecord last_;        // disturbances from the state before the current one
    DisturbanceRecord all_;         // disturbances since all vertices were traced
    DisturbanceRecord for_points_;  // disturbances since points_
    TracedPoints points_;
    GivenOrigins given_origins_;
    std::vector<glm::vec3> origins_;    // empty: not yet found
    std::vector<std::uint32_t> order_;  // blocks of sixteen vertices, those to be traced first first
    std::size_t next_ = 0;              // place in order_
    std::size_t pending_ = 0;
    bool finished_ = false;

    BakeRays rays_;                                  // null: not yet needed
    std::shared_ptr<const WorldGeometry> refining_;  // geometry and visibility that refinement_ uses
    Visibility refining_visibility_;
    std::unique_ptr<FormerRefinement> former_points_;
    std::unique_ptr<StepwiseRefinement> refinement_;

    std::vector<std::uint8_t> lagging_;  // Baked::lagging, until the first follow()
    std::vector<std::uint32_t> former_;
    std::vector<std::uint8_t> same_normals_;  // see same_normals()
    UsedNormals used_normals_;
    bool any_changed_ = false;
    bool unpublished_ = false;
    std::size_t changed_ = 0;  // vertices that the last advance() changed
    double later_ms_ = 0.03;   // time that later steps take for a changed vertex
};

}  // namespace nicol
