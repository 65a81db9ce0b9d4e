// SPDX-License-Identifier: MIT
// Paths of light from the camera backwards: each surface on a path reflects, or transmits, light of the
// scene's lights and of the next surface.
#pragma once

#include <cstdint>
#include <span>

#include "polarization/mueller.hpp"
#include "reference/low_discrepancy.hpp"
#include "reference/path_vertex.hpp"
#include "reference/scene_lights.hpp"
#include "reference/traced_scene.hpp"

namespace nicol {

/// Estimator of the light that reaches the camera along rays. Immutable; threads share it.
class PathTracer {
public:
    /// Keeps references to both arguments. max_depth: largest number of ray segments from the camera to a
    /// light, as in Mitsuba: 1 is light that the camera sees directly, 2 adds light that is reflected once.
    PathTracer(const TracedScene& scene, const SceneLights& lights, int max_depth);

    /// First stream of the points that add() takes; add() uses later streams, too.
    static constexpr std::uint32_t kFirstStream = 1;
    /// Adds, for each channel, an estimate of the Stokes vector of the light that travels against the ray, in
    /// the frame `received`, whose z is -ray.direction. The points of this index choose the path. Returns
    /// whether the ray meets a surface.
    bool add(const Ray& ray, const Frame& received, const LowDiscrepancy& points, std::uint32_t index,
             std::span<Stokes> sum, PathWorkspace& workspace) const;

private:
    void begin(const Ray& ray, const Frame& received, std::size_t channels, PathWorkspace& workspace) const;
    /// End of a path that has met a surface.
    struct Path {
        RayHit found;
        glm::dvec3 direction;       ///< direction of the ray that has met the surface
        Frame received;             ///< frame of the light that travels against the ray
        double radiance_scale = 1;  ///< product of BoundaryEvent::radiance_scale
        bool seen = true;           ///< whether the camera sees the surface, directly or through smooth ones
    };
    /// Points that choose what happens at one vertex.
    struct VertexPoints {
        const LowDiscrepancy& points;
        std::uint32_t index;
        std::uint32_t first_stream;

        [[nodiscard]] glm::dvec2 at(std::uint32_t stream) const {
            return points.point(index, first_stream + stream);
        }
    };

    /// Adds the light that surfaces reflect or transmit along a path that has met its first surface.
    void follow(Path path, const LowDiscrepancy& points, std::uint32_t index, std::span<Stokes> sum,
                PathWorkspace& workspace) const;
    /// Adds the light that a surface reflects, and moves the path to the next surface. Returns false if the
    /// path ends. last: whether the path ends in any case.
    bool scatter(Path& path, const SurfaceHit& hit, const VertexPoints& points, bool last,
                 std::span<Stokes> sum, PathWorkspace& workspace) const;
    /// Adds the light that a mirror reflects, and moves the path to the next surface. Returns false if the
    /// path ends.
    bool mirror(Path& path, const PathVertex& vertex, std::span<Stokes> sum) const;
    /// Adds the light that a smooth boundary reflects or transmits, and moves the path to the next surface.
    /// Returns false if the path ends.
    bool pass(Path& path, const SmoothBoundary& boundary, const SurfaceHit& hit, const VertexPoints& points,
              std::span<Stokes> sum, PathWorkspace& workspace) const;

    const TracedScene& scene_;
    const SceneLights& lights_;
    int max_depth_;
};

}  // namespace nicol
